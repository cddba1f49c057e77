// Green and Sibson's insertion (1977) with the history DAG of Guibas, Knuth and Sharir (1992), Barth
// section 3.3c: split the triangle that holds the site, then flip until all circles are empty. Expected O(n
// log n) in random order.
#include "algorithms/abandon.hpp"
#include "algorithms/location/history_dag.hpp"
#include "algorithms/mesh/planar_mesh.hpp"
#include "algorithms/planar/collect.hpp"
#include "algorithms/planar/conflict.hpp"
#include "algorithms/planar/first_triangle.hpp"
#include "algorithms/planar/listed.hpp"

#include <algorithm>
#include <vector>

namespace tribunal {
namespace {

class GreenSibson {
 public:
  explicit GreenSibson(const PlanarProblem& problem)
      : problem_(problem), root_(make_root()), history_(problem, mesh_, root_) {
    depths_.reserve(problem.sites.size());
  }

  void insert(Index site) {
    const HistoryDag::Place place = history_.locate(site);
    depths_.push_back(place.depth);
    counters_.location_steps += place.depth;
    star_size_ = 0;
    on_hull_ = mesh_.is_ghost(place.triangle);
    const HalfEdge edge = on_hull_ ? PlanarMesh::none : edge_through(place.triangle, site);
    if (edge == PlanarMesh::none)
      split_triangle(place.triangle, site);
    else
      split_edge(edge, site);
    legalise(site);
    counters_.tau_with_ghosts += star_size_;
    counters_.tau += star_size_ - (on_hull_ ? 2 : 0);
    counters_.outside_hull += on_hull_;
  }

  Triangulation result() const {
    Triangulation result;
    for (Index t = 0; t < mesh_.triangles(); ++t)
      if (history_.alive(t)) collect(mesh_.triangle(t), result);
    result.counters = counters_;
    result.counters.created = mesh_.triangles();
    result.history = summary();
    return result;
  }

 private:
  Index make_root() {
    mesh_.reserve(9 * problem_.sites.size());
    const Triangle t = first_triangle(problem_);
    counters_ = first_counters();
    return add_first_triangle(mesh_, t[0], t[1], t[2]);
  }

  /// The edge of the finite triangle t on which the site lies, or `none` when it lies inside.
  HalfEdge edge_through(Index t, Index site) const {
    const auto& p = problem_.points;
    HalfEdge edge = PlanarMesh::none;
    for (HalfEdge h = 3 * t; h < 3 * t + 3; ++h) {
      const Sign side = problem_.kernel.orient2d(p[mesh_.from(h)], p[mesh_.to(h)], p[site]);
      if (side == Sign::negative || (side == Sign::zero && edge != PlanarMesh::none))
        throw Abandon(Outcome::inconsistent_predicate,
                      "a site does not lie in the triangle where it was located");
      if (side == Sign::zero) edge = h;
    }
    return edge;
  }

  /// One triangle, or one ghost, becomes the three of the star of `site`.
  void split_triangle(Index t, Index site) {
    const Triangle corner = mesh_.triangle(t);
    Triangle child{};
    for (Index i = 0; i < 3; ++i) {
      child[i] = add_to_star(site, corner[(i + 1) % 3], corner[(i + 2) % 3]);
      mesh_.glue(3 * child[i], mesh_.twin(3 * t + i));
    }
    for (Index i = 0; i < 3; ++i) mesh_.glue(3 * child[i] + 1, 3 * child[(i + 1) % 3] + 2);
    history_.split(t, child);
  }

  /// The two triangles of an edge become the four of the star of a site on it.
  void split_edge(HalfEdge edge, Index site) {
    ++counters_.on_edge;
    const HalfEdge twin = mesh_.twin(edge);
    on_hull_ = mesh_.is_ghost(triangle_of(twin));
    const auto [left, right] = cut_triangle(edge, site);
    const auto [far_left, far_right] = cut_triangle(twin, site);
    mesh_.glue(3 * left + 1, 3 * far_right + 2);
    mesh_.glue(3 * far_left + 1, 3 * right + 2);
  }

  struct Halves {
    Index left, right;  // (site, p, a) and (site, b, p) for the triangle (p, a, b)
  };
  Halves cut_triangle(HalfEdge edge, Index site) {
    const Index p = mesh_.corner(edge);
    const HalfEdge beyond_a = mesh_.twin(next(edge)), beyond_b = mesh_.twin(prev(edge));
    const Index left = add_to_star(site, p, mesh_.from(edge)), right = add_to_star(site, mesh_.to(edge), p);
    mesh_.glue(3 * left, beyond_b);
    mesh_.glue(3 * right, beyond_a);
    mesh_.glue(3 * left + 2, 3 * right + 1);
    history_.cut(triangle_of(edge), left, right);
    return {left, right};
  }

  /// Flips edges opposite the site until none is in conflict. Each flip adds one triangle to the star, and no
  /// vertex joins a star twice when the signs are right.
  void legalise(Index site) {
    Budget budget(problem_.sites.size() + 1, "flipping");
    while (!suspects_.empty()) {
      const Index t = suspects_.back();
      suspects_.pop_back();
      ++counters_.conflict_tests;
      const HalfEdge across = mesh_.twin(3 * t);
      if (!in_conflict(problem_, mesh_.triangle(triangle_of(across)), site)) continue;
      budget.spend();
      flip(t, across, site);
    }
  }

  /// (site, a, b) and (p, b, a) become (site, a, p) and (site, p, b).
  void flip(Index t, HalfEdge across, Index site) {
    const Index a = mesh_.corner(3 * t + 1), b = mesh_.corner(3 * t + 2), p = mesh_.corner(across);
    if (p == infinite || p == site)
      throw Abandon(Outcome::inconsistent_predicate, "a flip would join a site to infinity or to itself");
    const HalfEdge beyond_sa = mesh_.twin(3 * t + 2), beyond_bs = mesh_.twin(3 * t + 1);
    const HalfEdge beyond_ap = mesh_.twin(next(across)), beyond_pb = mesh_.twin(prev(across));
    const Index right = add_to_star(site, a, p), left = add_to_star(site, p, b);
    star_size_ -= 1;  // two joined, t left
    ++counters_.flips;
    mesh_.glue(3 * right, beyond_ap);
    mesh_.glue(3 * right + 2, beyond_sa);
    mesh_.glue(3 * left, beyond_pb);
    mesh_.glue(3 * left + 1, beyond_bs);
    mesh_.glue(3 * right + 1, 3 * left + 2);
    history_.cut(t, left, right);
    history_.cut(triangle_of(across), left, right);
  }

  Index add_to_star(Index site, Index a, Index b) {
    const Index t = mesh_.add(site, a, b);
    suspects_.push_back(t);
    ++star_size_;
    return t;
  }

  History summary() const {
    History history;
    history.nodes = mesh_.triangles();
    if (depths_.empty()) return history;
    const std::size_t late = depths_.size() - std::max<std::size_t>(1, depths_.size() / 10);
    double all_sum = 0, late_sum = 0;
    for (std::size_t i = 0; i < depths_.size(); ++i) {
      history.depth_max = std::max(history.depth_max, depths_[i]);
      all_sum += static_cast<double>(depths_[i]);
      if (i >= late) late_sum += static_cast<double>(depths_[i]);
    }
    history.depth_mean = all_sum / static_cast<double>(depths_.size());
    history.depth_late_mean = late_sum / static_cast<double>(depths_.size() - late);
    return history;
  }

  const PlanarProblem& problem_;
  PlanarMesh mesh_;
  Counters counters_;
  Index root_;
  HistoryDag history_;
  std::vector<Index> suspects_;  // triangles of the star whose outer edge is to be tested
  std::vector<std::uint64_t> depths_;
  std::uint64_t star_size_ = 0;
  bool on_hull_ = false;
};

Triangulation green_sibson(const PlanarProblem& problem) {
  GreenSibson algorithm(problem);
  for (const Index site : problem.sites.subspan(3)) algorithm.insert(site);
  return algorithm.result();
}

}  // namespace

constinit const PlanarAlgorithm green_sibson_algorithm{
    .about = {.name = "green-sibson",
              .dimension = 2,
              .cites = "Green, Sibson 1977; Guibas, Knuth, Sharir 1992",
              .summary = "incremental Delaunay: split, flip suspects, locate through the history DAG"},
    .run = green_sibson,
};

}  // namespace tribunal
