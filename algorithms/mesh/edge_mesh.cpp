#include "algorithms/mesh/edge_mesh.hpp"

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <numeric>

namespace tribunal {
namespace {

/// Side i of a triangle, from its corner i on, under the name that it shares with its twin.
struct Side {
  std::uint64_t ends;  // the smaller one in the high half
  Index number;        // 3 * triangle + i
  friend bool operator<(const Side& a, const Side& b) {
    return a.ends != b.ends ? a.ends < b.ends : a.number < b.number;
  }
};

/// Dealt out by their smaller ends, of which each has a few.
std::vector<Side> sorted_sides(std::span<const Triangle> triangles) {
  Index last = 0;
  for (const Triangle& t : triangles) last = std::max({last, t[0], t[1], t[2]});
  const auto least_of = [](const Triangle& t, std::size_t i) { return std::min(t[i], t[(i + 1) % 3]); };
  std::vector<Index> end(std::size_t{last} + 2, 0);  // of each vertex, where its sides end, one place later
  for (const Triangle& t : triangles)
    for (std::size_t i = 0; i < 3; ++i) ++end[least_of(t, i) + 1];
  std::partial_sum(end.begin(), end.end(), end.begin());
  std::vector<Side> sides(3 * triangles.size());
  Index number = 0;
  for (const Triangle& t : triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      const Index least = least_of(t, i);
      sides[end[least]++] = {std::uint64_t{least} << 32 | std::max(t[i], t[(i + 1) % 3]), number++};
    }
  for (Index begin = 0, v = 0; v <= last && begin < sides.size(); begin = end[v++])
    std::sort(sides.begin() + begin, sides.begin() + end[v]);
  return sides;
}

[[noreturn]] void refuse() {
  throw Abandon(Outcome::inconsistent_predicate, "the triangles to start from are no triangulation");
}

}  // namespace

EdgeMesh::EdgeMesh(std::span<const Triangle> triangles) {
  const std::vector<Side> sides = sorted_sides(triangles);
  const auto start = [&](const Side& side) { return triangles[side.number / 3][side.number % 3]; };
  const auto end = [&](const Side& side) { return triangles[side.number / 3][(side.number + 1) % 3]; };
  std::vector<HalfEdge> half_edge(sides.size());  // by number of the side
  for (std::size_t i = 0; i < sides.size(); ++i) {
    half_edge[sides[i].number] = static_cast<HalfEdge>(from_.size());
    from_.insert(from_.end(), {start(sides[i]), end(sides[i])});
    const bool shared = i + 1 < sides.size() && sides[i + 1].ends == sides[i].ends;
    outer_.insert(outer_.end(), {0, static_cast<char>(!shared)});
    if (!shared) continue;
    ++i;
    half_edge[sides[i].number] = static_cast<HalfEdge>(from_.size() - 1);
    if (start(sides[i]) != from_.back()) refuse();
    if (i + 1 < sides.size() && sides[i + 1].ends == sides[i].ends) refuse();
  }
  next_.resize(from_.size(), PlanarMesh::none);
  prev_.resize(from_.size(), PlanarMesh::none);
  for (std::size_t t = 0; t < sides.size(); t += 3)
    for (std::size_t i = 0; i < 3; ++i) link(half_edge[t + i], half_edge[t + (i + 1) % 3]);
  join_outer_face();
}

void EdgeMesh::join_outer_face() {
  Index last = 0;
  for (const Index v : from_) last = std::max(last, v);
  std::vector<HalfEdge> outgoing(std::size_t{last} + 1, PlanarMesh::none);
  for (HalfEdge h = 0; h < from_.size(); ++h) {
    if (!outer_[h]) continue;
    if (outgoing[from(h)] != PlanarMesh::none) refuse();
    outgoing[from(h)] = h;
  }
  for (HalfEdge h = 0; h < from_.size(); ++h) {
    if (!outer_[h]) continue;
    if (outgoing[to(h)] == PlanarMesh::none) refuse();
    link(h, outgoing[to(h)]);
  }
}

void EdgeMesh::flip(Index edge) {
  assert(is_inner(edge));
  const HalfEdge h = 2 * edge, t = twin(h);
  const HalfEdge after_h = next(h), before_h = prev(h), after_t = next(t), before_t = prev(t);
  from_[h] = to(after_t);
  from_[t] = to(after_h);
  link(h, before_h);
  link(before_h, after_t);
  link(after_t, h);
  link(t, before_t);
  link(before_t, after_h);
  link(after_h, t);
}

std::vector<Triangle> EdgeMesh::triangles() const {
  std::vector<Triangle> triangles;
  for (HalfEdge h = 0; h < from_.size(); ++h) {
    if (is_outer(h)) continue;
    const Triangle t{from(h), to(h), apex(h)};
    if (t[0] < t[1] && t[0] < t[2]) triangles.push_back(t);
  }
  return triangles;
}

}  // namespace tribunal
