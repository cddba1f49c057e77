// Experiment `tau-over-orders`: the distribution of tau over many insertion orders of one point set.
#pragma once

#include "bench/experiments/experiment.hpp"

#include <array>

namespace tribunal::bench {

/// Triangulates one point set in `orders` orders, with seeds order_seed, order_seed + 1, ..., so that any of
/// them can be run again as a cell of its own. Every mesh is verified; the first that is wrong ends the
/// experiment with its outcome.
///
/// Counters: `orders`, `sites`, `tau_mean`, `tau_sd`, `tau_min`, `tau_max`, `tau_with_ghosts_mean`,
/// `tau_bound` (Barth, eq. 3.3.0) and `exceeding`, the number of orders with tau > tau_bound.
Finding run_tau_over_orders(const Cell& cell);

std::vector<std::string_view> algorithm_names();

namespace tau_over_orders {
inline constexpr Parameter algorithm{.name = "algorithm",
                                     .summary = "the incremental algorithm that inserts",
                                     .standard = "green-sibson",
                                     .choices = algorithm_names};
inline constexpr Parameter orders{.name = "orders",
                                  .summary = "how many insertion orders",
                                  .standard = "100",
                                  .least = 2,
                                  .most = 1'000'000};
inline constexpr std::array parameters{algorithm, orders};
}  // namespace tau_over_orders

inline constexpr Experiment tau_over_orders_experiment{
    .name = "tau-over-orders",
    .cites = "Guibas, Knuth, Sharir 1992",
    .summary = "mean and spread of tau over many insertion orders of one point set",
    .reads = {.backend = true, .dataset = true, .bits = true, .seed = true, .order = true},
    .parameters = tau_over_orders::parameters,
    .run = run_tau_over_orders,
};

}  // namespace tribunal::bench
