// Laws of the coverage-guided fuzzers' entry: any bytes are a case, and exact backends survive all of them.
#include "bench/fuzz/bytes.hpp"

#include "bench/fuzz/batch.hpp"
#include "datasets/random.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <vector>

namespace tribunal::bench::fuzz {
namespace {
using Bytes = std::vector<std::uint8_t>;

void append(Bytes& bytes, std::uint64_t word, int count) {
  for (int i = 0; i < count; ++i) bytes.push_back(static_cast<std::uint8_t>(word >> (8 * i)));
}

TEST(CasesFromBytes, AnyBytesGiveAFiniteCaseThatExactBackendsAgreeOn) {
  Random random(1);
  for (int i = 0; i < 3000; ++i) {
    Bytes bytes(random.below(160));
    for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(random.bits());
    const Case asked = case_of_bytes(bytes);
    for (const double c : asked.numbers()) EXPECT_TRUE(std::isfinite(c));
    EXPECT_EQ(judge_bytes(bytes), "");
  }
  EXPECT_EQ(query_text(case_of_bytes({})), "orient2d 0x0p+0 0x0p+0 0x0p+0 0x0p+0 0x0p+0 0x0p+0");
}

TEST(CasesFromBytes, DoublesStandAsInMemory) {
  Bytes bytes{1, 0};
  for (int i = 0; i < 8; ++i) append(bytes, std::bit_cast<std::uint64_t>(0.1 * i), 8);
  const Case asked = case_of_bytes(bytes);
  EXPECT_EQ(asked.predicate, Predicate::incircle);
  for (int i = 0; i < 8; ++i) EXPECT_EQ(asked.numbers()[i], 0.1 * i);
}

TEST(CasesFromBytes, ASeedReachesTheGenerators) {
  for (std::uint8_t number = 0; number < 16; ++number) {
    Bytes bytes{2, 1};
    append(bytes, 77, 8);
    bytes.push_back(number);
    EXPECT_EQ(case_of_bytes(bytes),
              draw_batch(77, 0, Predicate::orient3d, Pool{}, std::size_t{2} * number + 1).cases[number]);
  }
}

TEST(CasesFromBytes, MutationsFollow) {
  Bytes bytes{0, 0};
  for (int i = 0; i < 6; ++i) append(bytes, std::bit_cast<std::uint64_t>(1.0 + i), 8);
  bytes.insert(bytes.end(), {0, 2, 0, 1, 0});   // number 2 one ulp up
  bytes.insert(bytes.end(), {3, 0, 1, 0, 0});   // points 0 and 1 swapped
  bytes.insert(bytes.end(), {10, 5, 0, 0, 0});  // number 5 negated
  EXPECT_EQ(query_text(case_of_bytes(bytes)),
            "orient2d 0x1.8000000000001p+1 0x1p+2 0x1p+0 0x1p+1 0x1.4p+2 -0x1.8p+2");
}

}  // namespace
}  // namespace tribunal::bench::fuzz
