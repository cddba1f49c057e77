// Experiment `sorting`: a Delaunay triangulation of sites on a parabola sorts them.
//
// The sites (x, x^2) for x = 0, ..., n - 1 in random order are triangulated; each is on the hull, and walking
// round the hull from the leftmost one must meet them in the order of x. An algorithm that learns of its
// sites by signs alone, three outcomes each, therefore needs log_3 n! of them for most orders: N log N times
// a constant (Barth, section 3.3c).
//
// Counters: `runs` = 1, `sorted` (1 or 0), `tests` (predicate calls), `least_tests` = log_3 n!, `short` (1
// where there were fewer tests than that), `n_log_n` = n log_2 n.
#include "algorithms/triangulate.hpp"
#include "bench/experiments/listed.hpp"
#include "bench/experiments/name_parameters.hpp"
#include "bench/input.hpp"
#include "datasets/random.hpp"
#include "predicates/counted.hpp"

#include <array>
#include <cmath>
#include <numeric>
#include <unordered_set>
#include <vector>

namespace tribunal::bench {
namespace {

constexpr std::array parameters{algorithm_parameter};
constexpr std::uint64_t most_sites = std::uint64_t{1} << 24;

/// For each site of a triangulation the next one counter-clockwise along the hull.
std::vector<Index> hull_successors(const Triangulation& t, std::size_t sites) {
  const auto key = [](Index from, Index to) { return std::uint64_t{from} << 32 | to; };
  std::unordered_set<std::uint64_t> edges;
  for (const Triangle& triangle : t.triangles)
    for (int i = 0; i < 3; ++i) edges.insert(key(triangle[i], triangle[(i + 1) % 3]));
  std::vector<Index> next(sites, 0);
  for (const std::uint64_t edge : edges) {
    const auto from = static_cast<Index>(edge >> 32), to = static_cast<Index>(edge);
    if (!edges.contains(key(to, from))) next[from] = to;
  }
  return next;
}

bool sorts(const Triangulation& t, const std::vector<Point2>& points) {
  const std::vector<Index> next = hull_successors(t, points.size());
  Index at = 0;
  while (points[at][0] != 0) ++at;
  for (std::size_t x = 1; x < points.size(); ++x) {
    at = next[at];
    if (points[at][0] != static_cast<double>(x)) return false;
  }
  return true;
}

std::vector<Point2> shuffled_parabola(std::uint64_t n, std::uint64_t seed) {
  std::vector<Point2> points(n);
  for (std::uint64_t x = 0; x < n; ++x) points[x] = {static_cast<double>(x), static_cast<double>(x * x)};
  Random(seed).shuffle(std::span(points));
  return points;
}

Finding run_sorting(const Cell& cell) {
  if (cell.n < 3 || cell.n > most_sites) return {Outcome::refused_input, "n is from 3 to 2^24"};
  const std::vector<Point2> points = shuffled_parabola(cell.n, cell.seed);
  const Kernel2Binding binding = cell_kernel(points, cell);
  if (const auto* refusal = std::get_if<Refusal>(&binding))
    return {Outcome::out_of_domain, describe(*refusal)};
  std::vector<Index> order(points.size());
  std::iota(order.begin(), order.end(), Index{0});
  PredicateCounts calls;
  const Triangulation t =
      triangulate(points, order, CountedKernel2(*std::get<0>(binding), calls), chosen_algorithm(cell));
  if (t.outcome != Outcome::ok) return {t.outcome, t.reason};

  const auto n = static_cast<double>(cell.n), tests = static_cast<double>(calls.total());
  const double least = std::lgamma(n + 1) / std::log(3);
  return {.counters = {{"runs", 1},
                       {"sorted", sorts(t, points) ? 1.0 : 0.0},
                       {"tests", tests},
                       {"least_tests", least},
                       {"short", tests < least ? 1.0 : 0.0},
                       {"n_log_n", n * std::log2(n)}}};
}

}  // namespace

constinit const Experiment sorting_experiment{
    .name = "sorting",
    .cites = "Barth, section 3.3c",
    .summary = "a triangulation of sites on a parabola sorts them, and takes as many tests as sorting does",
    .reads = {.backend = true, .n = true, .seed = true},
    .parameters = parameters,
    .run = run_sorting,
};

}  // namespace tribunal::bench
