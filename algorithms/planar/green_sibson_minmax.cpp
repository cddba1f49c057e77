// Green and Sibson's insertion with the MinMax criterion in place of the circle test, Barth section 3.4:
// after each insertion flips propagate forward, away from the site, and backward, to the edges at it, until
// no flip makes the largest of six angles smaller. The result is locally optimal at every step.
#include "algorithms/abandon.hpp"
#include "algorithms/flips/min_max_criterion.hpp"
#include "algorithms/insertion/collect.hpp"
#include "algorithms/insertion/conflict.hpp"
#include "algorithms/insertion/first_triangle.hpp"
#include "algorithms/location/stochastic_walk.hpp"
#include "algorithms/mesh/splits.hpp"
#include "algorithms/planar/listed.hpp"

#include <array>
#include <vector>

namespace tribunal {
namespace {

/// In the order of the parameter's choices.
enum class Propagation : std::uint8_t {
  both,     ///< forward and backward, until no flip improves
  forward,  ///< to edges away from the site only, which is all that the circle test asks for
};

constexpr Parameter propagation_parameter{
    .name = "propagation", .summary = "which edges a flip makes suspect", .standard = "both", .choices = [] {
      return std::vector<std::string_view>{"both", "forward"};
    }};
constexpr std::array parameters{propagation_parameter};

class GreenSibsonMinMax {
 public:
  GreenSibsonMinMax(const PlanarProblem& problem, Propagation propagation)
      : problem_(problem),
        sites_{problem.points, problem.kernel},
        criterion_(sites_),
        propagation_(propagation),
        walk_(problem, mesh_) {
    const Triangle t = first_triangle(problem);
    add_first_triangle(mesh_, t[0], t[1], t[2]);
  }

  void insert(Index site) {
    const Index t = walk_.locate(site, counters_.location_steps);
    const bool outside = mesh_.is_ghost(t);
    const HalfEdge edge = outside ? PlanarMesh::none : edge_through(t, site);
    if (edge == PlanarMesh::none)
      split_triangle(mesh_, t, site);
    else
      split_edge(mesh_, edge, site);
    counters_.on_edge += edge != PlanarMesh::none;
    if (outside) join_visible_hull(t, site);
    suspect_star(t, site);
    propagate(site);
  }

  Triangulation result() && {
    Triangulation result;
    for (Index t = 0; t < mesh_.triangles(); ++t) collect(mesh_.triangle(t), result);
    result.counters = counters_;
    result.counters.created = mesh_.triangles() + 2 * counters_.flips;
    return result;
  }

 private:
  /// The edge of the finite triangle t on which the site lies, or `none` when it lies inside.
  HalfEdge edge_through(Index t, Index site) const {
    HalfEdge edge = PlanarMesh::none;
    for (HalfEdge h = 3 * t; h < 3 * t + 3; ++h) {
      const Sign side = sites_.orient(mesh_.from(h), mesh_.to(h), site);
      if (side == Sign::negative || (side == Sign::zero && edge != PlanarMesh::none))
        throw Abandon(Outcome::inconsistent_predicate,
                      "a site does not lie in the triangle where it was located");
      if (side == Sign::zero) edge = h;
    }
    return edge;
  }

  /// Round the star of a site, from the triangle t on: visits the half-edge opposite the site in each.
  void visit_star(Index t, Index site, auto visit) const {
    HalfEdge opposite = 3 * t;
    while (mesh_.corner(opposite) != site) ++opposite;
    const HalfEdge first = opposite;
    Budget budget(mesh_.triangles(), "the round of a star");
    do {
      budget.spend();
      visit(opposite);
      opposite = next(mesh_.twin(next(opposite)));
    } while (opposite != first);
  }

  /// The site lies beyond the hull, in the star of what was one ghost: flips the rays between the star's
  /// ghosts and others that it is in conflict with, which are those of the other hull edges it sees.
  void join_visible_hull(Index t, Index site) {
    Budget budget(problem_.sites.size() + 1, "joining a site to the hull");
    std::vector<HalfEdge> rays;
    visit_star(t, site, [&](HalfEdge opposite) {
      if (mesh_.is_ghost(triangle_of(opposite))) rays.push_back(opposite);
    });
    while (!rays.empty()) {
      const HalfEdge ray = rays.back(), beyond = mesh_.twin(ray);
      if (!in_conflict(problem_, mesh_.triangle(triangle_of(beyond)), site)) {
        rays.pop_back();
        continue;
      }
      budget.spend();
      flip_edge(mesh_, ray);
      ++counters_.flips;
      // Of the two triangles one is finite now; the other is the star's new ghost on this side.
      rays.back() = mesh_.is_ghost(triangle_of(ray)) ? ray : opposite_of(beyond, site);
    }
  }
  HalfEdge opposite_of(HalfEdge in_triangle, Index site) const {
    HalfEdge h = in_triangle;
    while (mesh_.corner(h) != site) h = next(h);
    return h;
  }

  /// All edges of the star are new or have a new triangle. Backward propagation alone looks at the spokes.
  void suspect_star(Index t, Index site) {
    visit_star(t, site, [&](HalfEdge opposite) {
      suspects_.push_back(opposite);
      if (propagation_ == Propagation::both) suspects_.push_back(next(opposite));
    });
  }

  /// A half-edge on the stack may have become another edge by a flip; but then its old edge was a side of the
  /// flip's, and waits under another name.
  void propagate(Index site) {
    Budget budget(problem_.sites.size() * problem_.sites.size() + 1, "flipping");
    while (!suspects_.empty()) {
      const HalfEdge edge = suspects_.back(), twin = mesh_.twin(edge);
      suspects_.pop_back();
      if (!is_better_flipped(edge)) continue;
      budget.spend();
      flip_edge(mesh_, edge);
      ++counters_.flips;
      for (const HalfEdge side : {edge, prev(edge), twin, prev(twin)})
        if (propagation_ == Propagation::both || (mesh_.from(side) != site && mesh_.to(side) != site))
          suspects_.push_back(side);
    }
  }

  bool is_better_flipped(HalfEdge edge) {
    const HalfEdge twin = mesh_.twin(edge);
    if (mesh_.is_ghost(triangle_of(edge)) || mesh_.is_ghost(triangle_of(twin))) return false;
    const Quadrilateral q{mesh_.from(edge), mesh_.to(edge), mesh_.corner(edge), mesh_.corner(twin)};
    if (q.left == q.right)
      throw Abandon(Outcome::inconsistent_predicate, "two triangles have the same corners");
    if (!is_strictly_convex(sites_, q)) return false;
    ++counters_.conflict_tests;
    return criterion_.improves(q);
  }

  const PlanarProblem& problem_;
  Sites sites_;
  MinMaxCriterion criterion_;
  Propagation propagation_;
  PlanarMesh mesh_;
  StochasticWalk walk_;
  Counters counters_;
  std::vector<HalfEdge> suspects_;
};

Triangulation green_sibson_minmax(const PlanarProblem& problem) {
  GreenSibsonMinMax algorithm(problem, choice_as<Propagation>(problem.settings, propagation_parameter));
  for (const Index site : problem.sites.subspan(3)) algorithm.insert(site);
  return std::move(algorithm).result();
}

}  // namespace

constinit const PlanarAlgorithm green_sibson_minmax_algorithm{
    .about = {.name = "green-sibson-minmax",
              .dimension = 2,
              .cites = "Barth section 3.4, after Green, Sibson 1977",
              .summary = "incremental: split, then flips that make the larger angle smaller, forward and "
                         "backward: locally optimal",
              .promise = Promise::triangulation,
              .incremental = false},
    .parameters = parameters,
    .run = green_sibson_minmax,
};

}  // namespace tribunal
