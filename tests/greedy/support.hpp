// What the tests of greedy triangulations share: sites, and the three methods asked alike.
#pragma once

#include "algorithms/greedy/accepted_list.hpp"
#include "algorithms/greedy/faces.hpp"
#include "algorithms/greedy/from_delaunay.hpp"
#include "algorithms/greedy/stars.hpp"
#include "algorithms/list.hpp"
#include "algorithms/mesh/canonical.hpp"
#include "datasets/random.hpp"
#include "predicates/backends/list.hpp"
#include "tests/greedy/definition.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <numeric>
#include <optional>
#include <set>
#include <string_view>
#include <utility>
#include <vector>

namespace tribunal::greedy {

inline std::vector<Point2> points_of(const LatticeSites& sites) {
  std::vector<Point2> points;
  for (const Site& s : sites) points.push_back({static_cast<double>(s.x), static_cast<double>(s.y)});
  return points;
}

/// `count` distinct sites of a square of `side` lattice points.
inline LatticeSites random_sites(Random& random, std::size_t count, std::uint64_t side) {
  std::set<std::pair<std::int64_t, std::int64_t>> taken;
  LatticeSites sites;
  while (sites.size() < count) {
    const auto x = static_cast<std::int64_t>(random.below(side)),
               y = static_cast<std::int64_t>(random.below(side));
    if (taken.insert({x, y}).second) sites.push_back({x, y});
  }
  return sites;
}

inline bool all_on_a_line(const LatticeSites& sites) {
  return std::all_of(sites.begin(), sites.end(),
                     [&](const Site& s) { return area(sites[0], sites[1], s) == 0; });
}

/// Distinct points, not all on a line, in an order whose first three are not either, with a kernel.
class Plane {
 public:
  explicit Plane(std::vector<Point2> given, std::string_view backend = "filtered")
      : points_(std::move(given)), sites_(points_.size()) {
    auto bound = find_backend(backend)->bind2(points_);
    if (auto* kernel = std::get_if<0>(&bound)) kernel_ = std::move(*kernel);
    std::iota(sites_.begin(), sites_.end(), Index{0});
    for (std::size_t i = 2; kernel_ && i < sites_.size(); ++i) {
      if (kernel_->orient2d(points_[0], points_[1], points_[i]) == Sign::zero) continue;
      std::swap(sites_[2], sites_[i]);
      break;
    }
    if (kernel_) problem_.emplace(PlanarProblem{points_, sites_, *kernel_});
  }
  Plane(const Plane&) = delete;
  Plane& operator=(const Plane&) = delete;
  /// False where the backend refuses the points.
  bool is_bound() const { return kernel_ != nullptr; }
  /// Lives as long as the plane.
  const PlanarProblem& problem() const { return *problem_; }

 private:
  std::vector<Point2> points_;
  std::vector<Index> sites_;
  std::unique_ptr<const Kernel2> kernel_;
  std::optional<PlanarProblem> problem_;
};

/// A greedy triangulation by one of the methods: edges in order, triangles in one spelling.
struct Result {
  std::vector<Edge> edges;
  std::vector<Triangle> triangles;
};

inline Result by_list(const GreedyProblem& problem) {
  AcceptedList accepted(problem.planar, false);
  const auto edges = triangulate_from_pool(problem, accepted).edges;
  return {edges, canonical(faces_between(problem, edges))};
}
inline Result by_stars(const GreedyProblem& problem) {
  Stars accepted(problem.planar);
  const auto edges = triangulate_from_pool(problem, accepted).edges;
  return {edges, canonical(faces_between(problem, edges))};
}
inline Result by_delaunay(const GreedyProblem& problem) {
  const Triangulation delaunay = find_planar_algorithm("bowyer")->run(problem.planar);
  const GreedyMesh mesh = triangulate_from_delaunay(problem, delaunay.triangles);
  return {mesh.found.edges, canonical(mesh.triangles)};
}

struct Method {
  std::string_view name;
  Result (*run)(const GreedyProblem&);
};
inline constexpr Method methods[] = {{"list", by_list}, {"stars", by_stars}, {"delaunay", by_delaunay}};

}  // namespace tribunal::greedy
