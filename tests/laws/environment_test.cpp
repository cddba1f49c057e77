// Law: the witness sees each way in which a host can spoil the arithmetic that certified signs rest on.
#include "predicates/environment.hpp"

#include "predicates/backends/all.hpp"
#include "predicates/backends/exact_sign.hpp"
#include "predicates/filters/dynamic.hpp"
#include "tests/laws/kernels.hpp"

#include <gtest/gtest.h>

#include <cfenv>
#include <span>
#include <string>
#include <variant>
#include <vector>

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

/// Whoever calls a backend directly, not through the list, is refused as well.
TEST(Environment, NoBackendBindsInAnUnsoundOne) {
  const std::vector<Point2> points{{{0, 0}}, {{1, 0}}, {{0, 1}}};
  const auto refuses = [&points]<class... B>(BackendTypes<B...>) {
    const std::span<const Point2> bound(points);
    return (int{std::holds_alternative<Refusal>(B::bind(bound))} + ...);
  };
  const auto count = []<class... B>(BackendTypes<B...>) { return int{sizeof...(B)}; };
  EXPECT_EQ(refuses(AllBackends{}), 0);
  const SavedEnvironment saved;
  _MM_SET_FLUSH_ZERO_MODE(_MM_FLUSH_ZERO_ON);
  EXPECT_EQ(refuses(AllBackends{}), count(AllBackends{}));
  _MM_SET_FLUSH_ZERO_MODE(_MM_FLUSH_ZERO_OFF);
  std::fesetround(FE_DOWNWARD);
  EXPECT_EQ(refuses(AllBackends{}), count(AllBackends{}));
}

/// The last stage looks at bits alone: it is right in every mode.
TEST(Environment, ExactSignsDoNotDependOnIt) {
  const Query<Orient<2>> query{Point2{{0, 0}}, Point2{{0x1p-1060, 0}}, Point2{{0, 0x1p-1060}}};
  const SavedEnvironment saved;
  _MM_SET_FLUSH_ZERO_MODE(_MM_FLUSH_ZERO_ON);
  _MM_SET_DENORMALS_ZERO_MODE(_MM_DENORMALS_ZERO_ON);
  EXPECT_EQ(exact_sign<Orient<2>>(query), Sign::positive);
}

/// Why it is worth looking: b.x - a.x and c.x - a.x are subnormal differences of normal numbers, which
/// flushing takes away, and then even a certified filter certifies the wrong sign.
TEST(Environment, FlushToZeroMakesACertifiedSignWrong) {
  const Case<2> points{{{{0x1.8p-1022, 0x1p-70}}, {{1, 0x1p1000}}, {{0x1.7p-1022, 0}}, {{0, 0}}}};
  const Query<Orient<2>> query{points[0], points[1], points[2]};
  EXPECT_EQ(true_orient<2>(points), Sign::positive);
  // Called where the compiler cannot see it, or it would take the answer over from one mode to the other.
  Sign (*const volatile filter)(const Query<Orient<2>>&) = &filtered_sign<Orient<2>>;
  EXPECT_EQ(filter(query), Sign::positive);
  Sign spoilt{};
  {
    const SavedEnvironment saved;
    _MM_SET_FLUSH_ZERO_MODE(_MM_FLUSH_ZERO_ON);
    spoilt = filter(query);
  }
  EXPECT_EQ(spoilt, Sign::negative);
}
#endif

}  // namespace
}  // namespace tribunal::laws
