#include "tests/refinement/judged.hpp"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace tribunal::refinement {
namespace {

/// The step from one double to the next at x.
mpq_class unit(double x) {
  x = std::fabs(x);
  return mpq_class(std::nextafter(x, std::numeric_limits<double>::infinity())) - mpq_class(x);
}

/// Whether the segment ab comes, in x and in y, within three of the coarsest doubles between its ends of q.
bool rounds_to(Point2 a, Point2 b, Point2 q) {
  mpq_class first = 0, last = 1;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const mpq_class reach = 3 * std::max(unit(a[axis]), unit(b[axis]));
    const mpq_class low = mpq_class(q[axis]) - reach, high = mpq_class(q[axis]) + reach;
    const mpq_class from(a[axis]), way = mpq_class(b[axis]) - from;
    if (way == 0) {
      if (from < low || high < from) return false;
      continue;
    }
    const mpq_class s = (low - from) / way, t = (high - from) / way;
    first = std::max(first, std::min(s, t));
    last = std::min(last, std::max(s, t));
  }
  return first <= last;
}

}  // namespace

std::string faults_of(const Refined& refined, std::span<const Point2> holes, verify::Domain domain) {
  std::vector<Edge> segments;
  for (const Subsegment& part : refined.subsegments) segments.push_back(part.ends);
  const auto verdict =
      verify::verify_constrained(refined.points, {refined.triangles}, {segments, holes, domain});
  std::string text;
  for (const auto& fault : verdict.faults)
    text.append(verify::to_string(fault.kind)).append(": ").append(fault.detail).append("\n");
  return text;
}

void expect_paths(const Refined& refined, std::span<const Point2> points, std::span<const Edge> segments) {
  std::map<Index, std::map<Index, int>> ends;
  for (const Subsegment& part : refined.subsegments) {
    if (part.segment == no_segment) continue;
    const Edge& whole = segments[part.segment];
    for (const Index v : part.ends) {
      ++ends[part.segment][v];
      EXPECT_TRUE(rounds_to(points[whole[0]], points[whole[1]], refined.points[v]));
    }
  }
  for (Index s = 0; s < segments.size(); ++s) {
    const Point2 a = points[segments[s][0]], b = points[segments[s][1]];
    int loose = 0;
    for (const auto& [v, count] : ends[s]) {
      EXPECT_LE(count, 2);
      if (count == 2) continue;
      ++loose;
      EXPECT_TRUE(refined.points[v] == a || refined.points[v] == b);
    }
    EXPECT_EQ(loose, a == b ? 0 : 2);
  }
}

}  // namespace tribunal::refinement
