#include "datasets/shapes/outline.hpp"

#include <algorithm>
#include <cmath>

namespace tribunal::shapes {
namespace {

/// The camber line at a station.
HalfThickness camber_line(const FourDigit& aerofoil, double x) {
  const double m = aerofoil.camber, p = aerofoil.camber_at;
  if (m == 0) return {0, 0};
  const double part = x < p ? p * p : (1 - p) * (1 - p);
  const double constant = x < p ? 0 : 1 - 2 * p;
  return {m / part * (constant + 2 * p * x - x * x), m / part * (2 * p - 2 * x)};
}

/// A point of the upper side (side = 1) or lower one (side = -1).
Point2 surface_point(const FourDigit& aerofoil, double x, double side) {
  const HalfThickness camber = camber_line(aerofoil, x);
  const double length = std::sqrt(1 + camber.slope * camber.slope);
  const double across = side * half_thickness(aerofoil, x).height / length;
  return {{x - across * camber.slope, camber.height + across}};
}

double squared_distance(const Point2& p, const Point2& a, const Point2& b) {
  const double ux = b[0] - a[0], uy = b[1] - a[1], vx = p[0] - a[0], vy = p[1] - a[1];
  const double t = std::clamp((ux * vx + uy * vy) / (ux * ux + uy * uy), 0.0, 1.0);
  const double dx = vx - t * ux, dy = vy - t * uy;
  return dx * dx + dy * dy;
}

/// A run of an outline's sides, closed at the first vertex of the next run, and the box around it.
struct Run {
  std::size_t first, last;
  Point2 low, high;
};

std::vector<Run> runs_of(const Outline& outline) {
  constexpr std::size_t length = 64;
  std::vector<Run> runs;
  for (std::size_t first = 0; first < outline.size(); first += length) {
    Run run{first, std::min(first + length, outline.size()), outline[first], outline[first]};
    for (std::size_t i = first; i <= run.last; ++i)
      for (const std::size_t axis : {0, 1}) {
        const double c = outline[i % outline.size()][axis];
        run.low[axis] = std::min(run.low[axis], c);
        run.high[axis] = std::max(run.high[axis], c);
      }
    runs.push_back(run);
  }
  return runs;
}

/// Of the boxes of two runs; a little less, so that rounding does not hide the pair that comes nearest.
double least_squared_distance(const Run& a, const Run& b) {
  double sum = 0;
  for (const std::size_t axis : {0, 1}) {
    const double apart = std::max({0.0, a.low[axis] - b.high[axis], b.low[axis] - a.high[axis]});
    sum += apart * apart;
  }
  return sum * (1 - 0x1p-20);
}

double squared_distance(const Outline& points, const Outline& sides) {
  const std::vector<Run> of_points = runs_of(points), of_sides = runs_of(sides);
  const auto side = [&](const Point2& p, std::size_t i) {
    return squared_distance(p, sides[i], sides[(i + 1) % sides.size()]);
  };
  double least = side(points[0], sides.size() - 1);
  for (const Run& p : of_points)
    for (const Run& s : of_sides) least = std::min(least, side(points[p.first], s.first));
  for (const Run& p : of_points)
    for (const Run& s : of_sides) {
      if (least_squared_distance(p, s) > least) continue;
      for (std::size_t i = p.first; i < p.last; ++i)
        for (std::size_t j = s.first; j < s.last; ++j) least = std::min(least, side(points[i], j));
    }
  return least;
}

}  // namespace

HalfThickness half_thickness(const FourDigit& aerofoil, double x) {
  const double root = std::sqrt(x), last = aerofoil.blunt ? 0.1015 : 0.1036;
  const double height = 0.2969 * root + x * (-0.1260 + x * (-0.3516 + x * (0.2843 - last * x)));
  const double slope = 0.14845 / root + (-0.1260 + x * (-0.7032 + x * (0.8529 - 4 * last * x)));
  return {5 * aerofoil.thickness * height, 5 * aerofoil.thickness * slope};
}

Outline outline_of(const FourDigit& aerofoil, std::uint64_t stations) {
  const auto station = [&](std::uint64_t i) {
    const double t = static_cast<double>(i) / static_cast<double>(stations);
    return t * t * (2 - t);
  };
  Outline outline{{{1, 0}}};
  if (aerofoil.blunt) outline.push_back(surface_point(aerofoil, 1, 1));
  for (std::uint64_t i = stations - 1; i > 0; --i) outline.push_back(surface_point(aerofoil, station(i), 1));
  outline.push_back({{0, 0}});
  for (std::uint64_t i = 1; i < stations; ++i) outline.push_back(surface_point(aerofoil, station(i), -1));
  if (aerofoil.blunt) outline.push_back(surface_point(aerofoil, 1, -1));
  return outline;
}

Outline turned(Outline outline, double scale, double cosine, double sine) {
  for (Point2& p : outline)
    p = {{scale * (cosine * p[0] - sine * p[1]), scale * (sine * p[0] + cosine * p[1])}};
  return outline;
}

Outline moved(Outline outline, double x, double y) {
  for (Point2& p : outline) p = {{p[0] + x, p[1] + y}};
  return outline;
}

double distance(const Outline& a, const Outline& b) {
  return std::sqrt(std::min(squared_distance(a, b), squared_distance(b, a)));
}

Outline closed_up(const Outline& fixed, Outline outline, double gap, bool downwards) {
  const double towards = downwards ? -1 : 1;
  double apart = distance(fixed, outline);
  for (int step = 0; step < 1000 && apart > gap * (1 + 0x1p-20); ++step) {
    // No further than what is left: then they cannot come nearer than the gap.
    outline = moved(std::move(outline), 0, towards * (apart - gap));
    apart = distance(fixed, outline);
  }
  return outline;
}

Outline box_around(double half_width, std::uint64_t sides) {
  Outline box;
  const double step = 2 * half_width / static_cast<double>(sides);
  const auto at = [&](std::uint64_t i) { return -half_width + step * static_cast<double>(i); };
  for (std::uint64_t i = 0; i < sides; ++i) box.push_back({{0.5 + at(i), -half_width}});
  for (std::uint64_t i = 0; i < sides; ++i) box.push_back({{0.5 + half_width, at(i)}});
  for (std::uint64_t i = 0; i < sides; ++i) box.push_back({{0.5 - at(i), half_width}});
  for (std::uint64_t i = 0; i < sides; ++i) box.push_back({{0.5 - half_width, -at(i)}});
  return box;
}

void add_loop(DatasetGraph& graph, const Outline& outline) {
  const auto first = static_cast<std::uint32_t>(graph.points.size());
  const auto size = static_cast<std::uint32_t>(outline.size());
  graph.points.insert(graph.points.end(), outline.begin(), outline.end());
  for (std::uint32_t i = 0; i < size; ++i) graph.segments.push_back({first + i, first + (i + 1) % size});
}

}  // namespace tribunal::shapes
