#include "tests/constrained/lattice_graph.hpp"

#include <algorithm>

namespace tribunal {
namespace {

Point2 draw_point(Random& random, std::uint64_t columns) {
  return {{static_cast<double>(random.below(columns)), static_cast<double>(random.below(columns))}};
}

/// Joins consecutive points, the last to the first.
void add_loop(LatticeGraph& graph, Random& random, std::uint64_t columns) {
  const auto first = static_cast<Index>(graph.points.size());
  const auto corners = static_cast<Index>(3 + random.below(5));
  for (Index i = 0; i < corners; ++i) {
    graph.points.push_back(draw_point(random, columns));
    graph.segments.push_back({first + i, first + (i + 1) % corners});
  }
}

void add_segments(LatticeGraph& graph, Random& random, bool crossings) {
  const auto sites = graph.points.size();
  const auto wanted = random.below(2 * sites + 1);
  for (std::uint64_t i = 0; i < wanted; ++i) {
    const Edge segment{static_cast<Index>(random.below(sites)), static_cast<Index>(random.below(sites))};
    const bool clear = std::none_of(graph.segments.begin(), graph.segments.end(),
                                    [&](const Edge& other) { return cross(graph, segment, other); });
    if (crossings || clear) graph.segments.push_back(segment);
  }
}

}  // namespace

std::int64_t area(Point2 a, Point2 b, Point2 c) {
  const auto twice = [](double x) { return static_cast<std::int64_t>(2 * x); };
  return (twice(a[0]) - twice(c[0])) * (twice(b[1]) - twice(c[1])) -
         (twice(a[1]) - twice(c[1])) * (twice(b[0]) - twice(c[0]));
}

bool inside_segment(const LatticeGraph& graph, const Edge& segment, Point2 site) {
  const Point2 a = graph.points[segment[0]], b = graph.points[segment[1]];
  return area(a, b, site) == 0 && ((a < site && site < b) || (b < site && site < a));
}

bool cross(const LatticeGraph& graph, const Edge& s, const Edge& t) {
  const auto sign = [](std::int64_t value) { return (value > 0) - (value < 0); };
  const Point2 a = graph.points[s[0]], b = graph.points[s[1]], c = graph.points[t[0]], d = graph.points[t[1]];
  if (sign(area(a, b, c)) * sign(area(a, b, d)) >= 0 || sign(area(c, d, a)) * sign(area(c, d, b)) >= 0)
    return false;
  return std::none_of(graph.points.begin(), graph.points.end(), [&](Point2 site) {
    return inside_segment(graph, s, site) && inside_segment(graph, t, site);
  });
}

bool any_crossing(const LatticeGraph& graph) {
  for (std::size_t i = 0; i < graph.segments.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (cross(graph, graph.segments[i], graph.segments[j])) return true;
  return false;
}

LatticeGraph random_graph(Random& random) {
  LatticeGraph graph;
  const std::uint64_t columns = 2 + random.below(8);
  const bool polygons = random.below(3) == 0;
  if (polygons)
    for (auto loops = 1 + random.below(3); loops > 0; --loops) add_loop(graph, random, columns);
  for (auto sites = 1 + random.below(polygons ? 5 : 24); sites > 0; --sites)
    graph.points.push_back(draw_point(random, columns));
  if (!polygons) add_segments(graph, random, random.below(8) == 0);
  for (auto holes = random.below(3); holes > 0; --holes) {
    const Point2 corner = draw_point(random, columns);
    graph.holes.push_back({{corner[0] + 0.5, corner[1] + 0.25}});
  }
  return graph;
}

std::string describe(const LatticeGraph& graph) {
  std::string text = "points";
  for (const Point2& p : graph.points) text += " (" + std::to_string(p[0]) + "," + std::to_string(p[1]) + ")";
  text += "\nsegments";
  for (const Edge& s : graph.segments) text += " " + std::to_string(s[0]) + "-" + std::to_string(s[1]);
  text += "\nholes";
  for (const Point2& p : graph.holes) text += " (" + std::to_string(p[0]) + "," + std::to_string(p[1]) + ")";
  return text;
}

}  // namespace tribunal
