// The bytes of every dataset and order, so that no change of a generator goes unseen: what was published with
// a seed must stay what it was. A digest changes only together with an entry in the change log.
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
      {"uniform", 0x1D65F130147077CC},
      {"normal", 0x3A806421B24F49E1},
      {"clusters", 0x411F32213BC9DDAD},
      {"grid", 0xA77765271D0114D5},
      {"tilted-grid", 0xFF4D0EEF8DBA4DCE},
      {"rotated-grid", 0x79DE6A4FC60C3387},
      {"circle", 0x40AFBE10FF4F8E8A},
      {"near-circle", 0x08EB3FFB253004BF},
      {"collinear", 0x529566A13DD339FC},
      {"near-collinear", 0xAEF594322F8AFD77},
      {"duplicates", 0x64710F3E199363CA},
      {"spiral", 0xAB5B7EDE8C3C0939},
      {"kettner", 0x91140B770D9822DC},
      {"mixed-exponents", 0xAE1F03DCC2F1939C},
      {"lawson-worst-case", 0xD1945EB9DEF9218C},
      {"trailing-edge", 0xC9377CC942738106},
      {"trailing-edge-blunt", 0xE61CF6144A321DDA},
      {"aerofoil", 0x600EBF64CFBBB190},
      {"aerofoil-blunt", 0xA0708C8BC027E926},
      {"high-lift", 0x2C0F10A1A4636941},
      {"counties", 0xB5581ECB16857172},
      {"coast", 0x8069EEEF0101386B},
      {"gulf", 0xE47A66FFCA297C3F},
      {"fractal-coast", 0xA580C091EA494050},
      {"wedge", 0x505854BED58EF349},
      {"comb", 0x988055534D791FC9},
      {"fan", 0x08CF3ECC44893632},
      {"slot", 0xE2005137A1294F85},
  };
  EXPECT_EQ(expected.size(), datasets().size());
  for (const Dataset& dataset : datasets()) {
    const auto golden = expected.find(dataset.about.name);
    const std::uint64_t pinned = golden == expected.end() ? 0 : golden->second;
    EXPECT_EQ(digest(dataset.generate(1000, 1)), pinned)
        << "{\"" << dataset.about.name << "\", 0x" << std::hex << digest(dataset.generate(1000, 1)) << "},";
  }
}

TEST(Golden, WholeRealData) {
  EXPECT_EQ(digest(find_dataset("counties")->generate(83767, 1)), 0x669BD8468AD6FCC2U);
  EXPECT_EQ(digest(find_dataset("coast")->generate(850, 1)), 0x8069EEEF0101386BU);
}

TEST(Golden, EveryOrderOf1000UniformPoints) {
  const std::array<std::uint64_t, 5> expected{0x9F780A6FB09190CD, 0x3A840AAB2742DA95, 0x8B6407D73905C635,
                                              0x4E08BFBE0D834C55, 0x0AF34EBBD0D366A5};
  const auto points = find_dataset("uniform")->generate(1000, 1);
  ASSERT_EQ(order_names().size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    Digest digest;
    for (const std::uint32_t index : insertion_order(points, static_cast<Order>(i), 1)) digest.add(index);
    EXPECT_EQ(digest.value(), expected[i]) << order_names()[i] << " 0x" << std::hex << digest.value();
  }
}

TEST(Golden, QuantisedNormal) {
  EXPECT_EQ(digest(quantise(find_dataset("normal")->generate(1000, 1), 20)), 0x2A6DAF3FD5659112U);
}

}  // namespace
}  // namespace tribunal
