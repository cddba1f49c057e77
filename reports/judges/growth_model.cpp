// Judge "growth-model": which law of growth describes a count best, the claimed one or a rival?
//
// The rule's counters are summed per run and averaged per N; the rival laws of bench/statistics.hpp are
// fitted to these averages with relative residuals and compared by AICc. For a quantity per site (rule: shape
// = "depth") the depth laws stand in the place of the totals. reproduced: the claimed law is best and the
// next one worse by at least `margin`; refuted: a rival is better by at least `margin`; inconclusive:
// neither. A margin of 6 is odds of e^3 = 20 to 1 (Burnham and Anderson 2002). Fewer than 6 sizes carry no
// verdict. Rows that measure time are shown beside the counts and never judged: caches bend them.
#include "reports/judges/evidence.hpp"
#include "reports/judges/listed.hpp"
#include "reports/text.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace tribunal::reports {
namespace {

constexpr std::size_t fewest_sizes = 6;
constexpr std::size_t shown_laws = 4;  // more curves than these hide one another

struct Averages {
  std::vector<double> sizes;
  std::vector<double> counts;
};

Averages averages(const std::vector<std::string>& counters, Rows rows) {
  Averages result;
  for (const auto& [n, group] : by_size(rows)) {
    std::vector<double> sums;
    for (const bench::Row& row : group) {
      if (row.cell.measure == bench::Measure::time) continue;
      double sum = 0;
      for (const std::string& name : counters) sum += counter(row, name);
      sums.push_back(sum);
    }
    if (sums.empty()) continue;
    result.sizes.push_back(static_cast<double>(n));
    result.counts.push_back(bench::summarise(sums).mean);
  }
  if (result.sizes.size() < fewest_sizes)
    throw Incomplete("only " + std::to_string(result.sizes.size()) +
                     " sizes: too few to tell the laws apart");
  if (std::any_of(result.counts.begin(), result.counts.end(), [](double c) { return !(c > 0); }))
    throw Incomplete("a count is not positive: relative residuals mean nothing");
  return result;
}

std::string fit_line(const bench::GrowthFit& fit, double best) {
  const auto largest = std::max_element(fit.residuals.begin(), fit.residuals.end(),
                                        [](double a, double b) { return std::abs(a) < std::abs(b); });
  return std::string(fit.model->name) + ": AICc + " + fixed_text(fit.aicc - best, 1) + ", largest residual " +
         percent_text(std::abs(*largest)) + ", leading coefficient " + number_text(fit.leading, 4);
}

/// Counts per leading term's N, or as they are for depths: what bends is then seen by eye.
Figure scaling_figure(const Averages& data, const std::vector<bench::GrowthFit>& fits, bool depth) {
  const auto scaled = [&](double n, double value) { return datum(n, depth ? value : value / n); };
  Figure figure{depth ? "Depth against the rival laws" : "Count per site against the rival laws",
                {"N", true},
                {depth ? "depth" : "count / N"},
                {}};
  Series measured{"measured", Mark::points, {}};
  for (std::size_t i = 0; i < data.sizes.size(); ++i)
    measured.data.push_back(scaled(data.sizes[i], data.counts[i]));
  figure.series.push_back(std::move(measured));
  for (std::size_t k = 0; k < std::min(shown_laws, fits.size()); ++k) {
    Series curve{std::string(fits[k].model->name), k == 0 ? Mark::line : Mark::dashed, {}};
    constexpr int steps = 40;
    const double ratio = data.sizes.back() / data.sizes.front();
    for (int s = 0; s <= steps; ++s) {
      const double n = data.sizes.front() * std::pow(ratio, static_cast<double>(s) / steps);
      curve.data.push_back(scaled(n, fits[k].at(n)));
    }
    figure.series.push_back(std::move(curve));
  }
  return figure;
}

Figure residual_figure(const Averages& data, const std::vector<bench::GrowthFit>& fits) {
  Figure figure{"Relative residuals of the best laws", {"N", true}, {"(count - fit) / count"}, {}};
  Series none{
      "no residual", Mark::dashed, {}};  // first, so that a law has the same colour as in the other chart
  for (const double n : data.sizes) none.data.push_back(datum(n, 0));
  figure.series.push_back(std::move(none));
  for (std::size_t k = 0; k < std::min(shown_laws, fits.size()); ++k) {
    Series series{std::string(fits[k].model->name), Mark::points, {}};
    for (std::size_t i = 0; i < data.sizes.size(); ++i)
      series.data.push_back(datum(data.sizes[i], fits[k].residuals[i]));
    figure.series.push_back(std::move(series));
  }
  return figure;
}

void show_times(Rows rows, Judgement& judgement) {
  Series times{"time", Mark::points, {}};
  std::string line;
  for (const auto& [n, group] : by_size(rows)) {
    std::vector<double> seconds;
    for (const bench::Row& row : group) seconds.insert(seconds.end(), row.seconds.begin(), row.seconds.end());
    if (seconds.empty()) continue;
    const auto size = static_cast<double>(n);
    const double middle = bench::median(seconds);
    const bench::Interval spread = bench::bootstrap_median(seconds, 1);
    constexpr double nano = 1e9;
    times.data.push_back({size, nano * middle / size, nano * spread.low / size, nano * spread.high / size});
    line += (line.empty() ? "" : ", ") + fixed_text(nano * middle / size, 0) + " at N = " + number_text(size);
  }
  if (times.data.empty()) return;
  judgement.lines.push_back("Time, shown and not judged, nanoseconds per site: " + line + ".");
  judgement.figures.push_back(
      {"Time per site, median with 95 % interval (not judged)", {"N", true}, {"ns / N"}, {times}});
}

Judgement judge(const Rule& rule, Rows rows) {
  require_finished(rows);
  const bool depth = text(rule, "shape", "total") == "depth";
  const std::string claimed = text(rule, "law", "");
  const double margin = number(rule, "margin", 6);
  const Averages data = averages(texts(rule, "counters"), rows);
  const auto fits =
      bench::fit_growth(depth ? bench::depth_models() : bench::growth_models(), data.sizes, data.counts);
  const auto own =
      std::find_if(fits.begin(), fits.end(), [&](const auto& fit) { return fit.model->name == claimed; });
  if (own == fits.end()) throw Incomplete("no law is named \"" + claimed + "\"");
  const double rival = own == fits.begin() ? fits[1].aicc : fits[0].aicc;
  const double lead = rival - own->aicc;  // positive: the claimed law is ahead
  Judgement judgement;
  judgement.quantity = "AICc of the best rival minus that of " + claimed;
  judgement.measured = lead;
  judgement.bound = margin;
  judgement.verdict = lead >= margin    ? Verdict::reproduced
                      : lead <= -margin ? Verdict::refuted
                                        : Verdict::inconclusive;
  for (const bench::GrowthFit& fit : fits) judgement.lines.push_back(fit_line(fit, fits[0].aicc));
  if (depth) {
    std::vector<double> logs;
    for (const double n : data.sizes) logs.push_back(std::log(n));
    const bench::AffineFit affine = bench::fit_affine(logs, data.counts);
    judgement.lines.push_back(
        "Affine in ln N: " + fixed_text(affine.slope, 3) + " ln N " + (affine.intercept < 0 ? "- " : "+ ") +
        fixed_text(std::abs(affine.intercept), 2) + ", R^2 = " + fixed_text(affine.r_squared, 5));
  }
  judgement.lines.push_back("Power: laws whose best fits differ by less than the residuals above over N = " +
                            number_text(data.sizes.front()) + " .. " + number_text(data.sizes.back()) +
                            " cannot be told apart; the next one stands " + fixed_text(std::abs(lead), 1) +
                            " away where " + number_text(margin) + " decides.");
  judgement.figures.push_back(scaling_figure(data, fits, depth));
  judgement.figures.push_back(residual_figure(data, fits));
  show_times(rows, judgement);
  return judgement;
}

constexpr std::array<Parameter, 4> parameters{{{"law", ParameterKind::text, true},
                                               {"counters", ParameterKind::texts, true},
                                               {"shape", ParameterKind::text, false},
                                               {"margin", ParameterKind::number, false}}};

}  // namespace

constinit const Judge growth_model_judge{"growth-model", "which law of growth describes a count best",
                                         parameters, judge};

}  // namespace tribunal::reports
