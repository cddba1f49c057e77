// Experiment `precedence`: how often three given sites come before j others in a random order.
//
// P(j) = 3! j! / (j+3)! = 6 / ((j+1)(j+2)(j+3)) (Barth, section 3.3c): the chance that a triple becomes a
// triangle before the j sites in its circle can prevent it. Twice: over all (j+3)! orders for j up to 5,
// where the fraction must be exact; and over n random orders of `others` + 3 labels, each of which tells
// whether the three come before the first j others, for every j.
//
// Counters: `wrong` fractions among the exact ones; `orders`; `before.j`, the random orders with the three
// before the first j others; `deviation`, the largest of |before.j - n P(j)| in binomial standard deviations.
#include "bench/experiments/listed.hpp"
#include "datasets/random.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <vector>

namespace tribunal::bench {
namespace {

constexpr Parameter others_parameter{.name = "others",
                                     .summary = "how many others there are at most",
                                     .standard = "40",
                                     .least = 1,
                                     .most = 1000};
constexpr std::array parameters{others_parameter};
constexpr std::uint64_t most_others_exactly = 5;

/// 6 / P(j).
std::uint64_t six_over_chance(std::uint64_t j) { return (j + 1) * (j + 2) * (j + 3); }

/// The largest j for which labels 0, 1 and 2 come before labels 3, ..., j + 2.
std::uint64_t others_preceded(const std::vector<std::uint64_t>& order) {
  std::vector<std::uint64_t> place(order.size());
  for (std::uint64_t i = 0; i < order.size(); ++i) place[order[i]] = i;
  const std::uint64_t last = std::max({place[0], place[1], place[2]});
  const auto before = std::find_if(place.begin() + 3, place.end(), [&](std::uint64_t p) { return p < last; });
  return static_cast<std::uint64_t>(before - place.begin()) - 3;
}

bool is_exact(std::uint64_t j) {
  std::vector<std::uint64_t> order(j + 3);
  std::iota(order.begin(), order.end(), std::uint64_t{0});
  std::uint64_t all = 0, preceding = 0;
  do {
    ++all;
    preceding += others_preceded(order) == j;
  } while (std::next_permutation(order.begin(), order.end()));
  return preceding * six_over_chance(j) == 6 * all;
}

Finding run_precedence(const Cell& cell) {
  const std::uint64_t others = whole_number(cell.parameters, others_parameter);
  Finding finding;
  for (std::uint64_t j = 0; j <= std::min(others, most_others_exactly); ++j)
    finding.counters["wrong"] += is_exact(j) ? 0 : 1;

  std::vector<double> before(others + 1, 0);
  std::vector<std::uint64_t> order(others + 3);
  std::iota(order.begin(), order.end(), std::uint64_t{0});
  Random random(cell.seed);
  for (std::uint64_t k = 0; k < cell.n; ++k) {
    random.shuffle(std::span(order));
    const std::uint64_t preceded = others_preceded(order);
    for (std::uint64_t j = 0; j <= preceded; ++j) before[j] += 1;
  }
  const auto n = static_cast<double>(cell.n);
  double deviation = 0;
  for (std::uint64_t j = 0; j <= others; ++j) {
    const double chance = 6 / static_cast<double>(six_over_chance(j));
    finding.counters["before." + std::to_string(j)] = before[j];
    if (j > 0)
      deviation =
          std::max(deviation, std::fabs(before[j] - n * chance) / std::sqrt(n * chance * (1 - chance)));
  }
  finding.counters["orders"] = n;
  finding.counters["deviation"] = deviation;
  return finding;
}

}  // namespace

constinit const Experiment precedence_experiment{
    .name = "precedence",
    .cites = "Barth, section 3.3c",
    .summary = "how often three sites come before j others, over all orders and over random ones",
    .reads = {.n = true, .seed = true},
    .parameters = parameters,
    .run = run_precedence,
};

}  // namespace tribunal::bench
