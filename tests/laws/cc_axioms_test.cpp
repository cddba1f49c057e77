// Laws: Knuth's axioms of CC systems (Axioms and Hulls, 1992) hold for "counter-clockwise" as every backend
// sees it. Of the five, nondegeneracy is a property of the points; here collinear triples abound, and "pqr"
// means strictly so.
#include "tests/laws/kernels.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <vector>

namespace tribunal::laws {
namespace {

/// Five points, at times of the whole 14-bit lattice, at times of a small grid in it, in whose triples zeros
/// abound. Single precision would round there; it gets the 11 bits whose products have 22.
std::array<Point2, 5> draw_five(Random& random, const BackendEntry& entry) {
  const std::uint64_t largest = entry.about->name == "float" ? 1 << 11 : 1 << 14;
  const std::uint64_t size = random.below(2) == 0 ? largest : 5;
  std::array<Point2, 5> points{};
  for (auto& p : points) p = draw_point<2>([&] { return static_cast<double>(random.below(size)); });
  return points;
}

class CcAxioms : public EveryBackend {
 protected:
  CcAxioms() : kernel_(bind<2>(*GetParam(), {{{0, 0}}, {{(1 << 14) - 1, (1 << 14) - 1}}})) {}
  bool ccw(Point2 a, Point2 b, Point2 c) const { return kernel_->orient2d(a, b, c) == Sign::positive; }

  std::unique_ptr<const Kernel2> kernel_;
};

TEST_P(CcAxioms, CyclicSymmetryAndAntisymmetry) {
  Random random(1);
  for (int i = 0; i < 20000; ++i) {
    const auto [p, q, r, s, t] = draw_five(random, entry());
    if (!ccw(p, q, r)) continue;
    ASSERT_TRUE(ccw(q, r, p));
    ASSERT_FALSE(ccw(p, r, q));
  }
}

TEST_P(CcAxioms, Interiority) {
  Random random(2);
  int met = 0;
  for (int i = 0; i < 40000; ++i) {
    const auto [p, q, r, t, unused] = draw_five(random, entry());
    if (!(ccw(t, q, r) && ccw(p, t, r) && ccw(p, q, t))) continue;
    ASSERT_TRUE(ccw(p, q, r));
    ++met;
  }
  EXPECT_GT(met, 1000) << "premises too rarely met to say anything";
}

TEST_P(CcAxioms, Transitivity) {
  Random random(3);
  int met = 0;
  for (int i = 0; i < 100000; ++i) {
    const auto [p, q, r, s, t] = draw_five(random, entry());
    if (!(ccw(t, s, p) && ccw(t, s, q) && ccw(t, s, r) && ccw(t, p, q) && ccw(t, q, r))) continue;
    ASSERT_TRUE(ccw(t, p, r));
    ++met;
  }
  EXPECT_GT(met, 1000) << "premises too rarely met to say anything";
}

TRIBUNAL_FOR_EVERY_BACKEND(CcAxioms);

}  // namespace
}  // namespace tribunal::laws
