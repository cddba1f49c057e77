// Experiment `operations`: which operations the predicates need.
//
// Each determinant evaluated over a ring that has no division and counts what it is asked for; over a type
// without a division operator nothing else would compile. Counters: `sums` (subtractions included),
// `products`, `divisions` (0).
#include "bench/experiments/listed.hpp"
#include "bench/experiments/name_parameters.hpp"
#include "predicates/formulas/query.hpp"
#include "predicates/formulas/with_formula.hpp"

#include <array>

namespace tribunal::bench {
namespace {

constexpr std::array parameters{predicate_parameter};

struct Operations {
  double sums = 0, products = 0;
};

/// A number that knows only where its operations are counted.
struct Counting {
  Operations* operations = nullptr;
};
Counting operator+(Counting a, Counting) { return ++a.operations->sums, a; }
Counting operator-(Counting a, Counting) { return ++a.operations->sums, a; }
Counting operator*(Counting a, Counting) { return ++a.operations->products, a; }

template <class Formula>
Operations operations_of() {
  Operations operations;
  Arguments<Counting, Formula> arguments;
  for (auto& point : arguments) point.fill({&operations});
  (void)Formula::determinant(arguments);
  return operations;
}

template <class Number>
constexpr bool divides = requires(Number a) {
  a / a;
};

Finding run_operations(const Cell& cell) {
  const Operations operations =
      with_formula(chosen_predicate(cell), []<class Formula>() { return operations_of<Formula>(); });
  static_assert(!divides<Counting>);
  return {.counters = {{"sums", operations.sums}, {"products", operations.products}, {"divisions", 0}}};
}

}  // namespace

constinit const Experiment operations_experiment{
    .name = "operations",
    .cites = "Barth, section 3.7",
    .summary = "how many sums and products a predicate's determinant takes over a ring without division",
    .reads = {},
    .parameters = parameters,
    .run = run_operations,
};

}  // namespace tribunal::bench
