// The backends as types, for laws about what they evaluate beyond the kernel's predicates.
#pragma once

#include "predicates/backends/all.hpp"

#include <gtest/gtest.h>

#include <span>
#include <variant>
#include <vector>

namespace tribunal::laws {

/// Calls check(backend) with backend B bound to the points, when it is exact and gives the sign of `Formula`;
/// it must accept them. Returns whether it was called.
template <class B, class Formula, class Check>
bool check_if_exact(std::span<const Point<Formula::dimension>> points, Check check) {
  if constexpr (B::about.exact && Evaluates<B, Formula> && requires { B::bind(points); }) {
    SCOPED_TRACE(B::about.name);
    auto bound = B::bind(points);
    if (const auto* refusal = std::get_if<Refusal>(&bound)) {
      ADD_FAILURE() << refusal->reason;
    } else {
      check(std::get<B>(bound));
    }
    return true;
  }
  return false;
}

namespace detail {
template <class Formula, class... B>
int for_each_exact_backend(BackendTypes<B...>, const std::vector<Point<Formula::dimension>>& points,
                           auto check) {
  return (int{check_if_exact<B, Formula>(points, check)} + ...);
}
}  // namespace detail

/// The same for every listed backend. Returns how many were checked.
template <class Formula, class Check>
int for_each_exact_backend(const std::vector<Point<Formula::dimension>>& points, Check check) {
  return detail::for_each_exact_backend<Formula>(AllBackends{}, points, check);
}

}  // namespace tribunal::laws
