// Law: the witness sees each way in which a host can spoil the arithmetic that certified signs rest on.
#include "predicates/environment.hpp"

#include "predicates/filters/dynamic.hpp"
#include "tests/laws/kernels.hpp"

#include <gtest/gtest.h>

#include <cfenv>
#include <string>

#if defined(__SSE2__)
#include <pmmintrin.h>
#include <xmmintrin.h>
#endif

namespace tribunal::laws {
namespace {

/// Restores the whole floating-point environment, the SSE control word included.
class SavedEnvironment {
 public:
  SavedEnvironment() { std::fegetenv(&saved_); }
  SavedEnvironment(const SavedEnvironment&) = delete;
  SavedEnvironment& operator=(const SavedEnvironment&) = delete;
  ~SavedEnvironment() { std::fesetenv(&saved_); }

 private:
  std::fenv_t saved_{};
};

TEST(Environment, TheTestsThemselvesRunInASoundOne) {
  EXPECT_TRUE(witness_floating_point().sound());
  EXPECT_EQ(describe_fault(witness_floating_point()), "");
}

TEST(Environment, EachDirectedRoundingModeIsSeen) {
  for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
    FloatingPointWitness witness{};
    {
      const SavedEnvironment saved;
      ASSERT_EQ(std::fesetround(mode), 0);
      witness = witness_floating_point();
    }
    EXPECT_FALSE(witness.round_to_nearest) << mode;
    EXPECT_FALSE(witness.sound());
    EXPECT_NE(describe_fault(witness), "");
  }
  EXPECT_TRUE(witness_floating_point().sound());
}

#if defined(__SSE2__)
TEST(Environment, FlushToZeroAndDenormalsAreZeroAreSeen) {
  FloatingPointWitness flushed{}, ignored{};
  {
    const SavedEnvironment saved;
    _MM_SET_FLUSH_ZERO_MODE(_MM_FLUSH_ZERO_ON);
    flushed = witness_floating_point();
  }
  {
    const SavedEnvironment saved;
    _MM_SET_DENORMALS_ZERO_MODE(_MM_DENORMALS_ZERO_ON);
    ignored = witness_floating_point();
  }
  EXPECT_FALSE(flushed.subnormals);
  EXPECT_FALSE(ignored.subnormals);
  EXPECT_EQ(describe_fault(flushed), "subnormal numbers are flushed to zero");
  EXPECT_TRUE(witness_floating_point().sound());
}

/// Why it is worth looking: b.x - a.x and c.x - a.x are subnormal differences of normal numbers, which
/// flushing takes away, and then even a certified filter certifies the wrong sign.
TEST(Environment, FlushToZeroMakesACertifiedSignWrong) {
  const Case<2> points{{{{0x1.8p-1022, 0x1p-70}}, {{1, 0x1p1000}}, {{0x1.7p-1022, 0}}, {{0, 0}}}};
  const Query<Orient<2>> query{points[0], points[1], points[2]};
  EXPECT_EQ(true_orient<2>(points), Sign::positive);
  EXPECT_EQ(filtered_sign<Orient<2>>(query), Sign::positive);
  Sign spoilt{};
  {
    const SavedEnvironment saved;
    _MM_SET_FLUSH_ZERO_MODE(_MM_FLUSH_ZERO_ON);
    spoilt = filtered_sign<Orient<2>>(query);
  }
  EXPECT_EQ(spoilt, Sign::negative);
}
#endif

}  // namespace
}  // namespace tribunal::laws
