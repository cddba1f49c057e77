#include "algorithms/location/history_dag.hpp"

#include "algorithms/abandon.hpp"

#include <algorithm>

namespace tribunal {

HistoryDag::HistoryDag(const PlanarProblem& problem, const PlanarMesh& mesh)
    : problem_(problem), mesh_(mesh), origin_(mesh.triangle(0)) {
  // On average 9 triangles and two further lines come and go with a site, in any random order.
  nodes_.reserve(11 * problem.sites.size() + mesh.triangles());
  leaf_of_.reserve(2 * problem.sites.size());
  depths_.reserve(problem.sites.size());
  leaf_of_.resize(mesh.triangles());
  for (Index slot = 0; slot < mesh.triangles(); ++slot) add_leaf(slot);
}

Index HistoryDag::add(const Node& node) {
  if (nodes_.size() >= continued - 1)
    throw Abandon(Outcome::refused_input, "more nodes of a history than 31 bits can name");
  nodes_.push_back(node);
  return static_cast<Index>(nodes_.size() - 1);
}

void HistoryDag::foresee(std::span<const Index> sites) {
  foreseen_.clear();
  for (const Index site : sites) foreseen_.push_back(begin(site));
  std::size_t arrived = 0;
  while (arrived < foreseen_.size()) {
    for (const Path& path : foreseen_) fetch_line(path.at);
    arrived = 0;
    for (Path& path : foreseen_) {
      if (is_leaf(path.at)) {
        ++arrived;
        continue;
      }
      descend(path);
      __builtin_prefetch(&nodes_[path.at]);
    }
  }
}

void HistoryDag::fetch_line(Index at) const {
  if (is_leaf(at)) return;
  const Node& node = nodes_[at];
  __builtin_prefetch(&problem_.points[node.from]);
  if (node.to != infinite) __builtin_prefetch(&problem_.points[node.to]);
}

Index HistoryDag::locate(Index site) {
  const auto known =
      std::find_if(foreseen_.begin(), foreseen_.end(), [&](const Path& path) { return path.site == site; });
  Path path = known == foreseen_.end() ? begin(site) : *known;
  while (!is_leaf(path.at)) descend(path);
  depths_.push_back(path.depth);
  depth_sum_ += path.depth;
  return nodes_[path.at].from;
}

// Links lead to younger nodes only, so that even contradictory signs end in some leaf.
void HistoryDag::descend(Path& path) const {
  const Node& node = nodes_[path.at];
  const Sign where =
      node.to == infinite ? side_of_ray(node.from, path.site) : side(node.from, node.to, path.site);
  const Index link = where == Sign::negative ? node.right : node.left;
  path.at = link & ~continued;
  path.depth += link == path.at;
}

Index HistoryDag::first_node(Index site) const {
  bool inside = true;
  for (Index i = 0; i < 3; ++i)
    inside = inside && side(origin_[(i + 1) % 3], origin_[(i + 2) % 3], site) != Sign::negative;
  if (inside) return 0;
  // Beyond the edge from u to v of the first triangle, the cone runs counter-clockwise from o -> u to o -> v.
  // The side of each ray is needed once: the cone is the one where it changes from left of u to right of v.
  for (Index i = 0; i < 3; ++i)
    if (side_of_ray(origin_[(i + 1) % 3], site) == Sign::positive &&
        side_of_ray(origin_[(i + 2) % 3], site) == Sign::negative)
      return 1 + i;
  throw Abandon(Outcome::inconsistent_predicate, "a site lies in no cone of the first triangle");
}

void HistoryDag::split_triangle(Index site, const Triangle& star) {
  const Index dead = leaf_of_[star[0]];
  leaf_of_.resize(mesh_.triangles());
  for (const Index slot : star) add_leaf(slot);
  triangles_ += 3;
  const Triangle corner{mesh_.corner(3 * star[1] + 2), mesh_.corner(3 * star[0] + 1),
                        mesh_.corner(3 * star[0] + 2)};
  Triangle leaf{leaf_of_[star[0]], leaf_of_[star[1]], leaf_of_[star[2]]};
  const auto at = std::find(corner.begin(), corner.end(), infinite) - corner.begin();
  if (at == 3) {
    nodes_[dead] = fork_finite(site, corner, leaf);
  } else {
    std::rotate(leaf.begin(), leaf.begin() + at, leaf.end());
    nodes_[dead] = fork_ghost(site, corner[(at + 1) % 3], corner[(at + 2) % 3], leaf);
  }
}

// The line through the site and corner 0 has corner 1, the child between corners 0 and 1, and a part of the
// child opposite corner 0 on its left.
HistoryDag::Node HistoryDag::fork_finite(Index site, const Triangle& corner, const Triangle& leaf) {
  const Index on_left = add_line({corner[1], site, leaf[2], leaf[0]});
  const Index on_right = add_line({site, corner[2], leaf[1], leaf[0]});
  return {site, corner[0], on_left, on_right};
}

// A ghost (infinite, u, v) split by a site outside the hull: leaf[0] is the finite child (site, u, v), on
// whose edges sites belong to it; leaf[1] the ghost beyond site -> v, on the right of the ray through the
// site; leaf[2] the one beyond u -> site, on its left.
HistoryDag::Node HistoryDag::fork_ghost(Index site, Index u, Index v, const Triangle& leaf) {
  const Index on_left = add_line({site, u, leaf[0], leaf[2]});
  const Index on_right = add_line({v, site, leaf[0], leaf[1]});
  return {site, infinite, on_left, on_right};
}

void HistoryDag::split_edge(Index site, const std::array<Index, 4>& star) {
  const Index dead = leaf_of_[star[0]], beyond = leaf_of_[star[2]];
  const Index p = mesh_.corner(3 * star[0] + 1), q = mesh_.corner(3 * star[2] + 1);
  leaf_of_.resize(mesh_.triangles());
  for (const Index slot : star) add_leaf(slot);
  triangles_ += 4;
  nodes_[dead] = fork(site, p, star[0], star[3]);
  nodes_[beyond] = fork(site, q, star[2], star[1]);
}

void HistoryDag::flip(Index site, Index p, Index left, Index right) {
  const Index dead[] = {leaf_of_[left], leaf_of_[right]};
  add_leaf(left);
  add_leaf(right);
  triangles_ += 2;
  nodes_[dead[0]] = nodes_[dead[1]] = fork(site, p, left, right);
}

// On the line itself the finite one is right: a site on a hull edge belongs to the triangle inside it.
HistoryDag::Node HistoryDag::fork(Index site, Index p, Index left, Index right) const {
  if (p != infinite && mesh_.is_ghost(left)) return {p, site, leaf_of_[right], leaf_of_[left]};
  return {site, p, leaf_of_[left], leaf_of_[right]};
}

Sign HistoryDag::side(Index a, Index b, Index site) const {
  const auto& p = problem_.points;
  return problem_.kernel.orient2d(p[a], p[b], p[site]);
}

Sign HistoryDag::side_of_ray(Index through, Index site) const {
  for (const Index origin : origin_)
    if (const Sign s = side(origin, through, site); s != Sign::zero) return s;
  throw Abandon(Outcome::inconsistent_predicate,
                "two sites are collinear with all corners of the first triangle");
}

History HistoryDag::shape() const {
  History history;
  history.nodes = triangles_;
  if (depths_.empty()) return history;
  const std::size_t late = depths_.size() - std::max<std::size_t>(1, depths_.size() / 10);
  double late_sum = 0;
  for (std::size_t i = late; i < depths_.size(); ++i) late_sum += depths_[i];
  history.depth_mean = static_cast<double>(depth_sum_) / static_cast<double>(depths_.size());
  history.depth_late_mean = late_sum / static_cast<double>(depths_.size() - late);
  history.depth_max = *std::max_element(depths_.begin(), depths_.end());
  return history;
}

}  // namespace tribunal
