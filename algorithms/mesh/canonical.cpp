#include "algorithms/mesh/canonical.hpp"

#include <algorithm>

namespace tribunal {

std::vector<Triangle> canonical(std::span<const Triangle> triangles) {
  std::vector<Triangle> result(triangles.begin(), triangles.end());
  for (Triangle& t : result) std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  std::sort(result.begin(), result.end());
  return result;
}

std::uint64_t digest(std::span<const Triangle> triangles) {
  std::uint64_t hash = 0xCBF29CE484222325;
  for (const Triangle& t : canonical(triangles))
    for (const Index v : t)
      for (int byte = 0; byte < 4; ++byte) {
        hash ^= (v >> (8 * byte)) & 0xFF;
        hash *= 0x100000001B3;
      }
  return hash;
}

std::string to_hex(std::uint64_t digest) {
  std::string text(16, '0');
  for (int i = 15; i >= 0; --i, digest >>= 4) text[i] = "0123456789abcdef"[digest & 15];
  return text;
}

}  // namespace tribunal
