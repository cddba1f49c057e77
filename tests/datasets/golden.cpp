// The bytes of every dataset and order, so that no change of a generator goes unseen: what was published with a seed must
// stay what it was. A digest changes only together with an entry in the change log.
#include "datasets/dataset.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <map>

namespace tribunal {
namespace {

/// FNV-1a, 64 bits, of the words' bytes from the lowest.
class Digest {
 public:
  void add(std::uint64_t word) {
    for (int byte = 0; byte < 8; ++byte) value_ = (value_ ^ ((word >> (8 * byte)) & 255)) * 0x100000001B3;
  }
  std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 0xCBF29CE484222325;
};

std::uint64_t digest(std::span<const Point2> points) {
  Digest digest;
  for (const Point2& p : points)
    for (const double c : p.coordinate) digest.add(std::bit_cast<std::uint64_t>(c));
  return digest.value();
}

TEST(Golden, EveryDatasetOf1000PointsAndSeed1) {
  const std::map<std::string_view, std::uint64_t> expected{
@@
  };
  EXPECT_EQ(expected.size(), datasets().size());
  for (const Dataset& dataset : datasets()) {
    const auto golden = expected.find(dataset.about.name);
    ASSERT_NE(golden, expected.end()) << dataset.about.name;
    EXPECT_EQ(digest(dataset.generate(1000, 1)), golden->second)
        << "{\"" << dataset.about.name << "\", 0x" << std::hex << digest(dataset.generate(1000, 1)) << "},";
  }
}

TEST(Golden, WholeRealData) {
  EXPECT_EQ(digest(find_dataset("counties")->generate(83767, 1)), 0x0U);
  EXPECT_EQ(digest(find_dataset("coast")->generate(850, 1)), 0x0U);
}

TEST(Golden, EveryOrderOf1000UniformPoints) {
  const std::array<std::uint64_t, 4> expected{0x0, 0x0, 0x0, 0x0};
  const auto points = find_dataset("uniform")->generate(1000, 1);
  for (std::size_t i = 0; i < expected.size(); ++i) {
    Digest digest;
    for (const std::uint32_t index : insertion_order(points, static_cast<Order>(i), 1)) digest.add(index);
    EXPECT_EQ(digest.value(), expected[i]) << order_names()[i] << " 0x" << std::hex << digest.value();
  }
}

TEST(Golden, QuantisedNormal) {
  EXPECT_EQ(digest(quantise(find_dataset("normal")->generate(1000, 1), 20)), 0x0U);
}

}  // namespace
}  // namespace tribunal
