#include "datasets/files/numerals.hpp"

#include "datasets/files/scanner.hpp"

#include <cmath>
#include <system_error>

namespace tribunal::files {
namespace {

bool take(std::string_view& text, char c) {
  const bool taken = !text.empty() && text.front() == c;
  if (taken) text.remove_prefix(1);
  return taken;
}

/// std::from_chars with a leading '+' and the prefix 0x, neither of which it knows. The value is set when the
/// whole field is a number; NaN and infinities are numbers here.
std::errc parse(std::string_view field, double& value) {
  const bool negative = take(field, '-');
  if (!negative) take(field, '+');
  auto format = std::chars_format::general;
  if (field.size() > 2 && field[0] == '0' && (field[1] == 'x' || field[1] == 'X')) {
    field.remove_prefix(2);
    format = std::chars_format::hex;
  }
  if (field.empty() || field.front() == '-') return std::errc::invalid_argument;
  const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), value, format);
  if (end != field.data() + field.size()) return std::errc::invalid_argument;
  if (negative) value = -value;
  return error;
}

}  // namespace

double read_number(std::string_view text, std::string_view what, std::string& refusal) {
  double value = 0;
  const std::errc error = parse(text, value);
  if (error == std::errc{} && std::isfinite(value)) return value;
  refusal = std::string(what) + " is " + (text.empty() ? "empty" : in_quotes(text));
  if (text.empty()) return 0;
  refusal += error == std::errc{}                      ? ", not finite"
             : error == std::errc::result_out_of_range ? ", outside the range of doubles"
                                                       : ", not a number";
  return 0;
}

}  // namespace tribunal::files
