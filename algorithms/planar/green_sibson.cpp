// Green and Sibson's insertion (1977), Barth section 3.3c: find the triangle that holds the site, split it,
// then flip until all circles are empty. Through the history DAG of Guibas, Knuth and Sharir (1992) in
// expected O(n log n) for a random order; by walking from the last site in O(n) or so where the order follows
// a space-filling curve; by jumping and walking in expected O(n^{4/3}) for uniform sites in random order.
#include "algorithms/abandon.hpp"
#include "algorithms/insertion/collect.hpp"
#include "algorithms/insertion/conflict.hpp"
#include "algorithms/insertion/first_triangle.hpp"
#include "algorithms/location/history_dag.hpp"
#include "algorithms/location/jump.hpp"
#include "algorithms/location/walk.hpp"
#include "algorithms/mesh/planar_mesh.hpp"
#include "algorithms/mesh/splits.hpp"
#include "algorithms/planar/listed.hpp"
#include "algorithms/renumbered.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

namespace tribunal {
namespace {

/// The ways to find the triangle that holds a site. Each is told of every change to the mesh.
enum class Location : std::uint8_t { history, walk, jump_and_walk };

constexpr Parameter location_parameter{
    .name = "location",
    .summary = "how the triangle that holds a site is found",
    .standard = "history",
    .choices = [] {
      return std::vector<std::string_view>{"history", "walk", "jump-and-walk"};
    }};
constexpr std::array parameters{location_parameter};

/// Walks from the triangle that held the last site, whose slot is one of that site's star; or from a nearer
/// one, by a jump. Changes to the mesh need no record.
template <bool jumps>
class WalkFromLast {
 public:
  WalkFromLast(const PlanarProblem& problem, const PlanarMesh& mesh)
      : problem_(problem), mesh_(mesh), jump_(problem, mesh) {}

  Index locate(Index site) {
    if constexpr (jumps) last_ = jump_.from(last_, site);
    last_ = walk(problem_, mesh_, last_, site, steps_);
    return last_;
  }
  void foresee(std::span<const Index>) {}
  void split_triangle(Index, const Triangle&) {}
  void split_edge(Index, const std::array<Index, 4>&) {}
  void flip(Index, Index, Index, Index) {}

  std::uint64_t steps() const { return steps_; }
  std::optional<History> shape() const { return std::nullopt; }

 private:
  const PlanarProblem& problem_;
  const PlanarMesh& mesh_;
  Jump jump_;
  Index last_ = 0;
  std::uint64_t steps_ = 0;
};

template <class Locator>
class GreenSibson {
 public:
  explicit GreenSibson(const PlanarProblem& problem)
      : problem_(problem),
        mesh_(first_mesh(problem)),
        locator_(problem, mesh_),
        counters_(first_counters()) {}

  void insert(std::span<const Index> sites) {
    locator_.foresee(sites);
    for (const Index site : sites) insert_one(site);
  }

  Triangulation result() const {
    Triangulation result;
    result.triangles.reserve(mesh_.triangles());
    for (Index t = 0; t < mesh_.triangles(); ++t) collect(mesh_.triangle(t), result);
    result.counters = counters_;
    result.counters.location_steps = locator_.steps();
    result.history = locator_.shape();
    return result;
  }

 private:
  static PlanarMesh first_mesh(const PlanarProblem& problem) {
    PlanarMesh mesh;
    mesh.reserve(2 * problem.sites.size());
    const Triangle t = first_triangle(problem);
    add_first_triangle(mesh, t[0], t[1], t[2]);
    return mesh;
  }

  void insert_one(Index site) {
    const Index t = locator_.locate(site);
    on_hull_ = mesh_.is_ghost(t);
    const HalfEdge edge = on_hull_ ? PlanarMesh::none : edge_through(t, site);
    star_size_ = edge == PlanarMesh::none ? split(t, site) : split_at(edge, site);
    counters_.created += star_size_;
    legalise(site);
    counters_.tau_with_ghosts += star_size_;
    counters_.tau += star_size_ - (on_hull_ ? 2 : 0);
    counters_.outside_hull += on_hull_;
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

  /// The size of the star that replaces a triangle or ghost.
  Index split(Index t, Index site) {
    const Index more = mesh_.triangles();
    split_triangle(mesh_, t, site);
    locator_.split_triangle(site, {t, more, more + 1});
    suspects_.assign({3 * t, 3 * more, 3 * more + 3});
    return 3;
  }

  /// The same where the site lies on an edge.
  Index split_at(HalfEdge edge, Index site) {
    ++counters_.on_edge;
    const Index t = triangle_of(edge), u = triangle_of(mesh_.twin(edge)), more = mesh_.triangles();
    on_hull_ = mesh_.is_ghost(u);
    split_edge(mesh_, edge, site);
    locator_.split_edge(site, {t, more, u, more + 1});
    suspects_.assign({3 * t, 3 * more + 3, 3 * u, 3 * more});
    return 4;
  }

  /// Flips edges opposite the site until none is in conflict. Each flip adds one triangle to the star, and no
  /// vertex joins a star twice when the signs are right.
  void legalise(Index site) {
    Budget budget(problem_.sites.size() + 1, "flipping");
    while (!suspects_.empty()) {
      const HalfEdge edge = suspects_.back();
      suspects_.pop_back();
      ++counters_.conflict_tests;
      const HalfEdge across = mesh_.twin(edge);
      if (!in_conflict(problem_, mesh_.triangle(triangle_of(across)), site)) continue;
      budget.spend();
      flip(edge, across, site);
    }
  }

  /// (site, a, b) and (p, b, a) become (site, a, p) and (site, p, b).
  void flip(HalfEdge edge, HalfEdge across, Index site) {
    const Index p = mesh_.corner(across);
    if (p == infinite || p == site)
      throw Abandon(Outcome::inconsistent_predicate, "a flip would join a site to infinity or to itself");
    flip_edge(mesh_, edge);
    locator_.flip(site, p, triangle_of(across), triangle_of(edge));
    suspects_.push_back(edge);
    suspects_.push_back(prev(across));
    ++star_size_;
    ++counters_.flips;
    counters_.created += 2;
  }

  const PlanarProblem& problem_;
  PlanarMesh mesh_;
  Locator locator_;
  Counters counters_;
  std::vector<HalfEdge> suspects_;  // edges opposite the site that are to be tested
  std::uint64_t star_size_ = 0;
  bool on_hull_ = false;
};

template <class Locator>
Triangulation insert_all(const PlanarProblem& problem) {
  GreenSibson<Locator> algorithm(problem);
  constexpr std::size_t most_at_once = 16;
  for (auto left = problem.sites.subspan(3); !left.empty();) {
    const auto some = left.first(std::min(left.size(), most_at_once));
    algorithm.insert(some);
    left = left.subspan(some.size());
  }
  return algorithm.result();
}

Triangulation insert_all(const PlanarProblem& problem, Location location) {
  switch (location) {
    case Location::walk:
      return insert_all<WalkFromLast<false>>(problem);
    case Location::jump_and_walk:
      return insert_all<WalkFromLast<true>>(problem);
    default:
      return insert_all<HistoryDag>(problem);
  }
}

Triangulation green_sibson(const PlanarProblem& problem) {
  const Renumbered renumbered(problem);
  Triangulation result =
      insert_all(renumbered.problem(), choice_as<Location>(problem.settings, location_parameter));
  renumbered.restore(result);
  return result;
}

}  // namespace

constinit const PlanarAlgorithm green_sibson_algorithm{
    .about = {.name = "green-sibson",
              .dimension = 2,
              .cites = "Green, Sibson 1977; Guibas, Knuth, Sharir 1992",
              .summary = "incremental Delaunay: locate, split, flip suspects"},
    .parameters = parameters,
    .run = green_sibson,
};

}  // namespace tribunal
