// Laws of what is asked: the same every time, finite, within the boxes announced, and hard.
#include "bench/fuzz/batch.hpp"

#include "bench/fuzz/bytes.hpp"
#include "bench/fuzz/dressing.hpp"
#include "bench/fuzz/mutation.hpp"
#include "bench/fuzz/oracle.hpp"
#include "bench/fuzz/shapes.hpp"
#include "bench/fuzz/ulps.hpp"
#include "tests/laws/oracle.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <set>

namespace tribunal::bench::fuzz {
namespace {

bool all_finite(const Case& asked) {
  const auto numbers = asked.numbers();
  return std::all_of(numbers.begin(), numbers.end(), [](double x) { return std::isfinite(x); });
}

/// Equal to the bit, zeros' signs included.
bool same_bits(const std::vector<Case>& a, const std::vector<Case>& b) {
  return a.size() == b.size() && std::equal(a.begin(), a.end(), b.begin(), [](const Case& x, const Case& y) {
           return x.predicate == y.predicate &&
                  std::memcmp(x.storage.data(), y.storage.data(), sizeof x.storage) == 0;
         });
}

/// A pool with hard cases of each predicate, as a hunt would have it after a while.
Pool filled_pool() {
  Pool pool;
  for (std::uint64_t index = 0; index < 40; ++index)
    for (const Predicate predicate : all_predicates)
      for (const Case& asked : draw_batch(7, index, predicate, Pool{}, 16).cases)
        if (certified_sign(asked) == Sign::zero) pool.add(asked);
  return pool;
}

template <class Visit>
void visit_batches(std::uint64_t count, std::size_t queries, Visit visit) {
  const Pool pool = filled_pool();
  for (std::uint64_t index = 0; index < count; ++index)
    for (const Predicate predicate : all_predicates) visit(draw_batch(1, index, predicate, pool, queries));
}

TEST(Batches, SameArgumentsSameBits) {
  const Pool pool = filled_pool();
  for (std::uint64_t index = 0; index < 100; ++index) {
    const Predicate predicate = all_predicates[index % 4];
    const Batch once = draw_batch(5, index, predicate, pool, 32),
                again = draw_batch(5, index, predicate, pool, 32);
    EXPECT_TRUE(same_bits(once.cases, again.cases));
    EXPECT_EQ(once.source, again.source);
    EXPECT_FALSE(same_bits(once.cases, draw_batch(6, index, predicate, pool, 32).cases)) << once.source;
  }
}

TEST(Batches, HoldAsManyQueriesAsAskedAndEachIsFinite) {
  for (const std::size_t queries : {1, 2, 3, 17, 256})
    visit_batches(40, queries, [&](const Batch& batch) {
      ASSERT_EQ(batch.cases.size(), queries);
      EXPECT_EQ(batch.drawn(), (queries + 1) / 2);
      for (const Case& asked : batch.cases) {
        EXPECT_EQ(asked.predicate, batch.predicate);
        EXPECT_TRUE(all_finite(asked)) << batch.source << ": " << query_text(asked);
      }
    });
}

TEST(Batches, PermutedCasesHaveTheSignThatTheParitySays) {
  int odd = 0;
  visit_batches(60, 32, [&](const Batch& batch) {
    for (std::size_t i = 0; batch.drawn() + i < batch.cases.size(); ++i) {
      EXPECT_EQ(exact_sign(batch.cases[batch.drawn() + i]), exact_sign(batch.cases[i]) * batch.parities[i])
          << batch.source << ": " << query_text(batch.cases[i]);
      odd += batch.parities[i] == Sign::negative;
    }
  });
  EXPECT_GT(odd, 60 * 4 * 4);
}

TEST(Batches, DrawFromEverySource) {
  std::set<std::string> kinds;
  visit_batches(600, 2, [&](const Batch& batch) {
    kinds.insert(batch.source.substr(0, batch.source.find(' ')));
    if (const auto comma = batch.source.find(", "); comma != std::string::npos)
      kinds.insert(batch.source.substr(comma + 2));
  });
  for (const Shape& shape : shapes()) EXPECT_TRUE(kinds.count(std::string(shape.name))) << shape.name;
  for (const std::string_view fabric : fabric_names) EXPECT_TRUE(kinds.count(std::string(fabric))) << fabric;
  for (const char* source : {"family", "mutants", "thresholds"}) EXPECT_TRUE(kinds.count(source)) << source;
}

/// What the whole is for: at least a fifth of the queries are ties, and another tenth so near to one that
/// floating point does not settle them.
TEST(Batches, AreBiasedToEquality) {
  std::map<Predicate, std::array<int, 3>> seen;  // all, ties, near ties
  visit_batches(300, 16, [&](const Batch& batch) {
    for (const Case& asked : batch.drawn_cases()) {
      auto& [all, ties, near] = seen[batch.predicate];
      ++all;
      if (certified_sign(asked) != Sign::zero) continue;
      ++(exact_sign(asked) == Sign::zero ? ties : near);
    }
  });
  for (const auto& [predicate, counts] : seen) {
    EXPECT_GT(counts[1] * 5, counts[0]) << to_string(predicate);
    EXPECT_GT(counts[2] * 10, counts[0]) << to_string(predicate);
  }
}

TEST(Shapes, StayInTheirBoxAndOnIntegers) {
  Random random(3);
  for (const Shape& shape : shapes())
    for (const int bits : {4, 5, 13, 14, 24, 53})
      for (const Predicate predicate : all_predicates)
        for (int i = 0; i < 50; ++i) {
          Case asked{predicate};
          shape.draw(random, bits, asked);
          const double half = std::ldexp(1.0, bits - 1);
          for (const double c : asked.numbers()) {
            ASSERT_EQ(std::trunc(c), c) << shape.name;
            ASSERT_TRUE(-half <= c && c < half) << shape.name << " of " << bits << " bits: " << c;
          }
        }
}

TEST(Shapes, TheDegenerateOnesAreDegenerate) {
  Random random(4);
  for (const Shape& shape : shapes())
    for (const Predicate predicate : all_predicates) {
      const bool orientation = predicate == Predicate::orient2d || predicate == Predicate::orient3d;
      const bool tie = shape.name == "flat" || (shape.name == "sphere" && !orientation);
      if (!tie) continue;
      for (int i = 0; i < 200; ++i) {
        Case asked{predicate};
        shape.draw(random, 24, asked);
        EXPECT_EQ(exact_sign(asked), Sign::zero) << shape.name << ": " << query_text(asked);
      }
    }
}

TEST(Mutations, AnyBytesAreAMutationAndCasesStayFinite) {
  Random random(5);
  for (int i = 0; i < 20000; ++i) {
    Case asked{all_predicates[random.below(4)]};
    for (double& c : asked.numbers()) c = made_finite(std::bit_cast<double>(random.bits()));
    const auto kind = static_cast<Mutation::Kind>(random.below(Mutation::kinds));
    apply({kind, static_cast<std::uint8_t>(random.bits()), static_cast<std::uint8_t>(random.bits()),
           static_cast<std::int16_t>(random.bits())},
          asked);
    EXPECT_TRUE(all_finite(asked)) << static_cast<int>(kind);
  }
}

TEST(Ulps, StepsAreNeighboursInBothDirections) {
  constexpr double infinity = std::numeric_limits<double>::infinity(),
                   largest = std::numeric_limits<double>::max();
  for (const double x :
       {0.0, -0.0, 1.0, -1.0, 0x1p-1074, -0x1p-1074, 0x1p-1022, 0x1.fffffffffffffp-1, 1e300}) {
    EXPECT_EQ(moved_by_ulps(x, 1), std::nextafter(x, infinity)) << x;
    EXPECT_EQ(moved_by_ulps(x, -1), std::nextafter(x, -infinity)) << x;
    EXPECT_EQ(moved_by_ulps(moved_by_ulps(x, 1000), -1000), x);
  }
  EXPECT_EQ(moved_by_ulps(largest, 3), largest);
  EXPECT_EQ(moved_by_ulps(-largest, -3), -largest);
  EXPECT_EQ(made_finite(infinity), largest);
  EXPECT_EQ(made_finite(-infinity), -largest);
  EXPECT_EQ(made_finite(std::nan("")), 0);
}

/// The oracle against one that shares no code with it: Boost's integers and Leibniz's sums.
TEST(Oracle, AgreesWithAnIndependentOne) {
  std::map<Sign, int> seen;
  visit_batches(80, 16, [&](const Batch& batch) {
    for (const Case& asked : batch.cases) {
      const int points = asked.points();
      std::array<Point2, 4> plane{};
      std::array<Point3, 5> space{};
      for (int i = 0; i < points; ++i)
        asked.dimension() == 2 ? void(plane[i] = point_of<2>(asked, i))
                               : void(space[i] = point_of<3>(asked, i));
      Sign other{};
      switch (asked.predicate) {
        case Predicate::orient2d:
          other = oracle::orient<2>(std::span(plane).first(3));
          break;
        case Predicate::incircle:
          other = oracle::in_sphere<2>(plane);
          break;
        case Predicate::orient3d:
          other = oracle::orient<3>(std::span(space).first(4));
          break;
        case Predicate::insphere:
          other = oracle::in_sphere<3>(space);
          break;
      }
      EXPECT_EQ(exact_sign(asked), other) << query_text(asked);
      const Sign certified = certified_sign(asked);
      EXPECT_TRUE(certified == Sign::zero || certified == other) << query_text(asked);
      ++seen[other];
    }
  });
  for (const Sign sign : {Sign::negative, Sign::zero, Sign::positive})
    EXPECT_GT(seen[sign], 300) << to_char(sign);
}

TEST(Oracle, TheStagedOneAnswersAsGmpDoesAndAsksItAboutASixteenthAtLeast) {
  Oracle staged(OracleKind::staged), gmp(OracleKind::gmp);
  std::uint64_t judged = 0;
  visit_batches(60, 32, [&](const Batch& batch) {
    EXPECT_EQ(staged.judge(batch.cases), gmp.judge(batch.cases)) << batch.source;
    judged += batch.cases.size();
  });
  EXPECT_EQ(gmp.asked_gmp(), judged);
  const std::uint64_t hard = staged.asked_gmp() - staged.rechecked();
  EXPECT_EQ(staged.rechecked(), (judged - hard + Oracle::recheck - 1) / Oracle::recheck);
  EXPECT_TRUE(staged.faults().empty());
}

}  // namespace
}  // namespace tribunal::bench::fuzz
