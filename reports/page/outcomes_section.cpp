#include "reports/html.hpp"
#include "reports/outcome_kind.hpp"
#include "reports/page/sections.hpp"
#include "reports/page/triangulations.hpp"
#include "reports/text.hpp"

#include <algorithm>
#include <array>
#include <map>

namespace tribunal::reports {
namespace {

struct Cell {
  std::array<std::uint64_t, 4> kinds{};
  std::map<std::string, std::uint64_t> outcomes;
  std::uint64_t runs = 0;

  void add(const std::string& outcome) {
    ++kinds[static_cast<std::size_t>(outcome_kind(outcome))];
    ++outcomes[outcome];
    ++runs;
  }
  [[nodiscard]] std::uint64_t count(OutcomeKind kind) const { return kinds[static_cast<std::size_t>(kind)]; }
};

/// The shares as one bar; the numbers below it say the same to those who do not see it.
std::string bar(const Cell& cell) {
  constexpr std::array<const char*, 4> classes{"good", "failed", "refused", "unfinished"};
  std::string html =
      "<svg class=\"bar\" viewBox=\"0 0 100 6\" preserveAspectRatio=\"none\" aria-hidden=\"true\">";
  double from = 0;
  for (std::size_t i = 0; i < classes.size(); ++i) {
    if (cell.kinds[i] == 0) continue;
    // A share too small to be seen is given a hair's breadth: one failure in ten thousand is still a failure.
    const double share =
        std::max(1.5, 100 * static_cast<double>(cell.kinds[i]) / static_cast<double>(cell.runs));
    html += "<rect class=\"" + std::string(classes[i]) + "\" x=\"" + fixed_text(from, 2) + "\" width=\"" +
            fixed_text(share, 2) + "\" height=\"6\"/>";
    from += share;
  }
  return html + "</svg>";
}

std::string cell_html(const Cell& cell) {
  if (cell.runs == 0) return "<td class=\"empty\">&#8211;</td>";
  const std::uint64_t failed = cell.count(OutcomeKind::failed);
  std::string html =
      std::string("<td class=\"") + (failed > 0 ? "has-failures" : "clean") + "\">" + bar(cell);
  html += failed > 0
              ? "<strong>" + std::to_string(failed) + " failed</strong> of " + std::to_string(cell.runs)
              : "<strong>0 failed</strong> of " + std::to_string(cell.runs);
  html += "<ul class=\"outcomes\">";
  for (const auto& [outcome, count] : cell.outcomes)
    if (outcome != "ok") html += "<li>" + escape(outcome) + " " + std::to_string(count) + "</li>";
  return html + "</ul></td>";
}

}  // namespace

std::string outcomes_section(const ReportInput& input) {
  const std::vector<const bench::Row*> runs = triangulations(input.rows);
  std::vector<std::string> algorithms;
  std::vector<std::string> backends;
  std::map<std::pair<std::string, std::string>, Cell> cells;
  const auto note = [](std::vector<std::string>& names, const std::string& name) {
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  };
  for (const bench::Row* row : runs) {
    note(algorithms, row->cell.task);
    note(backends, row->cell.backend);
    cells[{row->cell.backend, row->cell.task}].add(row->outcome);
  }
  std::string html =
      "<section aria-labelledby=\"outcomes\"><h2 id=\"outcomes\">Outcomes</h2><p>How runs ended, by backend "
      "and "
      "algorithm, every result checked exactly. <em>Failed</em> is a wrong or inconsistent result, a loop or "
      "a crash; "
      "refusals are answers outside a backend's domain and no failures.</p>\n";
  if (runs.empty()) return html + "<p class=\"absent\">No triangulation was run.</p></section>\n";
  html += "<div class=\"scroll\"><table class=\"matrix\"><thead><tr><th scope=\"col\">backend</th>";
  for (const std::string& algorithm : algorithms) html += "<th scope=\"col\">" + escape(algorithm) + "</th>";
  html += "</tr></thead><tbody>\n";
  for (const std::string& backend : backends) {
    html += "<tr><th scope=\"row\">" + escape(backend) + "</th>";
    for (const std::string& algorithm : algorithms) html += cell_html(cells[{backend, algorithm}]);
    html += "</tr>\n";
  }
  return html +
         "</tbody></table></div><ul class=\"legend\"><li><span class=\"chip good\"></span>ok</li><li><span "
         "class=\"chip "
         "failed\"></span>failed</li><li><span class=\"chip refused\"></span>refused</li><li><span "
         "class=\"chip "
         "unfinished\"></span>out of time or memory</li></ul></section>\n";
}

}  // namespace tribunal::reports
