// Watson's insertion (1981): a flat list of circles and no adjacency. Scan every circle for conflicts, delete
// those triangles, join the site to the edges that remain. A triangle whose circle lies left of all sites
// still to come is retired, so that x order scans O(sqrt n) circles per site on uniform data; random order
// scans nearly all, O(n^2).
#include "algorithms/abandon.hpp"
#include "algorithms/insertion/circle_extent.hpp"
#include "algorithms/insertion/collect.hpp"
#include "algorithms/insertion/conflict.hpp"
#include "algorithms/insertion/first_triangle.hpp"
#include "algorithms/planar/listed.hpp"

#include <algorithm>
#include <limits>
#include <vector>

namespace tribunal {
namespace {

class Watson {
 public:
  explicit Watson(const PlanarProblem& problem) : problem_(problem) {
    const Triangle t = first_triangle(problem);
    add(t);
    for (int i = 0; i < 3; ++i) add({infinite, t[(i + 2) % 3], t[(i + 1) % 3]});
    result_.counters = first_counters();
  }

  /// Inserts `site`; no site still to come, this one included, lies left of `leftmost`.
  void insert(Index site, double leftmost) {
    extract_conflicts(site, leftmost);
    cancel_inner_edges();
    if (removed_ == 0 || edges_.size() != removed_ + 2)
      throw Abandon(Outcome::inconsistent_predicate,
                    "the triangles in conflict with a site do not form one cavity");
    std::uint64_t ghosts = 0;
    for (const Edge& edge : edges_) {
      ghosts += edge[0] == infinite || edge[1] == infinite;
      add({site, edge[0], edge[1]});
    }
    Counters& counters = result_.counters;
    counters.created += edges_.size();
    counters.tau_with_ghosts += edges_.size();
    counters.tau += edges_.size() - ghosts;
    counters.outside_hull += ghosts > 0;
  }

  Triangulation result() && {
    for (const Circle& circle : active_) collect(circle.triangle, result_);
    return std::move(result_);
  }

 private:
  struct Circle {
    Triangle triangle;
    double right;  // the circle lies left of this
  };

  void add(const Triangle& t) {
    const bool ghost = t[0] == infinite || t[1] == infinite || t[2] == infinite;
    const auto& p = problem_.points;
    active_.push_back(
        {t, ghost ? std::numeric_limits<double>::infinity() : right_extent(p[t[0]], p[t[1]], p[t[2]])});
  }

  /// Moves the edges of the conflicting triangles to edges_; retires triangles that no site can reach any
  /// more.
  void extract_conflicts(Index site, double leftmost) {
    edges_.clear();
    removed_ = 0;
    for (std::size_t i = 0; i < active_.size();) {
      const Circle circle = active_[i];
      bool keep = true;
      if (circle.right < leftmost) {
        collect(circle.triangle, result_);
        keep = false;
      } else if (++result_.counters.conflict_tests; in_conflict(problem_, circle.triangle, site)) {
        const Triangle& t = circle.triangle;
        for (int k = 0; k < 3; ++k) edges_.push_back({t[k], t[(k + 1) % 3]});
        ++removed_;
        keep = false;
      }
      if (keep) {
        ++i;
      } else {
        active_[i] = active_.back();
        active_.pop_back();
      }
    }
    result_.counters.location_steps += active_.size() + removed_;
  }

  /// Edges inside the cavity occur once in each direction; only those that occur in one remain.
  void cancel_inner_edges() {
    const auto undirected = [](const Edge& e) { return std::minmax(e[0], e[1]); };
    std::sort(edges_.begin(), edges_.end(), [&](const Edge& a, const Edge& b) {
      return undirected(a) != undirected(b) ? undirected(a) < undirected(b) : a < b;
    });
    std::size_t kept = 0;
    for (std::size_t i = 0; i < edges_.size(); ++i) {
      if (i + 1 < edges_.size() && undirected(edges_[i]) == undirected(edges_[i + 1]))
        ++i;
      else
        edges_[kept++] = edges_[i];
    }
    edges_.resize(kept);
  }

  const PlanarProblem& problem_;
  Triangulation result_;
  std::vector<Circle> active_;
  std::vector<Edge> edges_;
  std::size_t removed_ = 0;
};

/// For each position in the insertion order, the least x from there to the end.
std::vector<double> least_x_to_come(const PlanarProblem& problem) {
  std::vector<double> least(problem.sites.size());
  double x = std::numeric_limits<double>::infinity();
  for (std::size_t i = problem.sites.size(); i-- > 0;)
    least[i] = x = std::min(x, problem.points[problem.sites[i]][0]);
  return least;
}

Triangulation watson(const PlanarProblem& problem) {
  const std::vector<double> least = least_x_to_come(problem);
  Watson algorithm(problem);
  for (std::size_t i = 3; i < problem.sites.size(); ++i) algorithm.insert(problem.sites[i], least[i]);
  return std::move(algorithm).result();
}

}  // namespace

constinit const PlanarAlgorithm watson_algorithm{
    .about = {.name = "watson",
              .dimension = 2,
              .cites = "Watson 1981",
              .summary = "incremental Delaunay: scan a flat list of circles, cancel doubled edges"},
    .run = watson,
};

}  // namespace tribunal
