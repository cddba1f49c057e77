// Each way in which published predicates are known to fail, as a small backend of our own that promises
// exactness: the hunt finds it out, shrinks what it found, and the backends that we recommend are right
// there. (A change between AVX and SSE code costs time and no signs: it is a matter for the bench.)
#include "bench/fuzz/bytes.hpp"
#include "bench/fuzz/hunt.hpp"
#include "bench/fuzz/oracle.hpp"
#include "bench/fuzz/shrink.hpp"
#include "predicates/arithmetic/fused.hpp"
#include "predicates/backends/exact_sign.hpp"
#include "predicates/filters/dynamic.hpp"
#include "tests/fuzz/planted.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <limits>
#include <ostream>

namespace tribunal::bench::fuzz {
namespace {

template <class Formula>
double rounded_determinant(const Query<Formula>& query) {
  return Formula::determinant(query);
}

/// Products and sums fused by the compiler: a b - b a is the error of the product.
struct Contracted {
  template <class Formula>
  Decision decide(const Query<Formula>& query) const {
    const auto arguments = convert_arguments<Fused, Formula>(query, [](double c) { return Fused{c}; });
    return {sign_of(Formula::determinant(arguments)), Stage::exact};
  }
};

/// Constants that an initialisation would have computed, and nobody called it: an error bound of zero
/// certifies everything.
struct Uninitialised {
  template <class Formula>
  Decision decide(const Query<Formula>& query) const {
    return {sign_of(rounded_determinant<Formula>(query)), Stage::filter};
  }
};

/// A default tolerance: whatever is small is zero.
struct Epsilon {
  template <class Formula>
  Decision decide(const Query<Formula>& query) const {
    const double determinant = rounded_determinant<Formula>(query);
    return {std::fabs(determinant) < 1e-12 ? Sign::zero : exact_sign<Formula>(query), Stage::exact};
  }
};

/// A determinant that underflows is taken for a tie, and the tie is broken.
struct UnderflowIsATie {
  template <class Formula>
  Decision decide(const Query<Formula>& query) const {
    if (const Sign sign = filtered_sign<Formula>(query); sign != Sign::zero) return {sign, Stage::filter};
    const double determinant = rounded_determinant<Formula>(query);
    if (std::fabs(determinant) < std::numeric_limits<double>::min()) return {Sign::positive, Stage::symbolic};
    return {exact_sign<Formula>(query), Stage::exact};
  }
};

/// Exact while products neither underflow nor overflow, and not asked whether they do.
struct BlindToRange {
  template <class Formula>
  Decision decide(const Query<Formula>& query) const {
    double largest = 0;
    for (const auto& p : query)
      for (const double c : p.coordinate) largest = std::max(largest, std::fabs(c));
    const bool in_range = 0x1p-150 < largest && largest < 0x1p150;
    return {in_range ? exact_sign<Formula>(query) : sign_of(rounded_determinant<Formula>(query)),
            Stage::exact};
  }
};

/// One threshold on the permanent, without a term for the products that underflow on the way to it.
struct NoUnderflowTerm {
  struct Value {
    double value, magnitude;
    friend Value operator-(Value a, Value b) { return {a.value - b.value, a.magnitude + b.magnitude}; }
    friend Value operator+(Value a, Value b) { return {a.value + b.value, a.magnitude + b.magnitude}; }
    friend Value operator*(Value a, Value b) { return {a.value * b.value, a.magnitude * b.magnitude}; }
  };
  template <class Formula>
  Decision decide(const Query<Formula>& query) const {
    const Value d = Formula::determinant(convert_arguments<Value, Formula>(query, [](double c) {
      return Value{c, std::fabs(c)};
    }));
    if (std::fabs(d.value) > error_coefficient<Formula> * d.magnitude && std::isfinite(d.value))
      return {sign_of(d.value), Stage::filter};
    return {exact_sign<Formula>(query), Stage::exact};
  }
};

/// A zero-eliminating sum that reads the number behind its last component, where something small happens to
/// lie.
struct ReadsPastTheEnd {
  template <class Formula>
  Decision decide(const Query<Formula>& query) const {
    const Sign sum = exact_sign<Formula>(query);
    const double behind = -0x1p-1060;
    return {sum != Sign::zero ? sum : sign_of(behind), Stage::expansion};
  }
};

/// Numbers as pairs of doubles, after Dekker 1971, with the building blocks left to a policy.
template <class Blocks>
struct Pair {
  double high, low;

  static Pair sum(double a, double b) {
    const double s = a + b;
    return {s, Blocks::sum_error(a, b, s)};
  }
  static Pair product(double a, double b) {
    const double p = a * b;
    return {p, Blocks::product_error(a, b, p)};
  }
  friend Pair operator+(Pair a, Pair b) {
    const Pair s = sum(a.high, b.high);
    return sum(s.high, s.low + (a.low + b.low));
  }
  friend Pair operator-(Pair a, Pair b) { return a + Pair{-b.high, -b.low}; }
  friend Pair operator*(Pair a, Pair b) {
    const Pair p = product(a.high, b.high);
    return sum(p.high, p.low + (a.high * b.low + a.low * b.high));
  }
};

/// A certified first stage, and pairs that nothing certifies as the last.
template <class Blocks>
struct PairsLast {
  template <class Formula>
  Decision decide(const Query<Formula>& query) const {
    if (const Sign sign = filtered_sign<Formula>(query); sign != Sign::zero) return {sign, Stage::filter};
    using Number = Pair<Blocks>;
    const Number d = Formula::determinant(convert_arguments<Number, Formula>(query, [](double c) {
      return Number{c, 0};
    }));
    return {sign_of(d.high != 0 ? d.high : d.low), Stage::exact};
  }
};

/// Right, but a pair holds 106 bits and no more.
struct Dekker {
  static double sum_error(double a, double b, double s) {
    const double t = s - a;
    return (a - (s - t)) + (b - t);
  }
  static double product_error(double a, double b, double p) { return std::fma(a, b, -p); }
};

/// -ffast-math: sums may be reassociated, and then the error of a sum is zero.
struct Reassociated {
  static double sum_error(double, double, double) { return 0; }
  static double product_error(double a, double b, double p) { return std::fma(a, b, -p); }
};

/// Veltkamp's splitter is 2^27 + 1; with 2^28 the halves are too long for their products to be exact.
struct WrongSplitter {
  static double sum_error(double a, double b, double s) { return Dekker::sum_error(a, b, s); }
  static double product_error(double a, double b, double p) {
    const auto high_half = [](double x) {
      const double scaled = 0x1p28 * x;
      return scaled - (scaled - x);
    };
    const double ah = high_half(a), al = a - ah, bh = high_half(b), bl = b - bh;
    return al * bl - (((p - ah * bh) - al * bh) - ah * bl);
  }
};

/// The registers of the x87: longer than double, and no longer exact for it.
struct ExtendedLast {
  template <class Formula>
  Decision decide(const Query<Formula>& query) const {
    if (const Sign sign = filtered_sign<Formula>(query); sign != Sign::zero) return {sign, Stage::filter};
    const auto arguments =
        convert_arguments<long double, Formula>(query, [](double c) { return static_cast<long double>(c); });
    return {sign_of(Formula::determinant(arguments)), Stage::exact};
  }
};

/// Divides by a determinant that cannot vanish, so it thinks, and asserts that it does not.
struct AbortsOnZero {
  template <class Formula>
  Decision decide(const Query<Formula>& query) const {
    const Sign sign = exact_sign<Formula>(query);
    if (sign != Sign::zero && rounded_determinant<Formula>(query) == 0) std::abort();
    return {sign, Stage::exact};
  }
};

struct PeerFailure {
  const char* name;
  Subject subject;
};
void PrintTo(const PeerFailure& failure, std::ostream* out) { *out << failure.name; }

const PeerFailure failures[] = {
    {"contraction", planted<Contracted>("planted")},
    {"fast_math", planted<PairsLast<Reassociated>>("planted")},
    {"x87", planted<ExtendedLast>("planted")},
    {"splitter", planted<PairsLast<WrongSplitter>>("planted")},
    {"epsilon", planted<Epsilon>("planted")},
    {"uncertified_last_stage", planted<PairsLast<Dekker>>("planted")},
    {"missing_initialisation", planted<Uninitialised>("planted")},
    {"underflow_as_tie", planted<UnderflowIsATie>("planted")},
    {"exponent_range", planted<BlindToRange>("planted")},
    {"no_underflow_term", planted<NoUnderflowTerm>("planted")},
    {"past_the_end", planted<ReadsPastTheEnd>("planted")},
};

class PeerFailures : public testing::TestWithParam<PeerFailure> {};

TEST_P(PeerFailures, IsFoundOutAndShrunkToWhereOursAreRight) {
  const Subject& subject = GetParam().subject;
  int found = 0;
  for (const Tally& tally : hunt(hunt_for({subject}, 20'000)).tallies) {
    if (!tally.counterexample) continue;
    ++found;
    const Counterexample& shown = *tally.counterexample;
    EXPECT_TRUE(shown.alone);
    EXPECT_EQ(shown.exact, exact_sign(shown.asked));
    EXPECT_EQ(decide_alone(subject, shown.asked)->sign, shown.got) << query_text(shown.asked);
    EXPECT_TRUE(shown.got != shown.exact || shown.stage == Stage::symbolic) << query_text(shown.asked);
    for (const char* ours : {"filtered", "gmp"})
      EXPECT_EQ(decide_alone(listed(ours), shown.asked)->sign, shown.exact)
          << ours << ": " << query_text(shown.asked);
    EXPECT_LE(size_of(shown.asked).bits, 64) << query_text(shown.asked);
  }
  EXPECT_GT(found, 0) << GetParam().name;
}

INSTANTIATE_TEST_SUITE_P(, PeerFailures, testing::ValuesIn(failures),
                         [](const auto& test) { return std::string(test.param.name); });

/// An abort cannot be shrunk in the same process: it ends the hunt where libFuzzer and AFL++ want it to end.
TEST(PeerFailuresDeathTest, AnAbortOnAVanishedDeterminantIsReached) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  EXPECT_DEATH(hunt(hunt_for({planted<AbortsOnZero>("planted")}, 20'000)), "");
}

}  // namespace
}  // namespace tribunal::bench::fuzz
