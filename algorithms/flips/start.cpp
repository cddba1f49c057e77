#include "algorithms/flips/start.hpp"

#include "algorithms/abandon.hpp"
#include "algorithms/flips/halves.hpp"
#include "algorithms/flips/quadrilateral.hpp"
#include "datasets/random.hpp"

#include <algorithm>

namespace tribunal {
namespace {

/// A triangulation that grows by sites outside its hull, each joined to all hull edges that it sees. The hull
/// is a cycle, by vertex; its latest vertex lies on it, beside what the next one sees.
class Growth {
 public:
  explicit Growth(const Sites& sites)
      : sites_(sites), next_(sites.points.size()), prev_(sites.points.size()) {}

  /// The first sites: collinear, in order along their line, but for the last one.
  void begin(std::span<const Index> path, Index apex) {
    const bool left = sites_.orient(path[0], path[1], apex) == Sign::positive;
    for (std::size_t i = 0; i + 1 < path.size(); ++i) {
      const Index a = path[left ? i : i + 1], b = path[left ? i + 1 : i];
      triangles_.push_back({a, b, apex});
      link(a, b);
    }
    link(left ? path.back() : path.front(), apex);
    link(apex, left ? path.front() : path.back());
    latest_ = apex;
  }

  /// The chain of hull edges that the site sees begins or ends at the latest vertex, or passes it. Only wrong
  /// signs make it empty or close it to a cycle.
  void add(Index site) {
    Index first = latest_, last = latest_;
    while (sees(site, last, next_[last])) {
      triangles_.push_back({next_[last], last, site});
      last = next_[last];
      if (last == latest_) refuse();
    }
    while (sees(site, prev_[first], first)) {
      triangles_.push_back({first, prev_[first], site});
      first = prev_[first];
      if (first == last) refuse();
    }
    if (first == last) refuse();
    link(first, site);
    link(site, last);
    latest_ = site;
  }

  std::vector<Triangle> triangles() && { return std::move(triangles_); }

 private:
  /// Whether the site lies strictly beyond the hull edge a -> b, which has the triangulation on its left.
  bool sees(Index site, Index a, Index b) const { return sites_.orient(a, b, site) == Sign::negative; }
  [[noreturn]] static void refuse() {
    throw Abandon(Outcome::inconsistent_predicate, "a site beyond the hull sees none of it, or all");
  }
  void link(Index a, Index b) {
    next_[a] = b;
    prev_[b] = a;
  }

  Sites sites_;
  std::vector<Index> next_, prev_;  // counter-clockwise
  std::vector<Triangle> triangles_;
  Index latest_ = 0;
};

/// Around the first vertex, which is the lexicographically least: by angle, then by distance. Seen from there
/// the others span less than a straight angle, so that orientations order them. A merge sort: it stays within
/// its range even where wrong signs are no order.
void sort_around_first(const Sites& sites, std::span<Index> order) {
  const auto& p = sites.points;
  const Index origin = order.front();
  std::stable_sort(order.begin() + 1, order.end(), [&](Index a, Index b) {
    const Sign turn = sites.orient(origin, a, b);
    return turn == Sign::zero ? p[a] < p[b] : turn == Sign::positive;
  });
}

std::vector<Triangle> by_halves(const Sites& sites, std::span<const Index> vertices) {
  auto [order, triangles] = triangulate_by_halves(sites, vertices);
  for (Triangle& t : triangles)
    for (Index& corner : t) corner = order[corner];
  return std::move(triangles);
}

}  // namespace

std::vector<Triangle> start_triangulation(const Sites& sites, std::span<const Index> vertices, Start start) {
  if (start == Start::halves) return by_halves(sites, vertices);
  std::vector<Index> order(vertices.begin(), vertices.end());
  std::sort(order.begin(), order.end(), [&](Index a, Index b) { return sites.points[a] < sites.points[b]; });
  if (start == Start::fan) sort_around_first(sites, order);
  std::size_t apex = 2;
  while (apex < order.size() && sites.orient(order[0], order[1], order[apex]) == Sign::zero) ++apex;
  if (apex >= order.size()) throw Abandon(Outcome::inconsistent_predicate, "all sites are collinear");
  Growth growth(sites);
  growth.begin(std::span(order).first(apex), order[apex]);
  for (const Index site : std::span(order).subspan(apex + 1)) growth.add(site);
  return std::move(growth).triangles();
}

std::uint64_t flip_at_random(const Sites& sites, EdgeMesh& mesh, std::uint64_t attempts, std::uint64_t seed,
                             std::span<const char> fixed) {
  if (mesh.edges() == 0) return 0;
  Random random(seed);
  std::uint64_t flips = 0;
  for (; attempts > 0; --attempts) {
    const auto edge = static_cast<Index>(random.below(mesh.edges()));
    if (!mesh.is_inner(edge) || (!fixed.empty() && fixed[edge] != 0)) continue;
    if (!is_strictly_convex(sites, quadrilateral(mesh, edge))) continue;
    mesh.flip(edge);
    ++flips;
  }
  return flips;
}

}  // namespace tribunal
