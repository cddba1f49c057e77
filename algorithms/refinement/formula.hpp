// Formulas that users write: a size or a field as a function of the place.
#pragma once

#include "algorithms/abandon.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tribunal::refinement {

/// A formula in named variables: numbers, + - * / ^ (binds tightest, to the right), unary minus, parentheses,
/// pi, and the functions sqrt, abs, exp, log, sin, cos, tan, tanh, atan2, hypot, min, max.
///
/// Evaluated in doubles, with the C library's functions: the last bits may differ between machines.
class Formula {
 public:
  /// Throws Abandon (refused_input) with the reason and the column. O(length).
  Formula(std::string_view text, std::span<const std::string_view> variables);

  /// The value where the variables have these values, in their order. Outside a function's domain NaN.
  double operator()(std::span<const double> values) const;

  /// Whether it names no variable.
  bool is_constant() const;

  enum class Operation : std::uint8_t {
    number,
    variable,
    negate,
    add,
    subtract,
    multiply,
    divide,
    power,
    sqrt,
    abs,
    exp,
    log,
    sin,
    cos,
    tan,
    tanh,
    atan2,
    hypot,
    min,
    max,
  };
  struct Instruction {
    Operation operation;
    std::uint32_t variable = 0;
    double number = 0;
  };

 private:
  std::vector<Instruction> program_;  // in reverse Polish notation
};

/// Why `parse(text)` is refused, or nothing where it is not.
template <class Parse>
std::string refusal_of(Parse parse, std::string_view text) {
  try {
    parse(text);
    return {};
  } catch (const Abandon& refused) {
    return refused.what();
  }
}

}  // namespace tribunal::refinement
