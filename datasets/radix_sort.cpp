#include "datasets/radix_sort.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace tribunal {
namespace {

constexpr int digit_bits = 11;
constexpr int lowest_digit = 64 - 3 * digit_bits;

/// A counting sort by one digit, into `to`.
void distribute(const std::vector<Keyed>& from, std::vector<Keyed>& to, int shift) {
  constexpr std::size_t values = std::size_t{1} << digit_bits;
  std::array<std::uint32_t, values> place{};
  for (const Keyed& entry : from) ++place[(entry.key >> shift) % values];
  std::uint32_t before = 0;
  for (std::uint32_t& p : place) before += std::exchange(p, before);
  for (const Keyed& entry : from) to[place[(entry.key >> shift) % values]++] = entry;
}

/// What shares all digits is left for comparisons.
void sort_runs(std::vector<Keyed>& entries) {
  for (auto begin = entries.begin(); begin != entries.end();) {
    const std::uint64_t digits = begin->key >> lowest_digit;
    auto end = begin + 1;
    while (end != entries.end() && end->key >> lowest_digit == digits) ++end;
    if (end - begin > 1) std::ranges::stable_sort(begin, end, {}, &Keyed::key);
    begin = end;
  }
}

}  // namespace

void sort_by_key(std::vector<Keyed>& entries) {
  // Below this many, counting to 2^11 three times costs more than comparing.
  if (entries.size() < 1024) {
    std::ranges::stable_sort(entries, {}, &Keyed::key);
    return;
  }
  std::vector<Keyed> other(entries.size());
  for (int shift = lowest_digit; shift < 64; shift += digit_bits) {
    distribute(entries, other, shift);
    entries.swap(other);
  }
  sort_runs(entries);
}

}  // namespace tribunal
