// Experiment `tau-over-orders`: the distribution of tau over many insertion orders of one point set.
//
// Triangulates one point set in `orders` orders, with seeds order_seed, order_seed + 1, ..., so that any of
// them can be run again as a cell of its own. Every mesh is verified; the first that is wrong ends the
// experiment with its outcome.
//
// Counters: `orders`, `sites`, `tau_mean`, `tau_sd`, `tau_min`, `tau_max`, `tau_with_ghosts_mean`,
// `tau_bound` (Barth, eq. 3.3.0) and `exceeding`, the number of orders with tau > tau_bound.
#include "algorithms/triangulate.hpp"
#include "bench/experiments/listed.hpp"
#include "bench/experiments/name_parameters.hpp"
#include "bench/experiments/tau_bound.hpp"
#include "bench/input.hpp"
#include "bench/judge.hpp"
#include "bench/statistics.hpp"

#include <algorithm>
#include <array>
#include <vector>

namespace tribunal::bench {
namespace {

constexpr Parameter orders_parameter{.name = "orders",
                                     .summary = "how many insertion orders",
                                     .standard = "100",
                                     .least = 2,
                                     .most = 1'000'000};
constexpr std::array parameters{algorithm_parameter, orders_parameter};

Finding run_tau_over_orders(const Cell& cell) {
  const PlanarAlgorithm& algorithm = chosen_algorithm(cell);
  const std::uint64_t orders = whole_number(cell.parameters, orders_parameter);
  const std::vector<Point2> points = cell_points(cell);
  const Kernel2Binding binding = cell_kernel(points, cell);
  if (const auto* refusal = std::get_if<Refusal>(&binding))
    return {Outcome::out_of_domain, describe(*refusal)};
  const Kernel2& kernel = *std::get<0>(binding);

  std::vector<double> tau, with_ghosts;
  std::size_t sites = 0;
  for (std::uint64_t k = 0; k < orders; ++k) {
    const std::uint64_t seed = cell.order_seed + k;
    const Triangulation t = triangulate(points, cell_order(points, cell, seed), kernel, algorithm);
    Judgement judgement{t.outcome, t.reason};
    if (t.outcome == Outcome::ok) judgement = judge(points, t);
    if (judgement.outcome != Outcome::ok)
      return {judgement.outcome, "order seed " + std::to_string(seed) + ": " + judgement.reason};
    sites = points.size() - t.duplicates.size();
    tau.push_back(static_cast<double>(t.counters.tau));
    with_ghosts.push_back(static_cast<double>(t.counters.tau_with_ghosts));
  }

  const double bound = tau_bound(sites);
  const Summary summary = summarise(tau);
  const auto exceeding = std::count_if(tau.begin(), tau.end(), [&](double value) { return value > bound; });
  return {.counters = {{"orders", static_cast<double>(orders)},
                       {"sites", static_cast<double>(sites)},
                       {"tau_mean", summary.mean},
                       {"tau_sd", summary.sd},
                       {"tau_min", *std::min_element(tau.begin(), tau.end())},
                       {"tau_max", *std::max_element(tau.begin(), tau.end())},
                       {"tau_with_ghosts_mean", summarise(with_ghosts).mean},
                       {"tau_bound", bound},
                       {"exceeding", static_cast<double>(exceeding)}}};
}

}  // namespace

constinit const Experiment tau_over_orders_experiment{
    .name = "tau-over-orders",
    .cites = "Guibas, Knuth, Sharir 1992",
    .summary = "mean and spread of tau over many insertion orders of one point set",
    .reads = {.backend = true, .dataset = true, .bits = true, .seed = true, .order = true},
    .parameters = parameters,
    .run = run_tau_over_orders,
};

}  // namespace tribunal::bench
