#include "tests/faults/flips.hpp"
#include "tests/faults/mesh_map.hpp"
#include "tests/faults/plants.hpp"

namespace tribunal::faults {
namespace {

using verify::FaultKind;

const Kinds overlap_kinds{FaultKind::folded_edge,    FaultKind::non_manifold_edge,
                          FaultKind::crossing_edges, FaultKind::non_manifold_vertex,
                          FaultKind::hull_mismatch,  FaultKind::not_connected,
                          FaultKind::wrong_count,    FaultKind::doubled_triangle,
                          FaultKind::non_delaunay,   FaultKind::missing_site};

/// Of two triangles one is flipped and the other is not: their diagonals cross.
std::optional<Planted> crossing_edges(const Sample& sample, Random& random) {
  const MeshMap map(sample.triangles);
  const auto side = pick(map.interior(), random,
                         [&](const Side& s) { return is_flippable(sample.points, s, *map.across(s)); });
  if (!side) return std::nullopt;
  const Side across = *map.across(*side);
  Planted planted{sample.points, sample.triangles};
  planted.triangles[across.triangle] = {across.apex, side->to, side->apex};
  planted.expected = {finding(FaultKind::crossing_edges, {side->triangle, across.triangle},
                              {side->from, side->to, side->apex, across.apex})};
  planted.alongside = overlap_kinds;
  return planted;
}

/// One more triangle on an edge of the hull, over those that are there.
std::optional<Planted> fold_over(const Sample& sample, Random& random) {
  const MeshMap map(sample.triangles);
  const auto side = pick(map.hull(), random);
  const auto apex = pick(distinct_sites(sample.points), random, [&](std::uint32_t v) {
    return v != side->apex && area(sample.points[side->from], sample.points[side->to], sample.points[v]) > 0;
  });
  if (!apex) return std::nullopt;
  Planted planted{sample.points, sample.triangles};
  const auto added = static_cast<std::uint32_t>(sample.triangles.size());
  planted.triangles.push_back({side->from, side->to, *apex});
  planted.expected = {finding(FaultKind::folded_edge, {side->triangle, added}, {side->from, side->to})};
  planted.alongside = overlap_kinds;
  return planted;
}

/// A triangulation of all sites but one lies over the mesh.
std::optional<Planted> two_sheets(const Sample& sample, Random& random) {
  const auto lost = pick(MeshMap(sample.triangles).interior_vertices(), random);
  if (!lost) return std::nullopt;
  std::vector<std::uint32_t> sites = distinct_sites(sample.points);
  std::erase(sites, *lost);
  Planted planted{sample.points, sample.triangles};
  for (const Triangle& t : triangulate_by_definition(sample.points, sites, random))
    planted.triangles.push_back(t);
  const std::set<Finding> naive = naive_findings(planted.points, planted.triangles);
  std::copy_if(naive.begin(), naive.end(), std::back_inserter(planted.expected), [](const Finding& f) {
    return f.kind == FaultKind::non_manifold_edge || f.kind == FaultKind::folded_edge;
  });
  planted.alongside = overlap_kinds;
  return planted;
}

/// A triangle without area on three sites in line on the hull.
std::optional<Planted> flat_triangle(const Sample& sample, Random& random) {
  const MeshMap map(sample.triangles);
  const auto& p = sample.points;
  std::vector<std::pair<Side, Side>> straight;
  for (const Side& first : map.hull())
    for (const Side& second : map.hull())
      if (first.to == second.from && area(p[first.from], p[first.to], p[second.to]) == 0)
        straight.emplace_back(first, second);
  const auto found = pick(straight, random);
  if (!found) return std::nullopt;
  const auto& [first, second] = *found;
  Planted planted{sample.points, sample.triangles};
  const auto added = static_cast<std::uint32_t>(sample.triangles.size());
  planted.triangles.push_back({second.to, first.to, first.from});
  planted.expected = {finding(FaultKind::flat_triangle, {added}, {first.from, first.to, second.to}),
                      finding(FaultKind::wrong_count, {}, {})};
  planted.alongside = {FaultKind::hull_mismatch};
  return planted;
}

/// The mesh and a copy of it on its right, which has its points to itself or shares one of them.
Planted side_by_side(const Sample& sample, bool touching) {
  const std::vector<std::uint32_t> sites = distinct_sites(sample.points);
  const auto before = [&](std::uint32_t a, std::uint32_t b) { return sample.points[a] < sample.points[b]; };
  const std::uint32_t first = *std::min_element(sites.begin(), sites.end(), before);
  const std::uint32_t last = *std::max_element(sites.begin(), sites.end(), before);
  const LatticePoint from = sample.points[first], to = sample.points[last];

  Planted planted{sample.points, sample.triangles};
  const auto offset = static_cast<std::uint32_t>(sample.points.size());
  for (const LatticePoint& p : sample.points)
    planted.points.push_back({p.x + to.x - from.x + (touching ? 0 : 1), p.y + to.y - from.y});
  for (Triangle t : sample.triangles) {
    for (std::uint32_t& corner : t) corner = touching && corner == first ? last : corner + offset;
    planted.triangles.push_back(t);
  }
  planted.expected = {
      finding(FaultKind::not_connected, {0, static_cast<std::uint32_t>(sample.triangles.size())}, {})};
  planted.alongside = {FaultKind::hull_mismatch, FaultKind::wrong_count};
  return planted;
}

std::optional<Planted> two_pieces(const Sample& sample, Random&) { return side_by_side(sample, false); }

std::optional<Planted> touching_pieces(const Sample& sample, Random&) {
  Planted planted = side_by_side(sample, true);
  const auto shared = static_cast<std::uint32_t>(
      std::max_element(sample.points.begin(), sample.points.end()) - sample.points.begin());
  const auto first_at_shared = [&](std::size_t begin) {
    const auto found = std::find_if(
        planted.triangles.begin() + static_cast<std::ptrdiff_t>(begin), planted.triangles.end(),
        [shared](const Triangle& t) { return std::find(t.begin(), t.end(), shared) != t.end(); });
    return static_cast<std::uint32_t>(found - planted.triangles.begin());
  };
  planted.expected.push_back(finding(FaultKind::non_manifold_vertex,
                                     {first_at_shared(0), first_at_shared(sample.triangles.size())},
                                     {shared}));
  return planted;
}

constexpr std::array on_sheets{
    Plant{"crossing_edges", crossing_edges}, Plant{"fold_over", fold_over},
    Plant{"two_sheets", two_sheets},         Plant{"flat_triangle", flat_triangle},
    Plant{"two_pieces", two_pieces},         Plant{"touching_pieces", touching_pieces}};

}  // namespace

std::span<const Plant> sheet_plants() { return on_sheets; }

}  // namespace tribunal::faults
