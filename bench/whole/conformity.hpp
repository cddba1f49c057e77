// Does a refined mesh hold to the domain and the bounds that it was made for? What its own segments cannot
// tell.
#pragma once

#include "bench/whole/course.hpp"

#include <span>
#include <string>
#include <vector>

namespace tribunal::bench {

/// A refined mesh: points are those of the ground, then the new ones; corners and ends are in range and first
/// copies of their positions; no subsegment comes twice.
struct RefinedMesh {
  std::span<const Point2> points;
  std::span<const Triangle> triangles;
  std::span<const Edge> subsegments;
};

/// The segments of a ground as paths of subsegments.
struct SegmentPaths {
  std::vector<std::vector<Index>> on;  ///< for each point, the segments it lies on, ascending
  std::string fault;                   ///< one line where a segment is no path, or a subsegment on none
};

/// Follows each segment from its one end to the other. Vertices on it may have been rounded: they lie within
/// 2^-48 of the largest coordinate of its ends. O(segments + subsegments), vertices of bounded degree.
SegmentPaths follow_segments(const Ground& ground, const RefinedMesh& mesh);

/// What is wrong with the first triangle that does not keep the ground's bounds; empty where all do. Sines
/// and lengths are as doubles make them: a bound may be missed by 2^-40 of itself. A triangle that has
/// corners on two segments which enclose less than 60 degrees may be sharper.
std::string unmet_bound(const Ground& ground, const RefinedMesh& mesh, const SegmentPaths& paths);

}  // namespace tribunal::bench
