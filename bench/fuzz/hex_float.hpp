// Doubles as C writes them in hexadecimal: exact, short, and read by every command of the program.
#pragma once

#include <array>
#include <charconv>
#include <cmath>
#include <string>

namespace tribunal::bench::fuzz {

/// "0x1.8p+1", "-0x1p-1074", "0x0p+0"; the shortest such numeral of a finite double.
inline std::string hex_float(double value) {
  std::array<char, 32> digits{};  // the longest is "1.fffffffffffffp+1023"
  const auto end =
      std::to_chars(digits.data(), digits.data() + digits.size(), std::fabs(value), std::chars_format::hex)
          .ptr;
  return (std::signbit(value) ? "-0x" : "0x") + std::string(digits.data(), end);
}

}  // namespace tribunal::bench::fuzz
