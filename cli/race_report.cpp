#include "cli/race_report.hpp"

#include "bench/manifest.hpp"
#include "bench/whole/goals.hpp"
#include "cli/bench_document.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <ostream>

namespace tribunal::cli {
namespace {
using bench::Figure;
using bench::RaceGoal;
using bench::RaceKind;
using bench::Standing;
using nlohmann::json;

/// Meshes of one graph without new vertices have all the same number of triangles.
std::span<const Figure> figures_of(RaceKind kind) {
  static constexpr std::array all{Figure::time, Figure::triangles};
  return std::span(all).first(kind == RaceKind::refinement ? 2 : 1);
}

/// The dataset, its size and the kind of race, the same for times and ratios.
json course_document(const bench::Course& course, std::uint64_t n) {
  json document{{"dataset", course.dataset}, {"n", n}, {"kind", to_string(course.kind)}};
  if (course.kind != RaceKind::refinement) return document;
  document["angle"] = course.bounds.degrees();
  document["longest_edge"] = nullptr;
  if (std::isfinite(course.bounds.longest_edge)) document["longest_edge"] = course.bounds.longest_edge;
  return document;
}

json standing_document(const Standing& standing) {
  json document = course_document(standing.course, standing.n);
  document["contestant"] = standing.contestant;
  document["outcome"] = outcome_of(standing);
  if (standing.seconds.empty()) {
    document["reason"] = standing.ruling.reason;
    return document;
  }
  const bench::Interval interval = bench::bootstrap_median(standing.seconds, 1);
  document["seconds"] = bench::median(standing.seconds);
  document["interval"] = {interval.low, interval.high};
  document["vertices"] = standing.vertices;
  document["triangles"] = standing.triangles;
  return document;
}

json comparison_document(const Comparison& comparison) {
  json document = course_document(comparison.course, comparison.n);
  document.update({{"subject", comparison.subject},
                   {"rival", comparison.rival},
                   {"figure", to_string(comparison.figure)},
                   {"ratio", nullptr},
                   {"goal", nullptr},
                   {"verdict", comparison.verdict()}});
  if (comparison.ratio) {
    document["ratio"] = comparison.ratio->median;
    document["interval"] = {comparison.ratio->interval.low, comparison.ratio->interval.high};
  }
  if (comparison.at_most) document["goal"] = *comparison.at_most;
  return document;
}

std::vector<std::string> time_row(const Standing& standing) {
  std::vector<std::string> row{standing.contestant, describe(standing.course), std::to_string(standing.n)};
  if (standing.seconds.empty()) {
    row.insert(row.end(), {std::string(outcome_of(standing)), standing.ruling.reason});
    return row;
  }
  const double scale = 1e6 / static_cast<double>(standing.vertices);
  const auto [low, high] = bench::bootstrap_median(standing.seconds, 1);
  row.insert(row.end(),
             {std::to_string(standing.triangles), three_digits(bench::median(standing.seconds) * scale),
              span_text({low * scale, high * scale})});
  return row;
}

std::vector<std::string> ratio_row(const Comparison& c) {
  return {c.subject,
          c.rival,
          describe(c.course),
          std::string(to_string(c.figure)),
          c.ratio ? three_digits(c.ratio->median) : "-",
          c.ratio && c.figure == Figure::time ? span_text(c.ratio->interval) : "-",
          c.at_most ? "<= " + three_digits(*c.at_most) : "-",
          c.at_most ? std::string(c.verdict()) : ""};
}

}  // namespace

std::string_view Comparison::verdict() const {
  if (!ratio) return "not_measured";
  if (!at_most) return "no_goal";
  return ratio->median <= *at_most ? "met" : "missed";
}

std::vector<Comparison> compare(std::span<const Standing> standings, std::size_t ours) {
  const std::vector<RaceGoal> goals = bench::race_goals();
  std::vector<Comparison> comparisons;
  for (std::size_t i = 0; i < ours; ++i)
    for (std::size_t j = 0; j < standings.size(); ++j)
      for (const Figure figure : figures_of(standings[i].course.kind)) {
        const Standing &subject = standings[i], &rival = standings[j];
        const auto goal = std::find_if(goals.begin(), goals.end(), [&](const RaceGoal& g) {
          return describe(g.subject) == subject.contestant && g.rival_name() == rival.contestant &&
                 g.course == subject.course && g.figure == figure;
        });
        if (j < ours && goal == goals.end()) continue;
        auto& made = comparisons.emplace_back(Comparison{subject.contestant, rival.contestant, subject.course,
                                                         subject.n, figure, ratio_of(subject, rival, figure),
                                                         std::nullopt});
        if (goal != goals.end()) made.at_most = goal->at_most;
      }
  return comparisons;
}

json races_document(std::uint64_t seed, std::span<const Standing> standings,
                    std::span<const Comparison> comparisons) {
  const json manifest = bench::make_manifest({});
  json document{{"build", manifest.at("build")},
                {"machine", manifest.at("machine")},
                {"seed", seed},
                {"times", json::array()},
                {"ratios", json::array()}};
  for (const Standing& standing : standings) document["times"].push_back(standing_document(standing));
  for (const Comparison& made : comparisons) document["ratios"].push_back(comparison_document(made));
  return document;
}

void print_races(Console& console, std::span<const Standing> standings,
                 std::span<const Comparison> comparisons) {
  std::vector<std::vector<std::string>> times{
      {"contestant", "course", "n", "triangles", "us per point", "95 %"}};
  for (const Standing& standing : standings) times.push_back(time_row(standing));
  print_table(console, times);
  if (comparisons.empty()) return;
  std::vector<std::vector<std::string>> ratios{
      {"ratio", "rival", "course", "of", "measured", "95 %", "goal", "verdict"}};
  for (const Comparison& comparison : comparisons) ratios.push_back(ratio_row(comparison));
  console.out << '\n';
  print_table(console, ratios);
}

}  // namespace tribunal::cli
