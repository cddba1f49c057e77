// How large the value of a formula can be, found at compile time from the formula itself.
#pragma once

#include "predicates/formulas/query.hpp"

#include <stdexcept>

namespace tribunal {

/// A homogeneous polynomial of this degree whose value, for coordinates below M in magnitude, is at most
/// coefficient * M^degree; so are all values on the way to it of their own degree.
struct FormulaSize {
  int degree;
  double coefficient;
};

constexpr FormulaSize operator+(FormulaSize a, FormulaSize b) {
  // Evaluated at compile time this is a compile-time error.
  if (a.degree != b.degree) throw std::invalid_argument("a formula must be homogeneous");
  return {a.degree, a.coefficient + b.coefficient};
}
constexpr FormulaSize operator-(FormulaSize a, FormulaSize b) { return a + b; }
constexpr FormulaSize operator*(FormulaSize a, FormulaSize b) {
  return {a.degree + b.degree, a.coefficient * b.coefficient};
}

namespace detail {
struct SizedCoordinate {};
constexpr FormulaSize operator-(SizedCoordinate, SizedCoordinate) { return {1, 2}; }
}  // namespace detail

template <class Formula>
inline constexpr FormulaSize formula_size =
    Formula::determinant(Arguments<detail::SizedCoordinate, Formula>{});

}  // namespace tribunal
