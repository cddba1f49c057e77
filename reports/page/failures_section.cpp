#include "reports/html.hpp"
#include "reports/outcome_kind.hpp"
#include "reports/page/sections.hpp"

#include <algorithm>
#include <map>
#include <tuple>

namespace tribunal::reports {
namespace {

constexpr std::size_t most_lines = 200;

/// Rows that ended alike, and the smallest of them as the example.
struct Kind {
  std::uint64_t count = 0;
  const bench::Row* example = nullptr;

  void add(const bench::Row& row) {
    ++count;
    if (example == nullptr || std::tuple(row.cell.n, row.key) < std::tuple(example->cell.n, example->key))
      example = &row;
  }
};

std::string line(const Kind& kind) {
  const bench::Row& row = *kind.example;
  const std::string text = std::to_string(kind.count);
  return "<tr><td>" + escape(row.cell.backend) + "</td><td>" + escape(row.cell.task) + "</td><td>" +
         escape(row.cell.dataset) + "</td><td>" + escape(row.outcome) + "</td><td class=\"number\">" + text +
         "</td><td class=\"example\">N = " + std::to_string(row.cell.n) + (row.reason.empty() ? "" : ": ") +
         escape(row.reason) + "<details><summary>command</summary><code>" + escape(row.command) +
         "</code></details></td></tr>\n";
}

}  // namespace

std::string failures_section(const ReportInput& input) {
  std::map<std::tuple<std::string, std::string, std::string, std::string>, Kind> kinds;
  std::uint64_t total = 0;
  for (const bench::Row& row : input.rows) {
    if (row.outcome == "ok") continue;
    ++total;
    kinds[{row.cell.backend, row.cell.task, row.cell.dataset, row.outcome}].add(row);
  }
  std::string html = "<section aria-labelledby=\"failures\"><h2 id=\"failures\">Failures and refusals</h2>";
  if (kinds.empty()) return html + "<p class=\"absent\">Every run ended ok.</p></section>\n";
  std::vector<const Kind*> sorted;
  sorted.reserve(kinds.size());
  for (const auto& [key, kind] : kinds) sorted.push_back(&kind);
  // Failures before refusals, then by number.
  const auto rank = [](const Kind* kind) {
    return std::tuple(outcome_kind(kind->example->outcome) != OutcomeKind::failed, UINT64_MAX - kind->count);
  };
  std::stable_sort(sorted.begin(), sorted.end(),
                   [&](const Kind* a, const Kind* b) { return rank(a) < rank(b); });
  html +=
      "<p>" + std::to_string(total) + " of " + std::to_string(input.rows.size()) +
      " runs did not end ok, in " + std::to_string(kinds.size()) +
      " kinds; the smallest of each kind is its example.</p>\n<div class=\"scroll\">"
      "<table class=\"sortable\"><thead><tr><th scope=\"col\">backend</th><th scope=\"col\">algorithm</th>"
      "<th scope=\"col\">dataset</th><th scope=\"col\">outcome</th><th scope=\"col\" "
      "class=\"number\">runs</th>"
      "<th scope=\"col\">example</th></tr></thead><tbody>\n";
  for (std::size_t i = 0; i < std::min(most_lines, sorted.size()); ++i) html += line(*sorted[i]);
  html += "</tbody></table></div>";
  if (sorted.size() > most_lines)
    html += "<p>" + std::to_string(sorted.size() - most_lines) +
            " rarer kinds are left out here; the rows hold them.</p>";
  return html + "</section>\n";
}

}  // namespace tribunal::reports
