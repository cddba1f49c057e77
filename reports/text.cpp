#include "reports/text.hpp"

#include <array>
#include <charconv>
#include <cmath>

namespace tribunal::reports {
namespace {

template <class... Format>
std::string chars(double value, Format... format) {
  std::array<char, 400> buffer{};  // the longest double, written out, has 309 digits before the point
  const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, format...);
  return {buffer.data(), result.ptr};
}

}  // namespace

std::string number_text(double value, int significant) {
  if (value == 0) return "0";
  if (std::abs(value) < 0x1p53 && value == std::floor(value))
    return chars(value, std::chars_format::fixed, 0);
  return chars(value, std::chars_format::general, significant);
}

std::string fixed_text(double value, int decimals) {
  return chars(value, std::chars_format::fixed, decimals);
}

std::string percent_text(double share) { return number_text(100 * share, 3) + " %"; }

}  // namespace tribunal::reports
