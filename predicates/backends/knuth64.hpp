// Backend `knuth64`: exact signs in 64-bit words, by redundant integers.
#pragma once

#include "predicates/backend.hpp"
#include "predicates/backends/knuth_box.hpp"

#include <cstdint>

namespace tribunal {

class Knuth64 {
 public:
  static constexpr BackendAbout about{
      .name = "knuth64",
      .cites = "after Knuth 1993, The Stanford GraphBase; Barth section 3.7",
      .summary = "64-bit words only: a 2^60 + b 2^30 + c with digits that may overlap",
      .domain = "integers in a box at most 2^30 - 1 wide",
      .exact = true,
  };

  static Binding<Knuth64> bind(std::span<const Point2> points) {
    auto box = Box::find(points);
    if (auto* refusal = std::get_if<Refusal>(&box)) return std::move(*refusal);
    return Knuth64(std::get<Box>(box));
  }
  bool admits(const Point2& p) const { return box_.contains(p); }

  template <SumOfThreeProducts Formula>
  Decision decide(const Query<Formula>& query) const {
    return box_.template decide<Formula>(query);
  }

 private:
  using Box = KnuthBox<std::int64_t>;
  explicit Knuth64(const Box& box) : box_(box) {}

  Box box_;
};
static_assert(Backend<Knuth64, 2>);

}  // namespace tribunal
