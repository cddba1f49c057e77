#include "tests/faults/flips.hpp"
#include "tests/faults/mesh_map.hpp"
#include "tests/faults/plants.hpp"

namespace tribunal::faults {
namespace {

using verify::FaultKind;

std::vector<std::uint32_t> corners_of(const Triangle& t) { return {t.begin(), t.end()}; }

/// The other diagonal of four points that are not cocircular.
std::optional<Planted> flipped_edge(const Sample& sample, Random& random) {
  const MeshMap map(sample.triangles);
  const auto& p = sample.points;
  const auto side = pick(map.interior(), random, [&](const Side& s) {
    const Side other = *map.across(s);
    return is_flippable(p, s, other) && in_circle(p[s.from], p[s.to], p[s.apex], p[other.apex]) != 0;
  });
  if (!side) return std::nullopt;
  const Side across = *map.across(*side);
  Planted planted{sample.points, sample.triangles};
  flip(planted.triangles, *side, across);
  planted.expected = {finding(FaultKind::non_delaunay, {side->triangle, across.triangle},
                              {side->apex, across.apex, side->from, side->to})};
  return planted;
}

/// Takes out triangles that share edges with one another and none with the hull.
std::optional<Planted> make_hole(const Sample& sample, Random& random, std::size_t size) {
  const MeshMap map(sample.triangles);
  const auto inner = [&](std::uint32_t t) { return map.neighbours(sample.triangles[t]).size() == 3; };
  const auto first = pick(numbers(sample.triangles), random, inner);
  if (!first) return std::nullopt;
  std::set<std::uint32_t> lost{*first}, rim;
  while (lost.size() < size) {
    std::vector<std::uint32_t> next;
    for (const std::uint32_t t : lost)
      for (const std::uint32_t n : map.neighbours(sample.triangles[t]))
        if (!lost.contains(n) && inner(n)) next.push_back(n);
    if (next.empty()) return std::nullopt;
    lost.insert(*pick(next, random));
  }
  const Remains remains = without(sample.triangles, lost);
  std::set<std::uint32_t> around, corners;
  for (const std::uint32_t t : lost)
    for (std::size_t i = 0; i < 3; ++i) {
      const Triangle& triangle = sample.triangles[t];
      const Side side{triangle[i], triangle[(i + 1) % 3], t, triangle[(i + 2) % 3]};
      const std::uint32_t beyond = map.across(side)->triangle;
      if (lost.contains(beyond)) continue;
      around.insert(remains.number[beyond]);
      corners.insert({side.from, side.to});
    }
  Planted planted{sample.points, remains.triangles};
  planted.expected = {
      finding(FaultKind::not_connected, {around.begin(), around.end()}, {corners.begin(), corners.end()}),
      finding(FaultKind::wrong_count, {}, {})};
  // Where the hole touches the hull it splits a fan; where it surrounds a vertex that becomes a missing site.
  planted.alongside = {FaultKind::non_manifold_vertex, FaultKind::missing_site};
  return planted;
}

std::optional<Planted> missing_triangle(const Sample& sample, Random& random) {
  return make_hole(sample, random, 1);
}
std::optional<Planted> hole(const Sample& sample, Random& random) {
  return make_hole(sample, random, 2 + random.below(3));
}

std::optional<Planted> doubled_triangle(const Sample& sample, Random& random) {
  const std::uint32_t t = *pick(numbers(sample.triangles), random);
  Planted planted{sample.points, sample.triangles};
  const Triangle& corners = sample.triangles[t];
  planted.triangles.push_back({corners[1], corners[2], corners[0]});
  planted.expected = {finding(FaultKind::doubled_triangle,
                              {t, static_cast<std::uint32_t>(sample.triangles.size())}, corners_of(corners)),
                      finding(FaultKind::wrong_count, {}, {})};
  return planted;
}

std::optional<Planted> inverted_triangle(const Sample& sample, Random& random) {
  const std::uint32_t t = *pick(numbers(sample.triangles), random);
  Planted planted{sample.points, sample.triangles};
  std::swap(planted.triangles[t][0], planted.triangles[t][1 + random.below(2)]);
  planted.expected = {finding(FaultKind::wrong_orientation, {t}, corners_of(sample.triangles[t]))};
  return planted;
}

std::optional<Planted> mirrored_mesh(const Sample& sample, Random&) {
  Planted planted{sample.points, sample.triangles};
  for (LatticePoint& p : planted.points) p.x = -p.x;
  for (std::uint32_t t = 0; t < sample.triangles.size(); ++t)
    planted.expected.push_back(finding(FaultKind::wrong_orientation, {t}, corners_of(sample.triangles[t])));
  return planted;
}

std::optional<Planted> lost_hull_triangle(const Sample& sample, Random& random) {
  const MeshMap map(sample.triangles);
  const auto side = pick(map.hull(), random, [&](const Side& s) {
    return sample.triangles.size() > 1 && map.neighbours(sample.triangles[s.triangle]).size() == 2;
  });
  if (!side) return std::nullopt;
  const Remains remains = without(sample.triangles, {side->triangle});
  Planted planted{sample.points, remains.triangles};
  planted.expected = {finding(FaultKind::hull_mismatch, {}, {side->from, side->to}),
                      finding(FaultKind::wrong_count, {}, {})};
  for (const std::uint32_t end : {side->from, side->to}) {
    const Triangle corners =
        end == side->from ? Triangle{end, side->apex, side->to} : Triangle{side->apex, end, side->from};
    const Side inner = end == side->from ? Side{side->apex, end, side->triangle, corners[2]}
                                         : Side{end, side->apex, side->triangle, corners[2]};
    planted.expected.push_back(
        finding(FaultKind::hull_mismatch, {remains.number[map.across(inner)->triangle]}, {end, side->apex}));
  }
  planted.alongside = {FaultKind::non_manifold_vertex, FaultKind::not_connected};
  return planted;
}

std::optional<Planted> wrong_neighbour(const Sample& sample, Random& random) {
  Planted planted{sample.points, sample.triangles, neighbours_of(sample.triangles)};
  const auto count = static_cast<std::uint32_t>(sample.triangles.size());
  const std::uint32_t t = *pick(numbers(sample.triangles), random);
  const std::size_t corner = random.below(3);
  const std::uint32_t right = planted.neighbours[t][corner];
  const std::uint32_t wrong =
      *pick(std::vector<std::uint32_t>{verify::no_neighbour, count + 5, t, (t + 1) % count,
                                       static_cast<std::uint32_t>(random.below(count))},
            random, [right](std::uint32_t n) { return n != right; });
  planted.neighbours[t][corner] = wrong;
  std::vector<std::uint32_t> named{t};
  if (wrong < count) named.push_back(wrong);
  const Triangle& corners = sample.triangles[t];
  planted.expected = {
      finding(FaultKind::wrong_neighbour, named, {corners[(corner + 1) % 3], corners[(corner + 2) % 3]})};
  return planted;
}

std::optional<Planted> repeated_corner(const Sample& sample, Random& random) {
  const std::uint32_t t = *pick(numbers(sample.triangles), random);
  Planted planted{sample.points, sample.triangles};
  planted.triangles.push_back({sample.triangles[t][0], sample.triangles[t][1], sample.triangles[t][0]});
  planted.expected = {
      finding(FaultKind::repeated_corner, {static_cast<std::uint32_t>(sample.triangles.size())},
              {sample.triangles[t][0]}),
      finding(FaultKind::wrong_count, {}, {})};
  return planted;
}

std::optional<Planted> index_beyond(const Sample& sample, Random& random) {
  const std::uint32_t t = *pick(numbers(sample.triangles), random);
  Planted planted{sample.points, sample.triangles};
  const auto beyond = static_cast<std::uint32_t>(sample.points.size() + random.below(3));
  planted.triangles.push_back({sample.triangles[t][0], beyond, sample.triangles[t][1]});
  planted.expected = {
      finding(FaultKind::index_out_of_range, {static_cast<std::uint32_t>(sample.triangles.size())}, {beyond}),
      finding(FaultKind::wrong_count, {}, {})};
  return planted;
}

constexpr std::array on_triangles{Plant{"flipped_edge", flipped_edge},
                                  Plant{"missing_triangle", missing_triangle},
                                  Plant{"hole", hole},
                                  Plant{"doubled_triangle", doubled_triangle},
                                  Plant{"inverted_triangle", inverted_triangle},
                                  Plant{"mirrored_mesh", mirrored_mesh},
                                  Plant{"lost_hull_triangle", lost_hull_triangle},
                                  Plant{"wrong_neighbour", wrong_neighbour},
                                  Plant{"repeated_corner", repeated_corner},
                                  Plant{"index_beyond", index_beyond}};

}  // namespace

std::span<const Plant> triangle_plants() { return on_triangles; }

}  // namespace tribunal::faults
