// Experiment `knuth-printed`: the sign test of three products as the source prints it, on trial.
//
// The sign of x0 y0 + x1 y1 + x2 y2 by the program printed in Barth's section 3.7, by variants of it with
// one kind of misprint each, and by the corrected one, against 64-bit integers.
//
// Two witnesses, for the product that overwrites instead of adding up and for the carry that does:
// x = (-1,-1,1), y = (0,1,1) and x = (19317,1444,-18836), y = (24311,26904,14696). Counters
// `witness.<i>.exact`, `.printed` and `.corrected` hold their signs as -1, 0, 1.
//
// Then n random cases, |x_i| < 2^28, 0 <= y_i < 2^28: `uniform`, or `near-cancelling` where x2 is the
// rounded quotient -(x0 y0 + x1 y1) / y2 plus -1, 0 or 1 (cases out of range are drawn anew). Counters
// `queries`, `zeros` and `wrong.printed`, `wrong.third_product`, `wrong.carry`, `wrong.late_exits`,
// `wrong.corrected`, `wrong.redundant` (the backend `knuth`'s own).
#include "bench/experiments/listed.hpp"
#include "datasets/random.hpp"
#include "predicates/arithmetic/redundant_as_printed.hpp"
#include "predicates/arithmetic/redundant_integer.hpp"

#include <array>
#include <cstdlib>

namespace tribunal::bench {
namespace {

constexpr Parameter generator_parameter{
    .name = "generator", .summary = "how the cases are drawn", .standard = "uniform", .choices = [] {
      return std::vector<std::string_view>{"uniform", "near-cancelling"};
    }};
constexpr std::array parameters{generator_parameter};

struct Case {
  Triple<std::int32_t> x, y;
};

constexpr std::int32_t range = 1 << 28;

std::int64_t product(const Case& c, std::size_t i) { return std::int64_t{c.x[i]} * c.y[i]; }

// Three products below 2^56: 64 bits hold their sum.
Sign exact_sign_of(const Case& c) { return sign_of(product(c, 0) + product(c, 1) + product(c, 2)); }

Case draw_uniform(Random& random) {
  Case c{};
  for (std::size_t i = 0; i < 3; ++i) {
    c.x[i] = static_cast<std::int32_t>(random.below(2 * range - 1)) - (range - 1);
    c.y[i] = static_cast<std::int32_t>(random.below(range));
  }
  return c;
}

// With probability above 1/16 both products are below 2^54 and y2 is at least 2^27: such a draw is in range.
Case draw_near_cancelling(Random& random) {
  for (;;) {
    Case c = draw_uniform(random);
    if (c.y[2] == 0) continue;
    const std::int64_t quotient = -(product(c, 0) + product(c, 1)) / c.y[2];
    const std::int64_t x2 = quotient + static_cast<std::int64_t>(random.below(3)) - 1;
    if (std::abs(x2) >= range) continue;
    c.x[2] = static_cast<std::int32_t>(x2);
    return c;
  }
}

struct Variant {
  const char* name;
  Misprints misprints;
};

constexpr Variant variants[] = {
    {"printed", as_printed},
    {"third_product", {.third_product_overwrites = true, .carry_overwrites = false, .late_exits = false}},
    {"carry", {.third_product_overwrites = false, .carry_overwrites = true, .late_exits = false}},
    {"late_exits", {.third_product_overwrites = false, .carry_overwrites = false, .late_exits = true}},
    {"corrected", all_corrected},
};

void try_witness(const std::string& name, const Case& c, std::map<std::string, double>& counters) {
  const auto number = [](Sign sign) { return static_cast<double>(sign); };
  counters[name + ".exact"] = number(exact_sign_of(c));
  counters[name + ".printed"] = number(sign_of_dot_product_as_printed(c.x, c.y));
  counters[name + ".corrected"] = number(sign_of_dot_product_as_printed(c.x, c.y, all_corrected));
}

Finding run_knuth_printed(const Cell& cell) {
  const bool uniform = choice(cell.parameters, generator_parameter) == "uniform";
  Finding finding;
  try_witness("witness.1", {{-1, -1, 1}, {0, 1, 1}}, finding.counters);
  try_witness("witness.2", {{19317, 1444, -18836}, {24311, 26904, 14696}}, finding.counters);

  finding.counters["queries"] = static_cast<double>(cell.n);
  double& zeros = finding.counters["zeros"];
  double& redundant = finding.counters["wrong.redundant"];
  Random random(cell.seed);
  for (std::uint64_t i = 0; i < cell.n; ++i) {
    const Case c = uniform ? draw_uniform(random) : draw_near_cancelling(random);
    const Sign exact = exact_sign_of(c);
    zeros += exact == Sign::zero;
    redundant += sign_of_dot_product(c.x, c.y) != exact;
    for (const auto& [name, misprints] : variants)
      finding.counters[std::string("wrong.") + name] +=
          sign_of_dot_product_as_printed(c.x, c.y, misprints) != exact;
  }
  return finding;
}

}  // namespace

constinit const Experiment knuth_printed_experiment{
    .name = "knuth-printed",
    .cites = "Barth, section 3.7; Knuth 1993",
    .summary =
        "wrong signs of the printed multiple-precision sign test, by misprint, with a witness for each",
    .reads = {.n = true, .seed = true},
    .parameters = parameters,
    .run = run_knuth_printed,
};

}  // namespace tribunal::bench
