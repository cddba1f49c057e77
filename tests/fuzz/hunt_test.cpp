// Laws of the hunt: exact backends come out clean, the others are caught, and what was done is what is
// reported.
#include "bench/fuzz/hunt.hpp"

#include "bench/fuzz/bytes.hpp"
#include "bench/fuzz/oracle.hpp"
#include "bench/fuzz/shrink.hpp"
#include "predicates/backends/exact_sign.hpp"
#include "tests/fuzz/planted.hpp"

#include <gtest/gtest.h>

#include <cfenv>
#include <map>
#include <numeric>
#include <stdexcept>

namespace tribunal::bench::fuzz {
namespace {

std::vector<Subject> all_listed() {
  std::vector<Subject> subjects;
  for (const BackendEntry& entry : backends()) subjects.push_back(subject_of(entry));
  return subjects;
}

/// Wrong about one tie, and about it in one order of its points only.
struct Flawed {
  template <class Formula>
  Decision decide(const Query<Formula>& query) const {
    const Sign sign = tribunal::exact_sign<Formula>(query);
    const bool special = query[0][0] + query[1][0] + query[2][0] == 6 && query[0][1] * query[1][1] == 2;
    return {special ? Sign::positive : sign, Stage::exact};
  }
};

/// Remembers the query before: its answers depend on what was asked around them, and no case fails alone.
struct Forgetful {
  mutable Sign last = Sign::zero;
  mutable int asked = 0;
  template <class Formula>
  Decision decide(const Query<Formula>& query) const {
    const Sign sign = tribunal::exact_sign<Formula>(query);
    const Sign answer = ++asked > 20 ? last : sign;
    last = sign;
    return {answer, Stage::exact};
  }
};

/// Leaves the rounding mode changed.
struct Rounder {
  template <class Formula>
  Decision decide(const Query<Formula>& query) const {
    std::fesetround(FE_UPWARD);
    return {tribunal::exact_sign<Formula>(query), Stage::exact};
  }
};

/// Everything a report says, as text.
std::string text_of(const HuntReport& report) {
  std::string text = std::to_string(report.checked) + " " + std::to_string(report.asked_gmp);
  for (const Tally& tally : report.tallies) {
    text += "\n" + tally.backend + " " + std::string(to_string(tally.predicate));
    for (const std::uint64_t count : {tally.checked, tally.refused, tally.wrong})
      text += " " + std::to_string(count);
    for (const std::uint64_t count : tally.stages) text += " " + std::to_string(count);
    for (const std::uint64_t count : tally.near_threshold) text += " " + std::to_string(count);
    if (tally.counterexample) text += ": " + query_text(tally.counterexample->asked);
  }
  return text;
}

TEST(Hunt, ExactBackendsAreCleanAndTheOthersAreCaught) {
  const HuntReport report = hunt(hunt_for(all_listed(), 40'000));
  std::map<std::string, std::uint64_t> wrong;
  for (const Tally& tally : report.tallies) {
    wrong[tally.backend] += tally.wrong;
    EXPECT_EQ(tally.counterexample.has_value(), tally.wrong != 0);
    if (tally.exact && tally.counterexample)
      ADD_FAILURE() << tally.backend << " is wrong: " << query_text(tally.counterexample->asked);
  }
  for (const BackendEntry& entry : backends())
    EXPECT_TRUE(entry.about->exact || wrong[std::string(entry.about->name)] > 0) << entry.about->name;
  EXPECT_TRUE(report.oracle_faults.empty());
  EXPECT_TRUE(report.breaches.empty());
}

TEST(Hunt, EveryBackendIsGivenQueriesThatItAccepts) {
  for (const Tally& tally : hunt(hunt_for(all_listed(), 60'000)).tallies) {
    const bool offered = listed(tally.backend.c_str()).offers(tally.predicate);
    EXPECT_EQ(tally.checked > 0, offered) << tally.backend << " " << to_string(tally.predicate);
    EXPECT_EQ(tally.refusal.empty(), tally.refused == 0) << tally.backend;
  }
}

TEST(Hunt, SameOptionsSameReport) {
  HuntOptions options = hunt_for(all_listed(), 6'000);
  const std::string once = text_of(hunt(options));
  EXPECT_EQ(text_of(hunt(options)), once);
  options.seed = 2;
  EXPECT_NE(text_of(hunt(options)), once);
}

/// Who else is on trial changes nothing for a backend.
TEST(Hunt, SubjectsDoNotDisturbEachOther) {
  const HuntReport alone = hunt(hunt_for({listed("filtered")}, 6'000));
  const HuntReport together = hunt(hunt_for({listed("double"), listed("filtered"), listed("knuth")}, 6'000));
  for (std::size_t p = 0; p < all_predicates.size(); ++p) {
    EXPECT_EQ(alone.tallies[p].stages, together.tallies[4 + p].stages);
    EXPECT_EQ(alone.tallies[p].near_threshold, together.tallies[4 + p].near_threshold);
  }
}

TEST(Hunt, CountsAddUp) {
  for (const std::uint64_t queries : {1, 255, 256, 257, 5000}) {
    const HuntReport report = hunt(hunt_for({listed("gmp"), listed("knuth")}, queries));
    EXPECT_EQ(report.checked, queries);
    EXPECT_FALSE(report.seconds);
    std::map<std::string, std::uint64_t> asked;
    for (const Tally& tally : report.tallies) {
      asked[tally.backend] += tally.checked + tally.refused;
      EXPECT_EQ(std::accumulate(tally.stages.begin(), tally.stages.end(), std::uint64_t{0}), tally.checked);
    }
    EXPECT_EQ(asked["gmp"], queries);
    EXPECT_EQ(asked["knuth"], queries);
  }
}

TEST(Hunt, EachStageOfTheDefaultBackendDecidesAndIsMetAtItsThreshold) {
  std::map<Stage, std::uint64_t> decided, near;
  for (const Tally& tally : hunt(hunt_for({listed("filtered")}, 100'000)).tallies)
    for (std::size_t s = 0; s < stage_names.size(); ++s) {
      decided[static_cast<Stage>(s)] += tally.stages[s];
      near[static_cast<Stage>(s)] += tally.near_threshold[s];
    }
  for (const Stage stage : {Stage::filter, Stage::integer, Stage::exact}) {
    EXPECT_GT(decided[stage], 100U) << to_string(stage);
    EXPECT_GT(near[stage], 10U) << to_string(stage);
  }
}

TEST(Hunt, CorpusIsAskedFirst) {
  const Case tie{Predicate::orient2d, {1, 1, 2, 2, 3, 3}};
  HuntOptions options = hunt_for({planted<Flawed>("flawed")}, 0);
  options.corpus = {{tie, Sign::zero}};
  const HuntReport report = hunt(options);
  EXPECT_EQ(report.checked, 2U);  // as it stands, and permuted
  ASSERT_TRUE(report.tallies[0].counterexample);
  EXPECT_EQ(report.tallies[0].counterexample->source, "corpus");
  EXPECT_EQ(report.tallies[0].counterexample->exact, Sign::zero);
}

TEST(Hunt, StopsWhenItsCallerSaysSo) {
  HuntOptions options = hunt_for({listed("gmp")}, 1'000'000'000);
  int calls = 0;
  options.progress = [&](const HuntProgress& at) {
    EXPECT_GT(at.checked, 0U);
    return ++calls < 3;
  };
  EXPECT_LE(hunt(options).checked, 3U * 256);
}

TEST(Hunt, TimeIsReadOnlyWhereItIsBounded) {
  HuntOptions options = hunt_for({listed("double")}, 100);
  options.seconds = 3600;
  const HuntReport report = hunt(options);
  ASSERT_TRUE(report.seconds);
  EXPECT_GE(*report.seconds, 0);
  EXPECT_EQ(report.checked, 100U);
  options.queries.reset();
  options.seconds = 0.05;
  EXPECT_GE(*hunt(options).seconds, 0.05);
}

TEST(Hunt, AFaultThatNeedsItsSurroundingsIsReportedAsDrawn) {
  const HuntReport report = hunt(hunt_for({planted<Forgetful>("forgetful")}, 2'000));
  for (const Tally& tally : report.tallies) {
    ASSERT_TRUE(tally.counterexample);
    EXPECT_FALSE(tally.counterexample->alone);
    EXPECT_GE(tally.counterexample->drawn, 256U);
  }
}

TEST(Hunt, ASubjectThatChangesTheRoundingModeIsNamed) {
  const HuntReport report = hunt(hunt_for({planted<Rounder>("rounder"), listed("filtered")}, 2'000));
  ASSERT_EQ(report.breaches.size(), 1U);
  EXPECT_EQ(report.breaches[0].rfind("rounder: ", 0), 0U) << report.breaches[0];
  EXPECT_EQ(std::fegetround(), FE_TONEAREST);
  for (const Tally& tally : report.tallies) EXPECT_EQ(tally.wrong, 0U) << tally.backend;
}

/// Breaks every tie upwards, whatever the order of the points.
struct BreaksUpwards {
  template <class Formula>
  Decision decide(const Query<Formula>& query) const {
    const Sign sign = tribunal::exact_sign<Formula>(query);
    return sign == Sign::zero ? Decision{Sign::positive, Stage::symbolic} : Decision{sign, Stage::exact};
  }
};

/// Breaks what is no tie.
struct BreaksEverything {
  template <class Formula>
  Decision decide(const Query<Formula>& query) const {
    return {tribunal::exact_sign<Formula>(query), Stage::symbolic};
  }
};

TEST(Hunt, ATieMayBeBrokenButOnlyATieAndAntisymmetrically) {
  for (const Tally& tally : hunt(hunt_for({planted<BreaksUpwards>("upwards")}, 20'000)).tallies) {
    ASSERT_TRUE(tally.counterexample);
    EXPECT_EQ(tally.counterexample->law, Law::antisymmetry);
    EXPECT_EQ(size_of(tally.counterexample->asked).bits, 0) << "any tie will do, the smallest is all zero";
  }
  for (const Tally& tally : hunt(hunt_for({planted<BreaksEverything>("everything")}, 20'000)).tallies) {
    ASSERT_TRUE(tally.counterexample);
    EXPECT_EQ(tally.counterexample->law, Law::truth);
    EXPECT_NE(tally.counterexample->exact, Sign::zero);
  }
}

TEST(Hunt, TieBreakingBackendsAreClean) {
  std::vector<Subject> subjects;
  for (const BackendEntry& entry : symbolic_backends()) subjects.push_back(subject_of(entry));
  std::uint64_t broken = 0;
  for (const Tally& tally : hunt(hunt_for(subjects, 20'000)).tallies) {
    broken += tally.stages[static_cast<std::size_t>(Stage::symbolic)];
    if (tally.counterexample)
      ADD_FAILURE() << tally.backend << " is wrong: " << query_text(tally.counterexample->asked);
  }
  EXPECT_GT(broken, 100U);
}

}  // namespace
}  // namespace tribunal::bench::fuzz
