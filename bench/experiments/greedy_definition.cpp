// Experiment `greedy-definition`: the greedy triangulation against its definition (Barth, section 3.4).
//
// One set of integer points in [0, 2^bits)^2, bits <= 24. By definition, in 64-bit integers: all pairs sorted
// by squared length, then by index; the first is accepted, those that meet it in more than an end leave the
// pool, and so on. Against that stand the edges, in order, that the three methods find with the backend under
// trial. Then the points are renumbered at random and triangulated again. At most 400 sites.
//
// Counters: `sets` (1); `planar` (1, or 0 where all are on a line and there is nothing to triangulate);
// `sites`, `hull` (on the hull's boundary, collinear ones included, by the exact checker), `pairs`,
// `candidates` (taken from the pool before Euler's formula was satisfied), `edges`, `euler_edges` = 3n - 3 -
// hull; `wrong.list`, `wrong.stars`, `wrong.delaunay`: edges out of place; `tied` (pairs as long as the pair
// before); `renumbered` (1 where renumbering changed the set of edges).
#include "algorithms/verify/verify.hpp"
#include "bench/experiments/greedy_methods.hpp"
#include "bench/experiments/lattice_sites.hpp"
#include "bench/experiments/listed.hpp"
#include "datasets/random.hpp"

#include <algorithm>
#include <set>
#include <tuple>

namespace tribunal::bench {
namespace {

constexpr std::size_t most_sites = 400;
using Sites = std::vector<LatticeSite>;

/// Whether p lies on the closed segment ab.
bool is_on(const LatticeSite& a, const LatticeSite& b, const LatticeSite& p) {
  return doubled_area(a, b, p) == 0 && (p.x - a.x) * (p.x - b.x) + (p.y - a.y) * (p.y - b.y) <= 0;
}

bool have_strictly_different_signs(std::int64_t s, std::int64_t t) {
  return (s < 0 && t > 0) || (s > 0 && t < 0);
}

/// Whether two different pairs meet in more than a common end.
bool meet(const Sites& sites, const Edge& e, const Edge& f) {
  const auto is_end = [](Index v, const Edge& edge) { return v == edge[0] || v == edge[1]; };
  const LatticeSite &a = sites[e[0]], &b = sites[e[1]], &c = sites[f[0]], &d = sites[f[1]];
  for (const Index v : f)
    if (!is_end(v, e) && is_on(a, b, sites[v])) return true;
  for (const Index v : e)
    if (!is_end(v, f) && is_on(c, d, sites[v])) return true;
  return have_strictly_different_signs(doubled_area(a, b, c), doubled_area(a, b, d)) &&
         have_strictly_different_signs(doubled_area(c, d, a), doubled_area(c, d, b));
}

using Pool = std::vector<std::pair<std::int64_t, Edge>>;  // squared lengths, sorted

Pool all_pairs(const Sites& sites) {
  Pool pool;
  for (Index a = 0; a < sites.size(); ++a)
    for (Index b = a + 1; b < sites.size(); ++b) {
      const std::int64_t x = sites[a].x - sites[b].x, y = sites[a].y - sites[b].y;
      pool.push_back({x * x + y * y, {a, b}});
    }
  std::sort(pool.begin(), pool.end());
  return pool;
}

/// A pair with a site inside meets the shorter pairs that it is made of, or what kept these out.
std::vector<Edge> edges_by_definition(const Sites& sites, Pool pool) {
  std::vector<Edge> edges;
  while (!pool.empty()) {
    const Edge accepted = pool.front().second;
    edges.push_back(accepted);
    std::erase_if(pool, [&](const auto& pair) {
      return pair.second == accepted || meet(sites, accepted, pair.second);
    });
  }
  return edges;
}

double out_of_place(const std::vector<Edge>& found, const std::vector<Edge>& expected) {
  double wrong = 0;
  for (std::size_t i = 0; i < std::max(found.size(), expected.size()); ++i)
    wrong += i >= found.size() || i >= expected.size() || found[i] != expected[i];
  return wrong;
}

/// Whether the edges are others when the sites are numbered otherwise.
bool depends_on_numbers(const LatticeSet& set, const std::vector<Edge>& expected, std::uint64_t seed) {
  std::vector<Index> renumbered(set.sites.size());
  std::iota(renumbered.begin(), renumbered.end(), Index{0});
  Random(seed).shuffle(std::span(renumbered));
  Sites sites;
  for (const Index v : renumbered) sites.push_back(set.sites[v]);
  std::set<Edge> edges(expected.begin(), expected.end());
  for (const auto& [a, b] : edges_by_definition(sites, all_pairs(sites)))
    edges.erase(undirected(renumbered[a], renumbered[b]));
  return !edges.empty();
}

Finding run_greedy_definition(const Cell& cell) {
  if (cell.bits < 1 || cell.bits > most_lattice_bits) return {Outcome::refused_input, "bits is 1 to 24"};
  const LatticeSet set(cell);
  if (set.sites.size() > most_sites) return {Outcome::refused_input, "more than 400 sites"};
  if (!set.planar) return {.counters = {{"sets", 1}, {"planar", 0}}};
  const Kernel2Binding binding = cell_kernel(set.points, cell);
  if (const auto* refusal = std::get_if<Refusal>(&binding))
    return {Outcome::out_of_domain, describe(*refusal)};
  const auto answers = greedy_answers({{set.points, set.order, *std::get<0>(binding)}});
  const Pool pool = all_pairs(set.sites);
  const std::vector<Edge> expected = edges_by_definition(set.sites, pool);
  const auto verdict = verify::verify_planar(set.points, {.triangles = answers[2].triangles},
                                             {.kind = verify::Kind::triangulation, .max_faults = 1});
  if (!verdict.valid()) return {Outcome::invalid_topology, verdict.faults.front().detail};
  const auto n = static_cast<double>(set.sites.size());
  double tied = 0;
  for (std::size_t i = 1; i < pool.size(); ++i) tied += pool[i].first == pool[i - 1].first;
  return {.counters = {{"sets", 1},
                       {"planar", 1},
                       {"sites", n},
                       {"hull", static_cast<double>(verdict.hull)},
                       {"pairs", static_cast<double>(pool.size())},
                       {"candidates", static_cast<double>(answers[0].found.candidates)},
                       {"edges", static_cast<double>(expected.size())},
                       {"euler_edges", 3 * n - 3 - static_cast<double>(verdict.hull)},
                       {"wrong.list", out_of_place(answers[0].found.edges, expected)},
                       {"wrong.stars", out_of_place(answers[1].found.edges, expected)},
                       {"wrong.delaunay", out_of_place(answers[2].found.edges, expected)},
                       {"tied", tied},
                       {"renumbered", depends_on_numbers(set, expected, cell.seed)}}};
}

}  // namespace

constinit const Experiment greedy_definition_experiment{
    .name = "greedy-definition",
    .cites = "Barth, section 3.4",
    .summary = "the edges of the greedy triangulation, three ways, against its definition",
    .reads = {.backend = true, .dataset = true, .bits = true, .seed = true},
    .parameters = {},
    .run = run_greedy_definition,
};

}  // namespace tribunal::bench
