// Experiment `operations`: which operations the predicates need.
//
// Each determinant evaluated over a ring that has no division and counts what it is asked for; over a type
// without a division operator nothing else would compile. Counters: `sums` (subtractions included),
// `products`, `divisions` (0).
#include "bench/experiments/listed.hpp"
#include "predicates/formulas/in_sphere.hpp"
#include "predicates/formulas/orient.hpp"
#include "predicates/formulas/query.hpp"
#include "predicates/predicate.hpp"

#include <array>

namespace tribunal::bench {
namespace {

constexpr Parameter predicate_parameter{
    .name = "predicate", .summary = "whose determinant", .standard = "orient2d", .choices = [] {
      return std::vector<std::string_view>(predicate_names.begin(), predicate_names.end());
    }};
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
  const std::string predicate = choice(cell, predicate_parameter);
  const Operations operations = predicate == "orient2d"   ? operations_of<Orient<2>>()
                                : predicate == "incircle" ? operations_of<InSphere<2>>()
                                : predicate == "orient3d" ? operations_of<Orient<3>>()
                                                          : operations_of<InSphere<3>>();
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
