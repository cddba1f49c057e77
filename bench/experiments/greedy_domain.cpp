// Experiment `greedy-domain`: greedy triangulations of nonconvex domains with constraints.
//
// One set of integer points in [0, 2^bits)^2, bits <= 24. The domain is what is left of the sites' Delaunay
// triangulation when triangles are taken away at random as long as each site keeps one: nonconvex, with
// holes, touching itself in sites. Pairs of sites drawn at random that meet neither one another nor the
// boundary are the constraints, where they run inside. Triangulated three ways with the backend under trial.
// At most 400 sites.
//
// Counters: `sets`, `boundary` and `constraints` (given edges); `lost` (given edges that are not among the
// first accepted); `disagreements` (methods that differ from the first); `area_error` (twice the area of the
// result minus that of the domain, in magnitude: an edge outside would add to it); `inverted` triangles.
#include "algorithms/greedy/conflict.hpp"
#include "algorithms/greedy/domain.hpp"
#include "bench/experiments/greedy_methods.hpp"
#include "bench/experiments/lattice_sites.hpp"
#include "bench/experiments/listed.hpp"
#include "datasets/random.hpp"

#include <algorithm>
#include <cmath>
#include <set>

namespace tribunal::bench {
namespace {

constexpr std::size_t most_sites = 400;

/// Takes triangles away, each with probability two thirds where that leaves no site without one.
void thin_out(std::vector<Triangle>& triangles, std::size_t sites, Random& random) {
  std::vector<int> uses(sites, 0);
  for (const Triangle& t : triangles)
    for (const Index v : t) ++uses[v];
  random.shuffle(std::span(triangles));
  std::erase_if(triangles, [&](const Triangle& t) {
    const bool needed = std::any_of(t.begin(), t.end(), [&](Index v) { return uses[v] == 1; });
    if (needed || random.below(3) == 0) return false;
    for (const Index v : t) --uses[v];
    return true;
  });
}

/// The sides of triangles that have none on their other side.
std::vector<Edge> boundary_of(const std::vector<Triangle>& triangles) {
  std::set<Edge> sides;
  for (const Triangle& t : triangles)
    for (std::size_t i = 0; i < 3; ++i) sides.insert({t[i], t[(i + 1) % 3]});
  std::vector<Edge> boundary;
  for (const Edge& side : sides)
    if (!sides.contains({side[1], side[0]})) boundary.push_back(side);
  return boundary;
}

bool meets_a_site(const PlanarProblem& problem, const Edge& edge) {
  const Point2 &a = problem.points[edge[0]], &b = problem.points[edge[1]];
  return std::any_of(problem.points.begin(), problem.points.end(), [&](const Point2& p) {
    return strictly_between(a, p, b) && problem.kernel.orient2d(a, b, p) == Sign::zero;
  });
}

std::vector<Edge> draw_constraints(const GreedyProblem& bare, std::size_t tries, Random& random) {
  const Domain domain(bare);
  std::vector<Edge> accepted(bare.boundary.begin(), bare.boundary.end()), constraints;
  const std::size_t n = bare.planar.points.size();
  for (; tries > 0; --tries) {
    const auto a = static_cast<Index>(random.below(n)), b = static_cast<Index>(random.below(n));
    const Edge edge = undirected(a, b);
    if (a == b || meets_a_site(bare.planar, edge) || !domain.admits(edge)) continue;
    if (std::any_of(accepted.begin(), accepted.end(), [&](const Edge& other) {
          return undirected(other[0], other[1]) == edge || segments_conflict(bare.planar, other, edge);
        }))
      continue;
    accepted.push_back(edge);
    constraints.push_back(edge);
  }
  return constraints;
}

std::int64_t area_of(const LatticeSet& set, const std::vector<Triangle>& triangles, double& inverted) {
  std::int64_t sum = 0;
  for (const Triangle& t : triangles) {
    const std::int64_t area = doubled_area(set.sites[t[0]], set.sites[t[1]], set.sites[t[2]]);
    inverted += area <= 0;
    sum += area;
  }
  return sum;
}

/// Given edges that are not among as many first accepted ones.
double count_lost(const std::vector<Edge>& edges, std::span<const Edge> boundary,
                  std::span<const Edge> constraints) {
  const auto given = static_cast<std::ptrdiff_t>(boundary.size() + constraints.size());
  const std::set<Edge> first(edges.begin(),
                             edges.begin() + std::min(given, static_cast<std::ptrdiff_t>(edges.size())));
  double lost = 0;
  for (const auto given_edges : {boundary, constraints})
    for (const auto& [a, b] : given_edges) lost += !first.contains(undirected(a, b));
  return lost;
}

Finding run_greedy_domain(const Cell& cell) {
  if (cell.bits < 1 || cell.bits > most_lattice_bits) return {Outcome::refused_input, "bits is 1 to 24"};
  const LatticeSet set(cell);
  if (set.sites.size() > most_sites) return {Outcome::refused_input, "more than 400 sites"};
  if (!set.planar) return {Outcome::refused_input, "all sites are on a line"};
  const Kernel2Binding binding = cell_kernel(set.points, cell);
  if (const auto* refusal = std::get_if<Refusal>(&binding))
    return {Outcome::out_of_domain, describe(*refusal)};
  const PlanarProblem planar{set.points, set.order, *std::get<0>(binding)};

  Random random(cell.seed);
  std::vector<Triangle> domain = find_planar_algorithm("green-sibson")->run(planar).triangles;
  thin_out(domain, set.sites.size(), random);
  const std::vector<Edge> boundary = boundary_of(domain);
  const std::vector<Edge> constraints = draw_constraints({planar, {}, boundary}, set.sites.size(), random);
  const auto answers = greedy_answers({planar, constraints, boundary});

  double inverted = 0, lost = 0, disagreements = 0, area_error = 0;
  const std::int64_t area = area_of(set, domain, inverted);
  for (const GreedyAnswer& answer : answers) {
    lost += count_lost(answer.found.edges, boundary, constraints);
    disagreements += !(answer == answers[0]);
    area_error += std::abs(static_cast<double>(area_of(set, answer.triangles, inverted) - area));
  }
  return {.counters = {{"sets", 1},
                       {"boundary", static_cast<double>(boundary.size())},
                       {"constraints", static_cast<double>(constraints.size())},
                       {"lost", lost},
                       {"disagreements", disagreements},
                       {"area_error", area_error},
                       {"inverted", inverted}}};
}

}  // namespace

constinit const Experiment greedy_domain_experiment{
    .name = "greedy-domain",
    .cites = "Barth, section 3.4",
    .summary = "greedy triangulations of nonconvex domains with constraints, three ways",
    .reads = {.backend = true, .dataset = true, .bits = true, .seed = true},
    .parameters = {},
    .run = run_greedy_domain,
};

}  // namespace tribunal::bench
