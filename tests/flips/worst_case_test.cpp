// Law: the facing chains take quadratically many flips, these numbers of them in these orders (L6).
#include "algorithms/flips/delaunay_criterion.hpp"
#include "bench/experiments/facing_chains.hpp"
#include "tests/flips/support.hpp"

namespace tribunal::flips {
namespace {

FlipCounts flips_of(Index m, const FlipOptions& options) {
  const Plane plane(find_dataset("lawson-worst-case")->generate(2 * m, 0));
  EdgeMesh mesh(bench::facing_chains_start(m));
  EXPECT_EQ(fault_of(plane.points, mesh.triangles()), "");
  DelaunayCriterion delaunay(plane.sites());
  const FlipCounts counts = flip_to_optimum(plane.sites(), mesh, delaunay, options);
  EXPECT_EQ(fault_of(plane.points, mesh.triangles(), verify::Kind::delaunay), "");
  return counts;
}

TEST(WorstCase, SweepsInAscendingOrderTakeTheseNumbers) {
  struct Expected {
    Index m;
    std::uint64_t flips, tests;
  };
  for (const auto& [m, flips, tests] : {Expected{10, 60, 441}, {20, 315, 2071}, {40, 1425, 8931}}) {
    const FlipCounts counts = flips_of(m, {.method = Method::sweeps});
    EXPECT_EQ(counts.flips, flips);
    EXPECT_EQ(counts.flips, std::uint64_t{m - 2} * (2 * m - 5) / 2);
    EXPECT_EQ(counts.tests, tests);
    EXPECT_EQ(counts.sweeps, m - 1);
  }
}

TEST(WorstCase, DescendingOrderTakesOthers) {
  EXPECT_EQ(flips_of(10, {.method = Method::sweeps, .scan = Scan::descending}).flips, 50U);
  EXPECT_EQ(flips_of(20, {.method = Method::sweeps, .scan = Scan::descending}).flips, 235U);
  EXPECT_EQ(flips_of(40, {.method = Method::sweeps, .scan = Scan::descending}).flips, 1005U);
}

TEST(WorstCase, EveryOrderTakesAQuadraticNumber) {
  for (const Index m : {20, 40, 80}) {
    const double square = double(m) * m;
    for (const FlipOptions& options :
         {FlipOptions{}, FlipOptions{.method = Method::sweeps, .scan = Scan::shuffled}}) {
      const double flips = static_cast<double>(flips_of(m, options).flips);
      EXPECT_GT(flips, 0.5 * square);
      EXPECT_LT(flips, square);
    }
  }
}

}  // namespace
}  // namespace tribunal::flips
