#include "cli/numbers.hpp"

#include "cli/console.hpp"

#include <charconv>
#include <cmath>
#include <string_view>

namespace tribunal::cli {

double parse_number(const std::string& text) {
  std::string_view digits = text;
  const bool negative = digits.starts_with('-');
  if (negative || digits.starts_with('+')) digits.remove_prefix(1);
  const bool hexadecimal = digits.starts_with("0x") || digits.starts_with("0X");
  if (hexadecimal) digits.remove_prefix(2);
  double value = 0;
  const char* end = digits.data() + digits.size();
  const auto [stop, error] = std::from_chars(
      digits.data(), end, value, hexadecimal ? std::chars_format::hex : std::chars_format::general);
  if (error == std::errc::result_out_of_range)
    throw BadUsage("'" + text + "' is beyond the range of doubles");
  if (error != std::errc{} || stop != end || digits.starts_with('-'))
    throw BadUsage("'" + text + "' is not a number");
  if (!std::isfinite(value)) throw BadUsage("'" + text + "' is not finite");
  return negative ? -value : value;
}

}  // namespace tribunal::cli
