// Numbers as text, the same in every locale.
#pragma once

#include "predicates/point.hpp"

#include <array>
#include <charconv>
#include <string>
#include <string_view>

namespace tribunal::files {

/// Appends a finite double as the shortest decimal that reads back to the same bits, or an integer.
template <class Number>
void append_number(std::string& text, Number value) {
  std::array<char, 32> digits;  // the longest double is "-2.2250738585072014e-308"
  const auto [end, error] = std::to_chars(digits.data(), digits.data() + digits.size(), value);
  text.append(digits.data(), end);
}

/// "(0.5, 1e-09)"
inline std::string point_text(Point2 p) {
  std::string text = "(";
  append_number(text, p[0]);
  text += ", ";
  append_number(text, p[1]);
  return text + ")";
}

/// The finite double that the whole of `text` spells: decimal, or hexadecimal with 0x, correctly rounded.
/// Where it spells none, `refusal` becomes one line that says why, beginning with `what`.
double read_number(std::string_view text, std::string_view what, std::string& refusal);

}  // namespace tribunal::files
