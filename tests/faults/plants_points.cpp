#include "tests/faults/mesh_map.hpp"
#include "tests/faults/plants.hpp"

namespace tribunal::faults {
namespace {

using verify::FaultKind;

std::vector<LatticePoint> scaled(std::vector<LatticePoint> points, std::int64_t factor) {
  for (LatticePoint& p : points) p = {factor * p.x, factor * p.y};
  return points;
}

/// Expects what the definition says of each triangle: clockwise, flat or neither.
void expect_orientations(Planted& planted) {
  for (std::uint32_t t = 0; t < planted.triangles.size(); ++t) {
    const Triangle& c = planted.triangles[t];
    const Wide turn = area(planted.points[c[0]], planted.points[c[1]], planted.points[c[2]]);
    if (turn < 0)
      planted.expected.push_back(finding(FaultKind::wrong_orientation, {t}, {c.begin(), c.end()}));
    if (turn == 0) planted.expected.push_back(finding(FaultKind::flat_triangle, {t}, {c.begin(), c.end()}));
  }
}

const Kinds tangle{FaultKind::folded_edge,         FaultKind::non_manifold_edge, FaultKind::crossing_edges,
                   FaultKind::non_manifold_vertex, FaultKind::hull_mismatch,     FaultKind::not_connected,
                   FaultKind::flat_triangle,       FaultKind::wrong_orientation, FaultKind::non_delaunay};

/// A triangulation of all sites but an inner one.
std::optional<Planted> missing_site(const Sample& sample, Random& random) {
  const auto lost = pick(MeshMap(sample.triangles).interior_vertices(), random);
  if (!lost) return std::nullopt;
  std::vector<std::uint32_t> sites = distinct_sites(sample.points);
  std::erase(sites, *lost);
  Planted planted{sample.points, triangulate_by_definition(sample.points, sites, random)};
  planted.expected = {finding(FaultKind::missing_site, {}, {*lost}), finding(FaultKind::wrong_count, {}, {})};
  return planted;
}

/// One more point, beyond the hull.
std::optional<Planted> extra_site(const Sample& sample, Random& random) {
  Planted planted{sample.points, sample.triangles};
  LatticePoint corner = sample.points[0];
  for (const LatticePoint& p : sample.points) corner = {std::max(corner.x, p.x), std::max(corner.y, p.y)};
  const auto extra = static_cast<std::uint32_t>(sample.points.size());
  planted.points.push_back({corner.x + 1 + static_cast<std::int64_t>(random.below(9)),
                            corner.y + 1 + static_cast<std::int64_t>(random.below(9))});
  planted.expected = {finding(FaultKind::missing_site, {}, {extra}), finding(FaultKind::wrong_count, {}, {})};
  planted.alongside = {FaultKind::hull_mismatch};
  return planted;
}

/// A triangle that uses a later copy of its corner.
std::optional<Planted> duplicate_used(const Sample& sample, Random& random) {
  Planted planted{sample.points, sample.triangles};
  const std::uint32_t t = *pick(numbers(sample.triangles), random);
  const std::size_t corner = random.below(3);
  const std::uint32_t original = sample.triangles[t][corner];
  const auto copy = static_cast<std::uint32_t>(sample.points.size());
  planted.points.push_back(sample.points[original]);
  planted.triangles[t][corner] = copy;
  planted.expected = {finding(FaultKind::duplicate_used, {t}, {copy, original})};
  return planted;
}

/// Two sites change their names, in the triangles only. No fault when every triangle still turns the right
/// way.
std::optional<Planted> swapped_ids(const Sample& sample, Random& random) {
  const std::vector<std::uint32_t> sites = distinct_sites(sample.points);
  const std::uint32_t a = *pick(sites, random), b = *pick(sites, random);
  Planted planted{sample.points, sample.triangles};
  for (Triangle& t : planted.triangles)
    for (std::uint32_t& corner : t) corner = corner == a ? b : corner == b ? a : corner;
  expect_orientations(planted);
  if (planted.expected.empty()) return std::nullopt;
  planted.alongside = tangle;
  return planted;
}

/// An inner vertex is moved across the edge opposite in one of its triangles, to the middle of the triangle
/// beyond.
std::optional<Planted> moved_vertex(const Sample& sample, Random& random) {
  const MeshMap map(sample.triangles);
  const auto side = pick(map.interior(), random, [&](const Side& s) { return !map.on_hull(s.apex); });
  if (!side) return std::nullopt;
  // Later copies would stay behind and be sites of their own.
  const auto& moved = sample.points[side->apex];
  if (std::count(sample.points.begin(), sample.points.end(), moved) > 1) return std::nullopt;
  Planted planted{scaled(sample.points, 3), sample.triangles};
  LatticePoint middle{0, 0};
  for (const std::uint32_t corner : {side->from, side->to, map.across(*side)->apex})
    middle = {middle.x + sample.points[corner].x, middle.y + sample.points[corner].y};
  planted.points[side->apex] = middle;
  expect_orientations(planted);
  planted.alongside = tangle;
  return planted;
}

/// A vertex in the middle of an edge, of which only the triangles on one side know.
std::optional<Planted> t_junction(const Sample& sample, Random& random) {
  const MeshMap map(sample.triangles);
  const auto side = pick(map.interior(), random);
  if (!side) return std::nullopt;
  Planted planted{scaled(sample.points, 2), sample.triangles};
  const LatticePoint from = sample.points[side->from], to = sample.points[side->to];
  const auto middle = static_cast<std::uint32_t>(planted.points.size());
  const auto added = static_cast<std::uint32_t>(planted.triangles.size());
  planted.points.push_back({from.x + to.x, from.y + to.y});
  planted.triangles[side->triangle] = {side->apex, side->from, middle};
  planted.triangles.push_back({side->apex, middle, side->to});
  const std::uint32_t whole = map.across(*side)->triangle;
  planted.expected = {
      finding(FaultKind::not_connected, {side->triangle, added, whole}, {side->from, side->to, middle}),
      finding(FaultKind::crossing_edges, {std::min(side->triangle, added), whole},
              {side->from, side->to, middle}),
      finding(FaultKind::wrong_count, {}, {})};
  // Where the slit reaches the hull it splits a fan.
  planted.alongside = {FaultKind::non_delaunay, FaultKind::non_manifold_vertex};
  return planted;
}

constexpr std::array on_points{Plant{"missing_site", missing_site},     Plant{"extra_site", extra_site},
                               Plant{"duplicate_used", duplicate_used}, Plant{"swapped_ids", swapped_ids},
                               Plant{"moved_vertex", moved_vertex},     Plant{"t_junction", t_junction}};

}  // namespace

std::span<const Plant> point_plants() { return on_points; }

}  // namespace tribunal::faults
