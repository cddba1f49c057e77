// Numbers as users type them.
#pragma once

#include <string>

namespace tribunal::cli {

/// A finite double: decimal, hexadecimal ("0x1.8p+1") or integer, with or without a sign, rounded to nearest.
/// Throws BadUsage naming the text.
double parse_number(const std::string& text);

}  // namespace tribunal::cli
