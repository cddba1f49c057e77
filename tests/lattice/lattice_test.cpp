// Law: on small integer lattices every exact backend gives the true sign of EVERY query, degenerate ones
// included. All backends on lattices of a few points per side, those that are quick on larger ones.
#include "predicates/backends/list.hpp"
#include "tests/lattice/truth.hpp"
#include "tests/laws/oracle.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace tribunal::lattice {
namespace {

/// Null where the backend has no predicates of this dimension.
template <int D>
std::unique_ptr<const Kernel<D>> bind(const BackendEntry& entry, const std::vector<Point<D>>& points) {
  if constexpr (D == 2) {
    return std::get<0>(entry.bind2(points));
  } else {
    return entry.bind3 == nullptr ? nullptr : std::get<0>(entry.bind3(points));
  }
}

/// Sweeps all N-tuples with the backend; of them `zeros` are degenerate, as a program of its own counted
/// once.
template <std::size_t N, int D>
void is_right_everywhere(const BackendEntry& entry, const std::vector<Point<D>>& points,
                         std::uint64_t zeros) {
  const auto kernel = bind<D>(entry, points);
  if (!kernel) return;
  const Sweep found = sweep<N, D>(points, *kernel);
  EXPECT_EQ(found.wrong, 0U) << entry.about->name << ", first at " << found.first_wrong;
  EXPECT_EQ(found.zeros, zeros);
}

template <std::size_t N, int D>
void every_exact_backend_is_right(const std::vector<Point<D>>& points, std::uint64_t zeros) {
  int asked = 0;
  for (const BackendEntry& entry : backends()) {
    if (!entry.about->exact) continue;
    is_right_everywhere<N, D>(entry, points, zeros);
    ++asked;
  }
  EXPECT_GE(asked, 7);
}

TEST(Lattice, Orient2dOfAllTriplesOf8x8) { every_exact_backend_is_right<3>(lattice<2>(8), 21424); }
TEST(Lattice, IncircleOfAllQuadruplesOf4x4) { every_exact_backend_is_right<4>(lattice<2>(4), 26512); }
TEST(Lattice, Orient3dOfAllQuadruplesOf3x3x3) { every_exact_backend_is_right<4>(lattice<3>(3), 180273); }

/// All eight corners lie on one sphere; the centre of the doubled cube is the point off it.
TEST(Lattice, InsphereOfAllQuintuplesOfACubeAndItsCentre) {
  auto points = lattice<3>(2);
  for (auto& p : points)
    for (double& c : p.coordinate) c *= 2;
  points.push_back({{1, 1, 1}});
  every_exact_backend_is_right<5>(points, 52089);
}

/// Three oracles, which share nothing: GMP's integers in the formulas as written, Boost's in Leibniz's sum,
/// and 64-bit integers in cofactors. The first and the last meet above; here the last two do.
class BoostKernel final : public Kernel2 {
 public:
  Decision decide_orient2d(Point2 a, Point2 b, Point2 c) const override {
    return {oracle::orient<2>(std::array{a, b, c}), Stage::exact};
  }
  Decision decide_incircle(Point2 a, Point2 b, Point2 c, Point2 d) const override {
    return {oracle::in_sphere<2>(std::array{a, b, c, d}), Stage::exact};
  }
  Decision decide_compare_length(Point2 a, Point2 b, Point2 c, Point2 d) const override {
    return {oracle::compare_length(a, b, c, d), Stage::exact};
  }
  Decision decide_compare_angle(const Angle<2>& p, const Angle<2>& q) const override {
    return {oracle::compare_angle(p, q), Stage::exact};
  }
  bool admits(Point2) const override { return true; }
};

TEST(Lattice, TheOraclesAgree) {
  const auto points = lattice<2>(3);
  EXPECT_EQ((sweep<3, 2>(points, BoostKernel()).wrong), 0U);
  EXPECT_EQ((sweep<4, 2>(points, BoostKernel()).wrong), 0U);
}

/// The sweep finds what is wrong: here a kernel that takes every collinear triple for a left turn.
class LeftTurningKernel final : public Kernel2 {
 public:
  Decision decide_orient2d(Point2 a, Point2 b, Point2 c) const override {
    const Sign sign = oracle::orient<2>(std::array{a, b, c});
    return {sign == Sign::zero ? Sign::positive : sign, Stage::rounded};
  }
  Decision decide_incircle(Point2, Point2, Point2, Point2) const override { return {}; }
  Decision decide_compare_length(Point2, Point2, Point2, Point2) const override { return {}; }
  Decision decide_compare_angle(const Angle<2>&, const Angle<2>&) const override { return {}; }
  bool admits(Point2) const override { return true; }
};

TEST(Lattice, TheSweepFindsWrongSigns) {
  const Sweep found = sweep<3, 2>(lattice<2>(3), LeftTurningKernel());
  EXPECT_EQ(found.wrong, found.zeros);
  EXPECT_FALSE(found.first_wrong.empty());
}

/// |ab| against |cd| for all quadruples, and all pairs of angles with legs, on lattices whose squares and
/// products fit an int.
TEST(Lattice, LengthsOfAllQuadruplesOf4x4) {
  const auto points = lattice<2>(4);
  const auto square = [](Point2 a, Point2 b) {
    return static_cast<int>((a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]));
  };
  for (const BackendEntry& entry : backends()) {
    if (!entry.about->exact) continue;
    const auto kernel = bind<2>(entry, points);
    int wrong = 0;
    for (const Point2& a : points)
      for (const Point2& b : points)
        for (const Point2& c : points)
          for (const Point2& d : points)
            wrong += kernel->compare_length(a, b, c, d) != sign_of(square(a, b) - square(c, d));
    EXPECT_EQ(wrong, 0) << entry.about->name;
  }
}

/// An angle by its sine and cosine times the lengths of its legs, the sine not negative.
struct Turn {
  int sine, cosine;
};
Turn turn_of(const Angle<2>& a) {
  const auto u = [&](int i) { return static_cast<int>(a[0][i] - a[1][i]); };
  const auto v = [&](int i) { return static_cast<int>(a[2][i] - a[1][i]); };
  return {std::abs(u(0) * v(1) - u(1) * v(0)), u(0) * v(0) + u(1) * v(1)};
}
/// By quadrants, then by slopes.
Sign compare(const Turn& p, const Turn& q) {
  const auto quadrant = [](const Turn& t) { return t.cosine > 0 ? 0 : t.cosine == 0 ? 1 : 2; };
  if (quadrant(p) != quadrant(q)) return sign_of(quadrant(p) - quadrant(q));
  return sign_of(p.sine * q.cosine - q.sine * p.cosine);
}

TEST(Lattice, AnglesOfAllPairsOf3x3) {
  const auto points = lattice<2>(3);
  std::vector<Angle<2>> angles;
  for (const Point2& a : points)
    for (const Point2& b : points)
      for (const Point2& c : points)
        if (!(a == b) && !(b == c)) angles.push_back({a, b, c});
  for (const BackendEntry& entry : backends()) {
    if (!entry.about->exact) continue;
    const auto kernel = bind<2>(entry, points);
    int wrong = 0;
    for (const auto& p : angles)
      for (const auto& q : angles) wrong += kernel->compare_angle(p, q) != compare(turn_of(p), turn_of(q));
    EXPECT_EQ(wrong, 0) << entry.about->name;
  }
}

// Larger lattices for the backends that answer in nanoseconds, degenerate or not.

class LargeLattice : public testing::TestWithParam<std::string_view> {
 protected:
  const BackendEntry& entry() const { return *find_backend(GetParam()); }
};
class LargeSpatialLattice : public LargeLattice {};

TEST_P(LargeLattice, Orient2dOfAllTriplesOf16x16) { is_right_everywhere<3>(entry(), lattice<2>(16), 427216); }
TEST_P(LargeLattice, IncircleOfAllQuadruplesOf6x6) { is_right_everywhere<4>(entry(), lattice<2>(6), 325680); }

TEST_P(LargeSpatialLattice, Orient3dOfAllQuadruplesOf4x4x4) {
  is_right_everywhere<4>(entry(), lattice<3>(4), 3078016);
}
TEST_P(LargeSpatialLattice, InsphereOfAllQuintuplesOf3x3x3) {
  is_right_everywhere<5>(entry(), lattice<3>(3), 6584427);
}
TEST_P(LargeSpatialLattice, Orient3dOfAllQuadruplesOf5x5x5) {
  if (std::getenv("TRIBUNAL_LONG_TIERS") == nullptr) GTEST_SKIP() << "a long tier: set TRIBUNAL_LONG_TIERS=1";
  is_right_everywhere<4>(entry(), lattice<3>(5), 27722257);
}

std::string backend_name(const testing::TestParamInfo<std::string_view>& backend) {
  std::string name(backend.param);
  for (char& c : name)
    if (c == '-') c = '_';
  return name;
}

INSTANTIATE_TEST_SUITE_P(, LargeLattice,
                         testing::Values("filtered", "fortune-van-wyk", "knuth", "knuth64", "redundant",
                                         "fixed"),
                         backend_name);
INSTANTIATE_TEST_SUITE_P(, LargeSpatialLattice, testing::Values("filtered", "fortune-van-wyk", "redundant"),
                         backend_name);

}  // namespace
}  // namespace tribunal::lattice
