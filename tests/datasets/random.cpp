// The random numbers are the published ones, and what is drawn from them is fair.
#include "datasets/random.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <vector>

namespace tribunal {
namespace {

TEST(Random, Splitmix64MatchesThePublishedVector) {
  std::uint64_t state = 1234567;
  for (const std::uint64_t expected : {6457827717110365317U, 3203168211198807973U, 9817491932198370423U,
                                       4593380528125082431U, 16408922859458223821U})
    EXPECT_EQ(Random::splitmix64(state), expected);
}

TEST(Random, Xoshiro256MatchesThePublishedVector) {
  Random random(std::array<std::uint64_t, 4>{1, 2, 3, 4});
  const std::array<std::uint64_t, 10> published{11520,
                                                0,
                                                1509978240,
                                                1215971899390074240,
                                                1216172134540287360,
                                                607988272756665600,
                                                16172922978634559625U,
                                                8476171486693032832,
                                                10595114339597558777U,
                                                2904607092377533576};
  for (const std::uint64_t expected : published) EXPECT_EQ(random.bits(), expected);
}

TEST(Random, UnitIsBelowOneAndAMultipleOfTheLattice) {
  Random random(1);
  for (int i = 0; i < 10000; ++i) {
    const double u = random.unit();
    ASSERT_TRUE(0 <= u && u < 1);
    ASSERT_EQ(u * 0x1p53, static_cast<double>(static_cast<std::uint64_t>(u * 0x1p53)));
  }
}

TEST(Random, BelowReachesEveryValueAndNoOther) {
  Random random(1);
  std::array<int, 7> count{};
  for (int i = 0; i < 7000; ++i) ++count.at(random.below(7));
  for (const int c : count) EXPECT_NEAR(c, 1000, 150);
  for (int i = 0; i < 100; ++i) EXPECT_EQ(random.below(1), 0U);
  constexpr std::uint64_t huge = (std::uint64_t{1} << 63) + 1;  // rejects almost half of the draws
  for (int i = 0; i < 1000; ++i) EXPECT_LT(random.below(huge), huge);
}

TEST(Random, ShuffleReachesEveryPermutationEquallyOften) {
  Random random(1);
  std::vector<std::array<int, 3>> seen;
  for (int i = 0; i < 6000; ++i) {
    std::array<int, 3> items{0, 1, 2};
    random.shuffle(std::span<int>(items));
    seen.push_back(items);
  }
  std::array<int, 3> items{0, 1, 2};
  do EXPECT_NEAR(static_cast<double>(std::ranges::count(seen, items)), 1000, 150);
  while (std::next_permutation(items.begin(), items.end()));
}

}  // namespace
}  // namespace tribunal
