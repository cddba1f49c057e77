#include "algorithms/stretching/guides.hpp"

#include <algorithm>
#include <cmath>

namespace tribunal::stretching {
namespace {
std::vector<Segment> require_walls(const Boundary& boundary) {
  if (boundary.walls.empty()) throw Abandon(Outcome::refused_input, "the domain has no segments to be walls");
  return boundary.walls;
}
}  // namespace

Guides::Guides(const constrained::Mesh& mesh, const Spacing& spacing, WallChoice choice)
    : Guides(mesh, spacing, boundary_of(mesh, choice)) {}

Guides::Guides(const constrained::Mesh& mesh, const Spacing& spacing, const Boundary& boundary)
    : spacing_(spacing), walls_(require_walls(boundary)) {
  if (!boundary.rim.empty()) rim_.emplace(boundary.rim);
  for (Index v = 0; v < mesh.vertices(); ++v) {
    if (boundary.on_wall[v] != 0)
      append(0, ways_from(mesh, v));
    else
      add(mesh.point(v));
  }
}

void Guides::append(double distance, const std::vector<Vector>& ways) {
  distances_.push_back(distance);
  ways_.insert(ways_.end(), ways.begin(), ways.end());
  open_.resize(ways_.size(), 1);
  first_steps_.push_back(static_cast<Step>(ways_.size()));
}

void Guides::add(Point2 p) {
  const Nearest nearest = walls_.nearest(p);
  append(nearest.distance, {nearest.direction});
}

bool Guides::has_room(Point2 place, Index v, Step step) const {
  const double r = spacing(v), here = walls_.nearest(place).distance;
  if (here < distances_[v] + r / 2) return false;
  if (walls_.nearest(forward(place, step, r / 2)).distance < here + r / 4) return false;
  return !rim_ || rim_->nearest(place).distance >= r / 2;
}

double Guides::measure(const constrained::Mesh& mesh, Index t) const {
  const Triangle corners = mesh.triangles().triangle(t);
  double largest = 0;
  for (Index i = 0; i < 3; ++i) {
    const Index v = corners[i];
    const Point2 at = mesh.point(v), p = mesh.point(corners[(i + 1) % 3]),
                 q = mesh.point(corners[(i + 2) % 3]);
    const Vector to_p{p[0] - at[0], p[1] - at[1]}, to_q{q[0] - at[0], q[1] - at[1]};
    double extent = 0, nearest = -1;
    for (Step step = first_steps_[v]; step != first_steps_[v + 1]; ++step) {
      const double along_p = ways_[step][0] * to_p[0] + ways_[step][1] * to_p[1];
      const double along_q = ways_[step][0] * to_q[0] + ways_[step][1] * to_q[1];
      if (step != first_steps_[v] && along_p + along_q <= nearest) continue;
      nearest = along_p + along_q;
      extent = std::max(std::abs(along_p), std::abs(along_q));
    }
    largest = std::max(largest, extent / spacing(v));
  }
  return largest;
}

}  // namespace tribunal::stretching
