// Experiments about flips and angles, against what is known of them.
#include "bench/cell.hpp"
#include "tests/bench/support.hpp"

namespace tribunal::bench {
namespace {

TEST(FlipLaws, HoldForBothCriteria) {
  for (const char* criterion : {"delaunay", "minmax"}) {
    const Row row = run_one(
        "experiment='flip-laws'\nbackend='filtered'\ndataset='uniform'\nn=80\n"
        "parameters={start='fan',criterion='" +
        std::string(criterion) + "'}\n");
    const bool circles = criterion == std::string("delaunay");
    EXPECT_GT(row.counters.at("flips"), 50);
    for (const char* broken : {"falls", "rises", "violations", "unfinished"})
      EXPECT_EQ(row.counters.at(broken), 0) << criterion << ' ' << broken;
    EXPECT_EQ(row.counters.at("valid"), 1);
    EXPECT_EQ(row.counters.at("delaunay"), circles);
    EXPECT_EQ(row.counters.at("same"), circles);
    EXPECT_EQ(row.counters.at("nonconvex") > 0, circles) << "what is not convex is not asked about angles";
  }
}

TEST(FlipLaws, NoticeTiesThatNeverEnd) {
  const Row row = run_one(
      "experiment='flip-laws'\nbackend='gmp'\ndataset='grid'\nn=9\n"
      "parameters={criterion='delaunay-ties',method='sweeps'}\n");
  EXPECT_EQ(row.counters.at("unfinished"), 1);
  EXPECT_GT(row.counters.at("returns"), 0);
  EXPECT_GT(row.counters.at("rises"), 0);
}

TEST(FacingChains, TakeAsManyFlipsAsTheFormulaSays) {
  const Row row = run_one(
      "experiment='facing-chains'\nbackend='filtered'\nn=40\n"
      "parameters={method='sweeps'}\n");
  EXPECT_EQ(row.counters.at("flips"), 315);
  EXPECT_EQ(row.counters.at("tests"), 2071);
  EXPECT_EQ(row.counters.at("excess"), 0);
  EXPECT_EQ(row.counters.at("delaunay"), 1);
}

TEST(MinMaxAngles, AreInOrder) {
  for (int seed = 1; seed <= 5; ++seed) {
    const Row row = run_one("experiment='min-max-angles'\nbackend='filtered'\ndataset='uniform'\nn=8\nseed=" +
                            std::to_string(seed) + "\nparameters={exhaustive='yes'}\n");
    const auto at = [&](const char* name) { return row.counters.at(name); };
    EXPECT_LE(at("global.max"), at("local.max"));
    EXPECT_LE(at("local.max"), at("delaunay.max"));
    EXPECT_GE(at("delaunay.min"), at("local.min"));
    EXPECT_EQ(at("global_missed"), 0);
    EXPECT_EQ(at("best.max"), at("global.max"));
    EXPECT_EQ(at("local_missed"), at("gap") > 0);
    EXPECT_GT(at("triangulations"), 10);
  }
}

TEST(Propagation, ForwardAloneLeavesFlips) {
  const Row row = run_one("experiment='propagation'\nbackend='filtered'\ndataset='uniform'\nn=200\n");
  EXPECT_EQ(row.counters.at("both.left"), 0);
  EXPECT_GT(row.counters.at("forward.left"), 0);
  EXPECT_EQ(row.counters.at("both.valid") + row.counters.at("forward.valid"), 2);
}

TEST(NeedleInterpolation, LosesTheGradientAtLargeAnglesOnly) {
  const Row row = run_one("experiment='needle-interpolation'\nparameters={halvings=12}\n");
  EXPECT_EQ(row.counters.at("flat.error"), 4096);
  EXPECT_EQ(row.counters.at("flat.expected"), 4096);
  EXPECT_EQ(row.counters.at("needle.error"), 1);
  EXPECT_GT(row.counters.at("angle"), 179.9);
}

}  // namespace
}  // namespace tribunal::bench
