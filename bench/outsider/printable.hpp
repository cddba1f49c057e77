// What outsiders say, made fit to be shown.
#pragma once

#include <algorithm>
#include <string>

namespace tribunal::bench {

/// One line of printable ASCII of bounded length: other bytes are shown as '?'.
inline std::string printable(std::string text) {
  constexpr std::size_t longest = 200;
  text.resize(std::min(text.size(), longest));
  std::ranges::replace_if(
      text, [](char c) { return c < 0x20 || c > 0x7E; }, '?');
  return text;
}

}  // namespace tribunal::bench
