#include "algorithms/duplicates.hpp"

#include <bit>

namespace tribunal {
namespace {

/// Mixes the bits of both coordinates (the finaliser of MurmurHash3, Appleby); -0 and +0 alike, since their
/// sum with zero is +0.
std::uint64_t hash(Point2 p) {
  const auto bits = [](double c) { return std::bit_cast<std::uint64_t>(c + 0.0); };
  std::uint64_t h = bits(p[0]) * 0x9E3779B97F4A7C15 ^ std::rotl(bits(p[1]), 32);
  h = (h ^ (h >> 33)) * 0xFF51AFD7ED558CCD;
  h = (h ^ (h >> 33)) * 0xC4CEB9FE1A85EC53;
  return h ^ (h >> 33);
}

}  // namespace

std::vector<Index> first_occurrences(std::span<const Point2> points) {
  constexpr Index empty = 0xFFFFFFFF;
  const std::size_t mask = std::bit_ceil(2 * points.size() + 1) - 1;
  std::vector<Index> slots(mask + 1, empty), first(points.size());
  for (Index i = 0; i < points.size(); ++i) {
    std::size_t slot = hash(points[i]) & mask;
    while (slots[slot] != empty && !(points[slots[slot]] == points[i])) slot = (slot + 1) & mask;
    if (slots[slot] == empty) slots[slot] = i;
    first[i] = slots[slot];
  }
  return first;
}

}  // namespace tribunal
