// Numbers as text, the same in every locale.
#pragma once

#include <array>
#include <charconv>
#include <string>

namespace tribunal::files {

/// Appends a finite double as the shortest decimal that reads back to the same bits, or an integer.
template <class Number>
void append_number(std::string& text, Number value) {
  std::array<char, 32> digits;  // the longest double is "-2.2250738585072014e-308"
  const auto [end, error] = std::to_chars(digits.data(), digits.data() + digits.size(), value);
  text.append(digits.data(), end);
}

}  // namespace tribunal::files
