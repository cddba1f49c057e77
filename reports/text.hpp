// Numbers as text, the same bytes under every locale.
#pragma once

#include <string>
#include <string_view>

namespace tribunal::reports {

/// The parts one after the other.
template <class... Parts>
std::string concat(const Parts&... parts) {
  std::string text;
  ((text += std::string_view(parts)), ...);
  return text;
}

/// Short and readable: whole numbers below 2^53 in full, others with `significant` digits; "inf" and "nan" as
/// such.
std::string number_text(double value, int significant = 6);

/// With `decimals` digits after the point.
std::string fixed_text(double value, int decimals);

/// A share in per cent, with enough digits to tell it from 0: "0.21 %", "0 %".
std::string percent_text(double share);

}  // namespace tribunal::reports
