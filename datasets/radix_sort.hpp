// Sorting by 64-bit keys, faster than by comparisons.
#pragma once

#include <cstdint>
#include <vector>

namespace tribunal {

/// A key and whose it is.
struct Keyed {
  std::uint64_t key;
  std::uint32_t owner;
};

/// Sorts by key; equal keys keep their order. O(n) where the upper half of the keys tells most of them apart,
/// O(n log n) else. With a copy of the entries as working space.
void sort_by_key(std::vector<Keyed>& entries);

}  // namespace tribunal
