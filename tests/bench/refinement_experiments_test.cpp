// Experiments about refinement, on small domains.
#include "bench/cell.hpp"
#include "datasets/files/files.hpp"
#include "tests/bench/support.hpp"

namespace tribunal::bench {
namespace {

TEST(TrailingEdgeAngles, AreFlatInDelaunayMeshesOfThinLayersAndNotAfterSwaps) {
  const Row row = run_one(
      "experiment='trailing-edge-angles'\nbackend='filtered'\ndataset='trailing-edge-blunt'\n"
      "n=300\nbits=53\nseed=6\n");
  EXPECT_EQ(row.outcome, "ok") << row.reason;
  EXPECT_LT(row.counters.at("delaunay.short"), 1e-4);
  EXPECT_LT(row.counters.at("minmax.max"), 140);
  EXPECT_EQ(row.counters.at("delaunay.valid"), 1);
  EXPECT_EQ(row.counters.at("minmax.valid"), 1);
}

TEST(StretchedMesh, HasALayerOnEveryWallVertex) {
  const Row row = run_one(
      "experiment='stretched-mesh'\nbackend='filtered'\ndataset='aerofoil'\nn=132\n"
      "parameters={wall='1e-4',growth='1.4'}\n");
  EXPECT_EQ(row.outcome, "ok") << row.reason;
  EXPECT_EQ(row.counters.at("wall_vertices"), 100);
  EXPECT_EQ(row.counters.at("first_layer"), 100);
  EXPECT_NEAR(row.counters.at("closest"), 1, 1e-3);
  EXPECT_EQ(row.counters.at("valid"), 1);
  EXPECT_EQ(row.counters.at("vertices"), 132 + row.counters.at("inserted"));
}

TEST(AdaptedMesh, CrowdsWhereTheFieldIsSteep) {
  const Row row = run_one(
      "experiment='adapted-mesh'\nbackend='filtered'\nparameters={field='slip-line',tolerance='0.05'}\n");
  EXPECT_EQ(row.outcome, "ok") << row.reason;
  EXPECT_GT(row.counters.at("concentration"), 3);
  EXPECT_EQ(row.counters.at("over"), 0);
  EXPECT_EQ(row.counters.at("valid"), 1);
}

TEST(RefinementExperiments, RefuseDatasetsWithoutSegments) {
  EXPECT_THROW(run_one("experiment='stretched-mesh'\nbackend='filtered'\ndataset='uniform'\nn=100\n"),
               BadInput);
}

}  // namespace
}  // namespace tribunal::bench
