#include "bench/statistics.hpp"
#include "reports/judges/bounds.hpp"
#include "reports/outcome_kind.hpp"
#include "reports/page/chart.hpp"
#include "reports/page/sections.hpp"
#include "reports/page/triangulations.hpp"

#include <algorithm>
#include <map>
#include <set>

namespace tribunal::reports {
namespace {

/// tau by name of the series, then by N.
using Groups = std::map<std::string, std::map<std::uint64_t, std::vector<double>>>;

constexpr std::size_t most_series = 7;

/// Those with the most sizes and runs, so that a chart stays readable.
std::vector<std::string> largest(const Groups& groups) {
  const auto weight = [&](const std::string& name) {
    std::size_t runs = 0;
    for (const auto& [n, taus] : groups.at(name)) runs += taus.size();
    return std::pair(groups.at(name).size(), runs);
  };
  std::vector<std::string> names;
  for (const auto& [name, sizes] : groups) names.push_back(name);
  std::stable_sort(names.begin(), names.end(),
                   [&](const auto& a, const auto& b) { return weight(a) > weight(b); });
  names.resize(std::min(names.size(), most_series));
  std::sort(names.begin(), names.end());
  return names;
}

/// A backend that fails anywhere may also end well by luck, with a tau that no right signs give.
std::set<std::string> backends_that_failed(const std::vector<const bench::Row*>& runs) {
  std::set<std::string> backends;
  for (const bench::Row* row : runs)
    if (outcome_kind(row->outcome) == OutcomeKind::failed) backends.insert(row->cell.backend);
  return backends;
}

Series bound_series(const Groups& groups) {
  std::uint64_t low = UINT64_MAX;
  std::uint64_t high = 0;
  for (const auto& [name, sizes] : groups) {
    low = std::min(low, sizes.begin()->first);
    high = std::max(high, sizes.rbegin()->first);
  }
  Series series{"6 - (15 H_N - 21/2)/N", Mark::dashed, {}};
  const Bound* bound = find_bound("tau");
  for (std::uint64_t n = std::max<std::uint64_t>(low, 3); n < high; n += std::max<std::uint64_t>(1, n / 5))
    series.data.push_back(datum(static_cast<double>(n), bound->at(n) / static_cast<double>(n)));
  series.data.push_back(datum(static_cast<double>(high), bound->at(high) / static_cast<double>(high)));
  return series;
}

Figure ratio_figure(const std::string& title, const Groups& groups) {
  Figure figure{title, {"N", true}, {"tau / N"}, {}};
  for (const std::string& name : largest(groups)) {
    Series series{name, Mark::points, {}};
    for (const auto& [n, taus] : groups.at(name)) {
      const bench::Summary summary = bench::summarise(taus);
      const auto size = static_cast<double>(n);
      const double half = 3 * summary.standard_error;
      series.data.push_back(
          {size, summary.mean / size, (summary.mean - half) / size, (summary.mean + half) / size});
    }
    figure.series.push_back(std::move(series));
  }
  figure.series.push_back(bound_series(groups));
  return figure;
}

}  // namespace

std::string tau_section(const ReportInput& input) {
  Groups by_dataset;
  Groups by_order;
  const std::vector<const bench::Row*> runs = triangulations(input.rows);
  const std::set<std::string> fallible = backends_that_failed(runs);
  for (const bench::Row* row : runs) {
    if (fallible.contains(row->cell.backend)) continue;
    const auto tau = row->counters.find("tau");
    const auto dimension = row->counters.find("dimension");
    if (row->outcome != "ok" || tau == row->counters.end() || dimension == row->counters.end()) continue;
    if (dimension->second < 2 || row->cell.n < 3) continue;
    if (row->cell.order == "random") by_dataset[row->cell.dataset][row->cell.n].push_back(tau->second);
    if (row->cell.dataset == "uniform")
      by_order[row->cell.order + " order"][row->cell.n].push_back(tau->second);
  }
  std::string html =
      "<section aria-labelledby=\"tau\"><h2 id=\"tau\">Triangles that arise</h2><p>tau counts the Delaunay "
      "triangles incident to each new site when it is inserted. Points are means, with three standard "
      "errors, "
      "over runs with backends that failed nowhere; the dashed line is the bound on the expectation under a "
      "random order, eq. (3.3.0).</p>\n<div class=\"pair\">";
  if (by_dataset.empty() && by_order.empty())
    return html + "</div><p class=\"absent\">No run reported tau.</p></section>\n";
  if (!by_dataset.empty()) html += chart(ratio_figure("tau / N by dataset, random order", by_dataset));
  if (by_order.size() > 1) html += chart(ratio_figure("tau / N by insertion order, uniform sites", by_order));
  return html + "</div></section>\n";
}

}  // namespace tribunal::reports
