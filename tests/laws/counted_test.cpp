// Law: a counted kernel answers as the kernel beneath it, and counts each call once, under the stage that
// decided it.
#include "predicates/counted.hpp"

#include "tests/laws/kernels.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace tribunal::laws {
namespace {

class Counting : public EveryBackend {};

TEST_P(Counting, ChangesNoAnswerAndMissesNoCall) {
  const auto family = shared_domain<2>(200, 11);
  const auto kernel = bind<2>(entry(), family.points());
  PredicateCounts counts, expected;
  const CountedKernel2 counted(*kernel, counts);
  for (const auto& points : family.cases) {
    EXPECT_EQ(orient(counted, points), orient(*kernel, points));
    EXPECT_EQ(in_sphere(counted, points), in_sphere(*kernel, points));
    ++expected.at(Predicate::orient2d, decide_orient(*kernel, points).stage);
    ++expected.at(Predicate::incircle, decide_in_sphere(*kernel, points).stage);
  }
  EXPECT_EQ(counts, expected);
  EXPECT_EQ(counts.total(), 400u);
  EXPECT_EQ(counted.admits({{-1e300, 0.1}}), kernel->admits({{-1e300, 0.1}}));
}

TEST_P(Counting, DoesSoInSpace) {
  if (entry().bind3 == nullptr) return;
  const auto family = shared_domain<3>(100, 12);
  const auto kernel = bind<3>(entry(), family.points());
  PredicateCounts counts;
  const CountedKernel3 counted(*kernel, counts);
  for (const auto& points : family.cases) {
    EXPECT_EQ(orient(counted, points), orient(*kernel, points));
    EXPECT_EQ(in_sphere(counted, points), in_sphere(*kernel, points));
  }
  EXPECT_EQ(counts.total(Predicate::orient3d), 100u);
  EXPECT_EQ(counts.total(Predicate::insphere), 100u);
  EXPECT_EQ(counts.total(), 200u);
}

TRIBUNAL_FOR_EVERY_BACKEND(Counting);

TEST(PredicateCounts, NamesWhatWasCalledAndWhoDecided) {
  const std::vector<Point2> square{{{0, 0}}, {{1, 0}}, {{1, 1}}, {{0, 1}}};
  const auto kernel = bind<2>(*find_backend("filtered"), square);
  PredicateCounts counts;
  const CountedKernel2 counted(*kernel, counts);
  counted.orient2d(square[0], square[1], square[2]);
  counted.orient2d(square[0], square[1], square[3]);
  counted.orient2d(square[0], square[2], square[2]);
  counted.incircle(square[0], square[1], square[2], square[3]);
  const std::vector<std::pair<std::string, std::uint64_t>> expected{{"orient2d", 3},
                                                                    {"orient2d.filter", 2},
                                                                    {"orient2d.integer", 1},
                                                                    {"incircle", 1},
                                                                    {"incircle.integer", 1}};
  EXPECT_EQ(counts.named(), expected);
}

}  // namespace
}  // namespace tribunal::laws
