// Laws of the shrinker: the result still fails, is no larger, and shrinking it again changes nothing.
#include "bench/fuzz/shrink.hpp"

#include "bench/fuzz/batch.hpp"
#include "bench/fuzz/bytes.hpp"
#include "bench/fuzz/oracle.hpp"
#include "tests/fuzz/planted.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace tribunal::bench::fuzz {
namespace {

/// Calls visit(case, fails) for some wrong answers of a listed backend.
template <class Visit>
void visit_failures(const char* backend, Visit visit) {
  const Subject subject = listed(backend);
  const std::function<bool(const Case&)> fails = [&](const Case& asked) {
    const auto decision = decide_alone(subject, asked);
    return decision && decision->sign != exact_sign(asked);
  };
  int found = 0;
  for (std::uint64_t index = 0; found < 12 && index < 4000; ++index) {
    const Batch batch = draw_batch(11, index, all_predicates[index % 4], Pool{}, 4);
    const auto wrong = std::find_if(batch.cases.begin(), batch.cases.end(), fails);
    if (wrong == batch.cases.end()) continue;
    ++found;
    visit(*wrong, fails);
  }
  EXPECT_EQ(found, 12) << backend;
}

class Shrinking : public testing::TestWithParam<const char*> {};

TEST_P(Shrinking, KeepsTheFailureAndReachesAFixpoint) {
  visit_failures(GetParam(), [](const Case& asked, const auto& fails) {
    const Case small = shrink(asked, fails);
    EXPECT_TRUE(fails(small)) << query_text(small);
    EXPECT_LE(size_of(small), size_of(asked));
    EXPECT_LE(size_of(small).bits, size_of(asked).bits);
    EXPECT_EQ(query_text(shrink(small, fails)), query_text(small));
  });
}

/// What a reader can take in: rounding needs two numbers that a mantissa does not hold together, and a
/// predicate some ones beside them to be nonzero.
TEST_P(Shrinking, EndsInShortMantissas) {
  visit_failures(GetParam(), [](const Case& asked, const auto& fails) {
    EXPECT_LE(size_of(shrink(asked, fails)).bits, 16) << query_text(asked);
  });
}

INSTANTIATE_TEST_SUITE_P(, Shrinking, testing::Values("double", "double-fma", "knuth-as-printed"),
                         [](const auto& test) {
                           std::string name = test.param;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

TEST(Shrinker, EndsInTheSmallestCaseWhereEverythingFails) {
  Case asked{Predicate::insphere};
  for (std::size_t i = 0; i < asked.size(); ++i)
    asked.numbers()[i] = std::ldexp(1.1, static_cast<int>(i * 10)) - 3;
  EXPECT_EQ(shrink(asked, [](const Case&) { return true; }), Case{Predicate::insphere});
}

TEST(Shrinker, LeavesWhatCannotBeSmaller) {
  Case asked{Predicate::orient2d};
  for (std::size_t i = 0; i < asked.size(); ++i) asked.numbers()[i] = 0.1 * static_cast<double>(i + 1);
  EXPECT_EQ(shrink(asked, [&](const Case& c) { return c == asked; }), asked);
}

TEST(Shrinker, FindsTheOneNumberThatMatters) {
  Case asked{Predicate::orient3d};
  for (std::size_t i = 0; i < asked.size(); ++i)
    asked.numbers()[i] = -std::sqrt(static_cast<double>(i + 2)) * 1e100;
  const Case small = shrink(asked, [](const Case& c) { return std::fabs(c.point(2)[1]) >= 3; });
  EXPECT_EQ(small.point(2)[1], 4) << query_text(small);
  EXPECT_EQ(size_of(small).bits, 1);
  EXPECT_EQ(size_of(small).negative, 0);
}

TEST(CaseSizes, CountBitsExponentsValuesAndSigns) {
  Case asked{Predicate::orient2d};
  EXPECT_EQ(size_of(asked), (CaseSize{0, 0, 0, 0}));
  asked.numbers()[0] = 12;    // 0x1.8p3
  asked.numbers()[1] = -0.5;  // -0x1p-1
  asked.numbers()[2] = 12;
  EXPECT_EQ(size_of(asked), (CaseSize{2 + 1 + 2, 3 + 1 + 3, 2, 1}));
}

}  // namespace
}  // namespace tribunal::bench::fuzz
