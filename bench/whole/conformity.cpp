#include "bench/whole/conformity.hpp"

#include "algorithms/duplicates.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tribunal::bench {
namespace {

constexpr double little = 0x1p-40;
constexpr Index none = std::numeric_limits<Index>::max();

// Differences of doubles are as good as their own rounding; products of two of them are, too.
struct Vector {
  double x, y;
};
Vector between(Point2 a, Point2 b) { return {b[0] - a[0], b[1] - a[1]}; }
double dot(Vector u, Vector v) { return u.x * v.x + u.y * v.y; }
double cross(Vector u, Vector v) { return u.x * v.y - u.y * v.x; }

std::string name_of(const Edge& ends) { return std::to_string(ends[0]) + " " + std::to_string(ends[1]); }

/// Which subsegments start or end at each point.
class Incidence {
 public:
  Incidence(std::span<const Edge> edges, std::size_t points) : edges_(edges), first_(points + 1, 0) {
    for (const Edge& edge : edges)
      for (const Index end : edge) ++first_[end + 1];
    for (std::size_t v = 0; v < points; ++v) first_[v + 1] += first_[v];
    at_.resize(2 * edges.size());
    std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
    for (Index e = 0; e < edges.size(); ++e)
      for (const Index end : edges[e]) at_[next[end]++] = e;
  }
  std::span<const Index> at(Index v) const { return {at_.data() + first_[v], first_[v + 1] - first_[v]}; }
  Index across(Index edge, Index v) const { return edges_[edge][0] == v ? edges_[edge][1] : edges_[edge][0]; }

 private:
  std::span<const Edge> edges_;
  std::vector<std::size_t> first_;
  std::vector<Index> at_;
};

/// One segment, and how far along it and beside it points are.
class Line {
 public:
  Line(Point2 a, Point2 b) : a_(a), way_(between(a, b)), length_(std::hypot(way_.x, way_.y)) {
    for (const double coordinate : {a[0], a[1], b[0], b[1]})
      largest_ = std::max(largest_, std::abs(coordinate));
  }
  double along(Point2 p) const { return dot(way_, between(a_, p)); }
  bool holds(Point2 p) const { return std::abs(cross(way_, between(a_, p))) <= 0x1p-48 * largest_ * length_; }

 private:
  Point2 a_;
  Vector way_;
  double length_, largest_ = 0;
};

/// The subsegment that leads on from v along the line, the shortest one.
Index next_part(const Line& line, Index v, const RefinedMesh& mesh, const Incidence& incidence) {
  const double here = line.along(mesh.points[v]);
  double nearest = std::numeric_limits<double>::infinity();
  Index best = none;
  for (const Index part : incidence.at(v)) {
    const Point2 p = mesh.points[incidence.across(part, v)];
    if (const double there = line.along(p); line.holds(p) && here < there && there < nearest) {
      nearest = there;
      best = part;
    }
  }
  return best;
}

double squared_sine_between(Vector u, Vector v) {
  const double area = cross(u, v);
  return area * area / (dot(u, u) * dot(v, v));
}

/// Whether two segments share an end and enclose less than 60 degrees there.
bool enclose_little(const Edge& s, const Edge& t, std::span<const Point2> points) {
  for (const Index i : {0U, 1U})
    for (const Index j : {0U, 1U}) {
      if (points[s[i]] != points[t[j]]) continue;
      const Vector u = between(points[s[i]], points[s[1 - i]]), v = between(points[t[j]], points[t[1 - j]]);
      if (dot(u, v) > 0 && squared_sine_between(u, v) < 0.75 * (1 + little)) return true;
    }
  return false;
}

/// Which segments are close to others in direction where they meet.
class SmallAngles {
 public:
  SmallAngles(const Ground& ground, const SegmentPaths& paths)
      : ground_(ground), paths_(paths), first_(first_occurrences(ground.points)) {}

  /// Whether a corner of the triangle lies on a segment that encloses less than 60 degrees with another.
  bool excuse(const Triangle& t) const {
    return std::ranges::any_of(
        t, [&](Index v) { return std::ranges::any_of(paths_.on[v], [&](Index s) { return has_near(s); }); });
  }

 private:
  bool has_near(Index s) const {
    return std::ranges::any_of(ground_.segments[s], [&](Index end) {
      return std::ranges::any_of(paths_.on[first_[end]], [&](Index r) {
        return r != s && enclose_little(ground_.segments[r], ground_.segments[s], ground_.points);
      });
    });
  }

  const Ground& ground_;
  const SegmentPaths& paths_;
  std::vector<Index> first_;
};

/// Squared sine of the smallest angle, which lies between the two longer edges, and the longest edge squared.
struct Shape {
  double sine_squared, longest;
};
Shape shape_of(Point2 a, Point2 b, Point2 c) {
  const Vector u = between(a, b), v = between(b, c), w = between(c, a);
  std::array squares{dot(u, u), dot(v, v), dot(w, w)};
  std::sort(squares.begin(), squares.end());
  const double area = cross(u, v);
  return {area * area / (squares[1] * squares[2]), squares[2]};
}

}  // namespace

SegmentPaths follow_segments(const Ground& ground, const RefinedMesh& mesh) {
  SegmentPaths paths{std::vector<std::vector<Index>>(mesh.points.size()), {}};
  const std::vector<Index> first = first_occurrences(ground.points);
  const Incidence incidence(mesh.subsegments, mesh.points.size());
  std::vector<bool> used(mesh.subsegments.size(), false);
  for (Index s = 0; s < ground.segments.size(); ++s) {
    const auto& [a, b] = ground.segments[s];
    const Line line(ground.points[a], ground.points[b]);
    Index v = first[a];
    paths.on[v].push_back(s);
    while (v != first[b]) {
      const Index part = next_part(line, v, mesh, incidence);
      if (part == none) {
        paths.fault = "segment " + name_of(ground.segments[s]) + " breaks off at " + std::to_string(v);
        return paths;
      }
      used[part] = true;
      v = incidence.across(part, v);
      paths.on[v].push_back(s);
    }
  }
  if (const auto loose = std::find(used.begin(), used.end(), false); loose != used.end())
    paths.fault = "subsegment " + name_of(mesh.subsegments[static_cast<std::size_t>(loose - used.begin())]) +
                  " is part of no segment";
  return paths;
}

std::string unmet_bound(const Ground& ground, const RefinedMesh& mesh, const SegmentPaths& paths) {
  const double sharpest = ground.bounds.sine_squared * (1 - little);
  const double longest = ground.bounds.longest_edge * ground.bounds.longest_edge * (1 + little);
  const SmallAngles small(ground, paths);
  for (const Triangle& t : mesh.triangles) {
    const Shape shape = shape_of(mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]);
    const auto told = [&](const std::string& what, double value) {
      return "triangle " + std::to_string(t[0]) + " " + std::to_string(t[1]) + " " + std::to_string(t[2]) +
             what + std::to_string(value);
    };
    if (shape.longest > longest) return told(" has an edge of ", std::sqrt(shape.longest));
    if (shape.sine_squared < sharpest && !small.excuse(t))
      return told(" has an angle of ", Bounds{.sine_squared = shape.sine_squared}.degrees()) + " degrees";
  }
  return {};
}

}  // namespace tribunal::bench
