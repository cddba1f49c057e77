// Laws of the Hilbert curve's keys and of sorting by them.
#include "datasets/radix_sort.hpp"

#include "datasets/hilbert.hpp"
#include "datasets/random.hpp"
#include "tests/datasets/support.hpp"

#include <algorithm>
#include <cstdlib>

namespace tribunal {
namespace {

/// Random keys with `bits` of freedom from the bit `lowest` upwards, owners in order.
std::vector<Keyed> keyed(std::size_t count, int bits, int lowest) {
  Random random(7);
  std::vector<Keyed> entries(count);
  for (std::uint32_t i = 0; i < count; ++i)
    entries[i] = {random.below(std::uint64_t{1} << bits) << lowest, i};
  return entries;
}

TEST(SortByKey, AgreesWithAStableSortByComparisons) {
  for (const std::size_t count : {0, 1, 2, 1023, 1024, 5000, 70000}) {
    for (const auto& [bits, lowest] :
         {std::pair{0, 0}, {1, 63}, {2, 31}, {12, 52}, {10, 0}, {31, 0}, {62, 2}}) {
      auto entries = keyed(count, bits, lowest);
      auto expected = entries;
      std::ranges::stable_sort(expected, {}, &Keyed::key);
      sort_by_key(entries);
      ASSERT_TRUE(std::ranges::equal(
          entries, expected,
          [](const Keyed& a, const Keyed& b) { return a.key == b.key && a.owner == b.owner; }))
          << count << " entries, " << bits << " bits from " << lowest;
    }
  }
}

TEST(Hilbert, VisitsEachCellOfTheCoarsestAndTheFinestLevelsOnceAndStepsAcrossASide) {
  constexpr std::uint32_t side = 32;
  for (const std::uint32_t cell : {1U, 1U << 27}) {  // as wide as a cell of the lattice, and as a 32nd of it
    std::vector<std::pair<std::uint64_t, std::pair<std::uint32_t, std::uint32_t>>> path;
    for (std::uint32_t x = 0; x < side; ++x)
      for (std::uint32_t y = 0; y < side; ++y) path.push_back({hilbert_key(x * cell, y * cell), {x, y}});
    std::ranges::sort(path);
    EXPECT_EQ(path.front().second, (std::pair{0U, 0U}));
    for (std::size_t i = 1; i < path.size(); ++i) {
      const auto [x, y] = path[i].second;
      const auto [u, v] = path[i - 1].second;
      ASSERT_EQ(std::abs(static_cast<int>(x) - static_cast<int>(u)) +
                    std::abs(static_cast<int>(y) - static_cast<int>(v)),
                1);
    }
  }
  EXPECT_EQ(hilbert_key(0xFFFFFFFF, 0), 0xFFFFFFFFFFFFFFFF);
}

}  // namespace
}  // namespace tribunal
