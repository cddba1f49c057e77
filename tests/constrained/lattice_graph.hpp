// Planar straight-line graphs on small lattices, where everything meets everything, and what integers say of
// them.
#pragma once

#include "algorithms/constrained/constrained.hpp"
#include "algorithms/verify/verify.hpp"
#include "datasets/random.hpp"

#include <string>
#include <utility>
#include <vector>

namespace tribunal {

struct LatticeGraph {
  std::vector<Point2> points;
  std::vector<Edge> segments;
  std::vector<Point2> holes;

  Graph as(Domain domain) const { return {points, segments, holes, domain}; }
  verify::Segments constraints(Domain domain) const {
    return {segments, holes, static_cast<verify::Domain>(domain)};
  }
};

/// Sites and segments drawn from a lattice of 2 to 9 columns, with duplicates, segments without length,
/// overlaps, shared ends and vertices on segments; now and then none is dropped that crosses another, so that
/// most graphs do not cross. Some are polygons.
LatticeGraph random_graph(Random& random);

std::string describe(const LatticeGraph& graph);

/// Twice the signed area of a, b, c, whose coordinates are integers, or halves of integers, below 2^20:
/// exact.
std::int64_t area(Point2 a, Point2 b, Point2 c);

/// Whether the site lies strictly inside the segment.
bool inside_segment(const LatticeGraph& graph, const Edge& segment, Point2 site);

/// Whether two segments cross inside both, and not at a site, which would split them.
bool cross(const LatticeGraph& graph, const Edge& s, const Edge& t);

/// Whether any two segments do.
bool any_crossing(const LatticeGraph& graph);

}  // namespace tribunal
