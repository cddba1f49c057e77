#include "bench/statistics.hpp"
#include "reports/html.hpp"
#include "reports/page/sections.hpp"
#include "reports/text.hpp"

#include <map>
#include <set>
#include <string>
#include <vector>

namespace tribunal::reports {
namespace {

/// Three significant digits, never an exponent.
std::string nanoseconds_text(double value) {
  return fixed_text(value, value < 9.995 ? 2 : value < 99.95 ? 1 : 0);
}

/// What the rows of one backend and family say, pooled over seeds.
struct Timing {
  double queries = 0, wrong = 0;
  std::vector<double> nanoseconds;  ///< per query

  void add(const bench::Row& row) {
    const auto count = [&](const char* name) {
      const auto found = row.counters.find(name);
      return found == row.counters.end() ? 0 : found->second;
    };
    const double asked = count("queries");
    if (row.outcome != "ok" || !(asked > 0)) return;
    queries += asked;
    wrong += count("wrong");
    for (const double seconds : row.seconds) nanoseconds.push_back(seconds * 1e9 / asked);
  }

  std::string html() const {
    if (queries == 0) return "<td class=\"absent\">refused</td>";
    if (wrong > 0) return "<td class=\"number\">!" + number_text(wrong / queries, 2) + "</td>";
    if (nanoseconds.empty()) return "<td class=\"absent\">not timed</td>";
    return "<td class=\"number\">" + nanoseconds_text(bench::median(nanoseconds)) + "</td>";
  }
};

struct Table {
  std::set<std::string> backends, families;
  std::map<std::pair<std::string, std::string>, Timing> timings;  ///< by backend and family
};

std::string parameter(const bench::Row& row, const char* name) {
  const auto found = row.cell.parameters.find(name);
  return found == row.cell.parameters.end() ? "" : found->second;
}

std::string table_html(const std::string& predicate, const Table& table) {
  std::string html =
      "<h3>" + escape(predicate) +
      "</h3><div class=\"scroll\"><table class=\"sortable\"><thead><tr><th scope=\"col\">backend</th>";
  for (const std::string& family : table.families)
    html += "<th scope=\"col\" class=\"number\">" + escape(family) + "</th>";
  html += "</tr></thead><tbody>\n";
  for (const std::string& backend : table.backends) {
    html += "<tr><td>" + escape(backend) + "</td>";
    for (const std::string& family : table.families) {
      const auto found = table.timings.find({backend, family});
      html += found == table.timings.end() ? "<td></td>" : found->second.html();
    }
    html += "</tr>\n";
  }
  return html + "</tbody></table></div>\n";
}

}  // namespace

std::string predicate_timings_section(const ReportInput& input) {
  std::map<std::string, Table> tables;  // by predicate
  for (const bench::Row& row : input.rows) {
    if (row.cell.task != "predicate-timing") continue;
    Table& table = tables[parameter(row, "predicate")];
    const std::string family = parameter(row, "family");
    table.backends.insert(row.cell.backend);
    table.families.insert(family);
    table.timings[{row.cell.backend, family}].add(row);
  }
  std::string html =
      "<section aria-labelledby=\"timings\"><h2 id=\"timings\">Predicate timings</h2><p>Nanoseconds per "
      "query, "
      "median, by "
      "family of queries. Where signs were wrong, ! and their share stand instead: a wrong result has no "
      "time.</p>\n";
  if (tables.empty()) return html + "<p class=\"absent\">No predicate was timed.</p></section>\n";
  for (const auto& [predicate, table] : tables) html += table_html(predicate, table);
  return html + "</section>\n";
}

}  // namespace tribunal::reports
