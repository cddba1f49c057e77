#include "algorithms/data_dependent/roughness.hpp"

#include <algorithm>
#include <cmath>

namespace tribunal {

std::array<double, 2> Roughness::gradient(Index a, Index b, Index c) const {
  std::array<Index, 3> corner{a, b, c};
  std::sort(corner.begin(), corner.end());
  const Point2 &p = points_[corner[0]], &q = points_[corner[1]], &r = points_[corner[2]];
  const double qx = q[0] - p[0], qy = q[1] - p[1], rx = r[0] - p[0], ry = r[1] - p[1];
  const double f = values_[corner[1]] - values_[corner[0]], g = values_[corner[2]] - values_[corner[0]];
  const double doubled_area = qx * ry - qy * rx;
  return {(f * ry - g * qy) / doubled_area, (g * qx - f * rx) / doubled_area};
}

double Roughness::across(Index a, Index b, Index p, Index q) const {
  const auto [a1, b1] = gradient(a, b, p);
  const auto [a2, b2] = gradient(a, b, q);
  double cost = 0;
  if (cost_ == Cost::jump_in_normal_derivatives) {
    const double x = points_[a][0] - points_[b][0], y = points_[a][1] - points_[b][1];
    cost = std::fabs(y * (a1 - a2) - x * (b1 - b2)) / std::hypot(x, y);
  } else {
    // The arc cosine of the text loses half the digits of small angles; the cross product of the normals
    // (-a, -b, 1) keeps them.
    const double sine = std::hypot(b2 - b1, a1 - a2, a1 * b2 - b1 * a2);
    cost = std::atan2(sine, a1 * a2 + b1 * b2 + 1);
  }
  return norm_ == Norm::l1 ? cost : cost * cost;
}

double Roughness::across(const EdgeMesh& mesh, Index edge) const {
  const Quadrilateral q = quadrilateral(mesh, edge);
  return across(q.from, q.to, q.left, q.right);
}

double Roughness::total(const EdgeMesh& mesh) const {
  double sum = 0;
  for (Index edge = 0; edge < mesh.edges(); ++edge)
    if (mesh.is_inner(edge)) sum += across(mesh, edge);
  return sum;
}

Roughness::Change Roughness::change_by_flip(const EdgeMesh& mesh, Index edge) const {
  const Quadrilateral q = quadrilateral(mesh, edge);
  Change change{across(q.from, q.to, q.left, q.right), across(q.left, q.right, q.from, q.to)};
  const HalfEdge h = 2 * edge, t = EdgeMesh::twin(h);
  // Each side keeps the triangle beyond it and gets another apex on this side.
  const auto add = [&](HalfEdge side, Index apex) {
    const HalfEdge beyond = EdgeMesh::twin(side);
    if (mesh.is_outer(beyond)) return;
    change.before += across(mesh.from(side), mesh.to(side), mesh.apex(side), mesh.apex(beyond));
    change.after += across(mesh.from(side), mesh.to(side), apex, mesh.apex(beyond));
  };
  add(mesh.next(h), q.right);
  add(mesh.prev(h), q.right);
  add(mesh.next(t), q.left);
  add(mesh.prev(t), q.left);
  return change;
}

}  // namespace tribunal
