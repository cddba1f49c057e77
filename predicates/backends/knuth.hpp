// Backend `knuth`: exact signs in 32-bit words, by redundant integers.
#pragma once

#include "predicates/backend.hpp"
#include "predicates/backends/knuth_box.hpp"

#include <cstdint>

namespace tribunal {

class Knuth {
 public:
  static constexpr BackendAbout about{
      .name = "knuth",
      .cites = "Knuth 1993, The Stanford GraphBase; Barth section 3.7",
      .summary = "32-bit words only: a 2^28 + b 2^14 + c with digits that may overlap",
      .domain = "integers in a box at most 2^14 - 1 wide",
      .exact = true,
  };

  static Binding<Knuth> bind(std::span<const Point2> points) {
    auto box = Box::find(points);
    if (auto* refusal = std::get_if<Refusal>(&box)) return std::move(*refusal);
    return Knuth(std::get<Box>(box));
  }
  bool admits(const Point2& p) const { return box_.contains(p); }

  template <SumOfThreeProducts Formula>
  Decision decide(const Query<Formula>& query) const {
    return box_.template decide<Formula>(query);
  }

 private:
  using Box = KnuthBox<std::int32_t>;
  explicit Knuth(const Box& box) : box_(box) {}

  Box box_;
};
static_assert(Backend<Knuth, 2>);

}  // namespace tribunal
