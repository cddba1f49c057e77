#include "bench/whole/course.hpp"

#include "algorithms/constrained/crossings.hpp"
#include "bench/input.hpp"
#include "datasets/real.hpp"

#include <cmath>
#include <iomanip>
#include <numbers>
#include <sstream>

namespace tribunal::bench {
namespace {

/// Lines that enclose no domain, and so are no graph of their dataset's own.
bool has_open_lines(const Dataset& dataset) { return dataset.about.name == "counties"; }

DatasetGraph lines_of(const Dataset& dataset, std::uint64_t n, std::uint64_t seed) {
  if (!has_open_lines(dataset)) return dataset.graph(n, seed);
  RealGraph arcs = county_arcs();
  return {std::move(arcs.points), std::move(arcs.segments), {}};
}

}  // namespace

double Bounds::degrees() const { return std::asin(std::sqrt(sine_squared)) * (180 / std::numbers::pi); }

std::string describe(const Course& course) {
  std::ostringstream text;
  text << course.dataset << std::setprecision(3);
  if (course.kind == RaceKind::graph) text << ", segments";
  if (course.kind == RaceKind::refinement) {
    text << ", " << course.bounds.degrees() << " degrees";
    if (std::isfinite(course.bounds.longest_edge))
      text << std::setprecision(6) << ", edges to " << course.bounds.longest_edge;
  }
  return text.str();
}

bool offers(const Dataset& dataset, RaceKind kind) {
  return kind == RaceKind::triangulation || dataset.graph != nullptr ||
         (kind == RaceKind::graph && has_open_lines(dataset));
}

Ground ground_of(const Course& course, std::uint64_t seed) {
  const Dataset& dataset = *find_dataset(course.dataset);
  if (course.kind == RaceKind::triangulation) return {distinct_points(dataset.generate(course.n, seed))};
  DatasetGraph lines = lines_of(dataset, course.n, seed);
  if (course.kind == RaceKind::refinement)
    return {std::move(lines.points), std::move(lines.segments), std::move(lines.holes), course.bounds};
  SplitGraph pieces = split_crossings({lines.points, lines.segments});
  return {std::move(pieces.points), std::move(pieces.segments)};
}

}  // namespace tribunal::bench
