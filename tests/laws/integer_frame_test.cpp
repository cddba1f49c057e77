// Law: a frame counts what is on its lattice, in its box, and nothing else.
#include "predicates/integer_frame.hpp"

#include "predicates/formulas/orient.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <span>
#include <vector>

namespace tribunal::laws {
namespace {

std::optional<IntegerFrame> frame_of(const std::vector<Point2>& points) {
  return IntegerFrame::find(std::span<const Point2>(points));
}

/// The count of p in a query with twice the corner, if it has one.
std::optional<Point2> count_of(const IntegerFrame& frame, const Point2& corner, const Point2& p) {
  Arguments<std::int64_t, Orient<2>> counts;
  if (!frame.count<Orient<2>>({corner, corner, p}, counts)) return std::nullopt;
  return Point2{{static_cast<double>(counts[2][0]), static_cast<double>(counts[2][1])}};
}

TEST(IntegerFrame, CountsFromTheLowestCornerInUnitsOfTheLattice) {
  for (const double unit : {1.0, 0x1p-30, 0x1p-1074, 0x1p900}) {
    const Point2 corner{{-3 * unit, 5 * unit}};
    const auto frame = frame_of({corner, {{4 * unit, 6 * unit}}});
    ASSERT_TRUE(frame);
    EXPECT_EQ(frame->bits(), 3);
    EXPECT_EQ(count_of(*frame, corner, corner), (Point2{{0, 0}}));
    EXPECT_EQ(count_of(*frame, corner, {{0, 7 * unit}}), (Point2{{3, 2}}));
    EXPECT_EQ(count_of(*frame, corner, {{-0.0, 7 * unit}}), (Point2{{3, 2}}));
  }
}

TEST(IntegerFrame, LeavesOutWhatIsBetweenItsPointsOrOutsideTheirBox) {
  const Point2 corner{{0, 0}};
  const auto frame = frame_of({corner, {{64, 16}}});
  ASSERT_TRUE(frame);
  EXPECT_EQ(frame->bits(), 3);  // in units of 16
  for (const Point2& off : std::vector<Point2>{{{8, 0}},
                                               {{16, 0x1p-1074}},
                                               {{16, -0x1p-60}},
                                               {{std::nextafter(16, 17), 0}},
                                               {{-16, 0}},
                                               {{80, 0}}})
    EXPECT_FALSE(count_of(*frame, corner, off)) << off[0] << " " << off[1];
}

/// Half a unit either way of the largest counts still shows.
TEST(IntegerFrame, ReachesTo50BitsOnEitherSideOfZero) {
  const double far = 0x1p50 - 1;
  const auto frame = frame_of({{{-far, 0}}, {{far, 1}}});
  ASSERT_TRUE(frame);
  EXPECT_EQ(frame->bits(), 51);
  const Point2 corner{{-far, 0}};
  EXPECT_EQ(count_of(*frame, corner, {{far, 1}}), (Point2{{2 * far, 1}}));
  EXPECT_FALSE(count_of(*frame, corner, {{far - 0.5, 1}}));
  EXPECT_FALSE(count_of(*frame, corner, {{0.5, 1}}));
  EXPECT_FALSE(frame_of({{{0x1p50, 0}}, {{1, 0}}}));
  EXPECT_FALSE(frame_of({{{0, 0}}, {{1, -0x1p50}}}));
}

TEST(IntegerFrame, NeedsALatticeThatIsNotTooFine) {
  EXPECT_FALSE(frame_of({}));
  EXPECT_FALSE(frame_of({{{1, 0x1p-50}}}));
  EXPECT_TRUE(frame_of({{{1, 0x1p-49}}}));
  EXPECT_FALSE(frame_of({{{0x1p-1074, 0}}, {{0x1p1023, 0}}}));
  EXPECT_TRUE(frame_of({{{0, 0}}}));
}

}  // namespace
}  // namespace tribunal::laws
