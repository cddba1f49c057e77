// Bowyer's insertion (1981): walk to one conflicting triangle, flood the connected cavity, star it from the
// new site. With adjacency: O(n) retriangulation and O(n^{3/2}) walking expected in random order.
#include "algorithms/abandon.hpp"
#include "algorithms/insertion/collect.hpp"
#include "algorithms/insertion/conflict.hpp"
#include "algorithms/insertion/first_triangle.hpp"
#include "algorithms/location/walk.hpp"
#include "algorithms/mesh/planar_mesh.hpp"
#include "algorithms/planar/listed.hpp"

#include <vector>

namespace tribunal {
namespace {

class Bowyer {
 public:
  explicit Bowyer(const PlanarProblem& problem)
      : problem_(problem), star_from_(problem.points.size() + 1, Mark{0, 0}) {
    mesh_.reserve(2 * problem.sites.size());
    const Triangle t = first_triangle(problem);
    last_ = add_first_triangle(mesh_, t[0], t[1], t[2]);
    visited_.resize(mesh_.triangles(), 0);
    counters_ = first_counters();
  }

  void insert(Index site) {
    const Index start = walk(problem_, mesh_, last_, site, counters_.location_steps);
    find_cavity(start, site);
    star_cavity(site);
  }

  Triangulation result() const {
    Triangulation result;
    result.counters = counters_;
    for (Index t = 0; t < mesh_.triangles(); ++t) collect(mesh_.triangle(t), result);
    return result;
  }

 private:
  struct BoundaryEdge {
    Index from, to;    // counter-clockwise as seen from the cavity
    HalfEdge outside;  // the half-edge across
  };
  struct Mark {
    Index epoch, triangle;
  };

  /// Fills cavity_ with the conflicting triangles connected to `start`, boundary_ with the edges around them.
  void find_cavity(Index start, Index site) {
    ++epoch_;
    cavity_.clear();
    boundary_.clear();
    if (!tests_positive(start, site))
      throw Abandon(Outcome::inconsistent_predicate,
                    "the triangle that holds a site is not in conflict with it");
    for (std::size_t next_triangle = 0; next_triangle < cavity_.size(); ++next_triangle) {
      const Index t = cavity_[next_triangle];
      for (HalfEdge h = 3 * t; h < 3 * t + 3; ++h) {
        const HalfEdge across = mesh_.twin(h);
        const Index neighbour = triangle_of(across);
        const bool conflict = visited_[neighbour] == in_cavity() ||
                              (visited_[neighbour] != spared() && tests_positive(neighbour, site));
        if (!conflict) boundary_.push_back({mesh_.from(h), mesh_.to(h), across});
      }
    }
    // m triangles joined in a tree have m + 2 outer edges; fewer means that the cavity swallows a vertex.
    if (boundary_.size() != cavity_.size() + 2)
      throw Abandon(Outcome::inconsistent_predicate, "a cavity is not simply connected");
  }

  bool tests_positive(Index t, Index site) {
    ++counters_.conflict_tests;
    const bool conflict = in_conflict(problem_, mesh_.triangle(t), site);
    visited_[t] = conflict ? in_cavity() : spared();
    if (conflict) cavity_.push_back(t);
    return conflict;
  }

  /// Replaces the cavity by the star of `site`: the dead triangles' slots are used again, two more are
  /// appended.
  void star_cavity(Index site) {
    std::uint64_t ghosts = 0;
    for (std::size_t i = 0; i < boundary_.size(); ++i) {
      const BoundaryEdge& edge = boundary_[i];
      const Index t = i < cavity_.size() ? cavity_[i] : mesh_.add(site, edge.from, edge.to);
      mesh_.replace(t, site, edge.from, edge.to);
      mesh_.glue(3 * t, edge.outside);
      ghosts += edge.from == infinite || edge.to == infinite;
      Mark& spoke = mark(edge.from);
      if (spoke.epoch == epoch_)
        throw Abandon(Outcome::inconsistent_predicate, "the boundary of a cavity touches itself");
      spoke = {epoch_, t};
      last_ = t;
    }
    for (std::size_t i = 0; i < boundary_.size(); ++i) {
      const Index t = mark(boundary_[i].from).triangle;
      const Mark& following = mark(boundary_[i].to);
      if (following.epoch != epoch_)
        throw Abandon(Outcome::inconsistent_predicate, "the boundary of a cavity is not closed");
      mesh_.glue(3 * t + 1, 3 * following.triangle + 2);
    }
    visited_.resize(mesh_.triangles(), 0);
    counters_.created += boundary_.size();
    counters_.tau_with_ghosts += boundary_.size();
    counters_.tau += boundary_.size() - ghosts;
    counters_.outside_hull += ghosts > 0;
  }

  // visited_ holds these two stamps, so that it need not be cleared between insertions.
  std::uint64_t in_cavity() const { return 2 * std::uint64_t{epoch_}; }
  std::uint64_t spared() const { return 2 * std::uint64_t{epoch_} + 1; }
  Mark& mark(Index vertex) { return vertex == infinite ? star_from_.back() : star_from_[vertex]; }

  const PlanarProblem& problem_;
  PlanarMesh mesh_;
  Counters counters_;
  Index last_ = 0, epoch_ = 0;
  std::vector<std::uint64_t> visited_;  // by triangle
  std::vector<Mark> star_from_;         // by vertex: the star's triangle whose outer edge starts there
  std::vector<Index> cavity_;
  std::vector<BoundaryEdge> boundary_;
};

Triangulation bowyer(const PlanarProblem& problem) {
  Bowyer algorithm(problem);
  for (const Index site : problem.sites.subspan(3)) algorithm.insert(site);
  return algorithm.result();
}

}  // namespace

constinit const PlanarAlgorithm bowyer_algorithm{
    .about = {.name = "bowyer",
              .dimension = 2,
              .cites = "Bowyer 1981",
              .summary = "incremental Delaunay: walk to a conflict, flood the cavity, re-star it"},
    .run = bowyer,
};

}  // namespace tribunal
