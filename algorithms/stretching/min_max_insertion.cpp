#include "algorithms/stretching/min_max_insertion.hpp"

#include <algorithm>
#include <array>
#include <cassert>

namespace tribunal::stretching {
namespace {
using refinement::Sighting;

Angle<2> larger(const Kernel2& kernel, const Angle<2>& p, const Angle<2>& q) {
  return kernel.compare_angle(q, p) == Sign::positive ? q : p;
}
}  // namespace

Angle<2> largest_corner(const Kernel2& kernel, Point2 a, Point2 b, Point2 c) {
  if (kernel.compare_length(b, c, a, b) == Sign::positive)
    return kernel.compare_length(c, a, b, c) == Sign::positive ? Angle<2>{c, b, a} : Angle<2>{b, a, c};
  return kernel.compare_length(c, a, a, b) == Sign::positive ? Angle<2>{c, b, a} : Angle<2>{a, c, b};
}

MinMaxInsertion::MinMaxInsertion(constrained::Mesh& mesh) : mesh_(mesh) {
  suspect_all();
  swap_suspects();
}

void MinMaxInsertion::swap_anew() {
  suspect_all();
  std::vector<Edge> edges;
  for (const Suspect& s : suspects_) edges.push_back({s.from, s.to});
  suspects_.clear();
  swaps_ += mesh_.restore(std::move(edges));
  suspect_all();
  swap_suspects();
}

bool MinMaxInsertion::may_swap(HalfEdge h) const { return !mesh_.held(h) && mesh_.inside(triangle_of(h)); }

/// Of the quadrilateral s, a, p, b, counter-clockwise, whether the diagonal sp, instead of ab, makes the
/// largest of the six angles smaller; only where it lies inside.
bool MinMaxInsertion::improves(Point2 s, Point2 a, Point2 p, Point2 b) const {
  const Kernel2& kernel = mesh_.kernel();
  if (kernel.orient2d(s, a, p) != Sign::positive || kernel.orient2d(s, p, b) != Sign::positive) return false;
  const auto larger_of = [&](const Angle<2>& x, const Angle<2>& y) { return larger(kernel, x, y); };
  const Angle<2> before = larger_of(largest_corner(kernel, s, a, b), largest_corner(kernel, b, a, p));
  const Angle<2> after = larger_of(largest_corner(kernel, s, a, p), largest_corner(kernel, s, p, b));
  return kernel.compare_angle(after, before) == Sign::negative;
}

Angle<2> MinMaxInsertion::largest_around(Point2 p, const Sighting& where) {
  const PlanarMesh& t = mesh_.triangles();
  star_.clear();
  if (where.kind == Sighting::Kind::inside) {
    const HalfEdge h = 3 * triangle_of(where.at);
    star_.insert(star_.end(), {h, h + 1, h + 2});
  } else {
    const HalfEdge g = t.twin(where.at);
    star_.insert(star_.end(), {next(where.at), prev(where.at), next(g), prev(g)});
  }
  Budget budget(3 * std::uint64_t{t.triangles()}, "growing a star");
  Angle<2> largest{};
  for (bool first = true; !star_.empty();) {
    budget.spend();
    const HalfEdge h = star_.back(), g = t.twin(h);
    star_.pop_back();
    const Point2 a = mesh_.point(t.from(h)), b = mesh_.point(t.to(h));
    if (may_swap(h) && improves(p, a, mesh_.point(t.corner(g)), b)) {
      star_.insert(star_.end(), {next(g), prev(g)});
      continue;
    }
    const Angle<2> corner = largest_corner(mesh_.kernel(), p, a, b);
    largest = first ? corner : larger(mesh_.kernel(), largest, corner);
    first = false;
  }
  return largest;
}

Index MinMaxInsertion::insert(Point2 p, const Sighting& where) {
  assert(where.kind == Sighting::Kind::inside ||
         (where.kind == Sighting::Kind::on_edge && !mesh_.held(where.at)));
  const Index vertex = where.kind == Sighting::Kind::inside ? mesh_.place_into(triangle_of(where.at), p)
                                                            : mesh_.place_on(where.at, p);
  changed_.clear();
  const HalfEdge first = mesh_.link(vertex);
  HalfEdge h = first;
  do {
    changed_.push_back(triangle_of(h));
    for (const HalfEdge side : {prev(h), h}) suspect(side);
    h = mesh_.next_link(h);
  } while (h != first);
  swap_suspects();
  std::sort(changed_.begin(), changed_.end());
  changed_.erase(std::unique(changed_.begin(), changed_.end()), changed_.end());
  return vertex;
}

void MinMaxInsertion::suspect(HalfEdge h) {
  const PlanarMesh& t = mesh_.triangles();
  if (may_swap(h)) suspects_.push_back({h, t.from(h), t.to(h)});
}

void MinMaxInsertion::suspect_all() {
  for (HalfEdge h = 0; h < 3 * mesh_.triangles().triangles(); ++h)
    if (h < mesh_.triangles().twin(h)) suspect(h);
}

/// Each swap makes the angles, from the largest down, lexicographically smaller: it ends.
void MinMaxInsertion::swap_suspects() {
  const PlanarMesh& t = mesh_.triangles();
  Budget budget(64 * (std::uint64_t{t.triangles()} + 64), "swapping for angles");
  while (!suspects_.empty()) {
    const auto [h, a, b] = suspects_.back();
    suspects_.pop_back();
    if (t.from(h) != a || t.to(h) != b) continue;
    const HalfEdge g = t.twin(h);
    const Index s = t.corner(h), p = t.corner(g);
    if (s == p || !improves(mesh_.point(s), mesh_.point(a), mesh_.point(p), mesh_.point(b))) continue;
    budget.spend();
    const Index left = triangle_of(h), right = triangle_of(g);
    mesh_.swap(h);
    ++swaps_;
    changed_.insert(changed_.end(), {left, right});
    for (const HalfEdge side : {3 * left, 3 * left + 2, 3 * right, 3 * right + 1}) suspect(side);
  }
}

}  // namespace tribunal::stretching
