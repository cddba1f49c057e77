// A plug-in behind the interface of kernels, in this process.
#include "algorithms/plugin/loader.hpp"

#include "algorithms/list.hpp"
#include "algorithms/triangulate.hpp"
#include "predicates/plugin/loader.hpp"
#include "tests/plugin/trial.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace tribunal::plugin_tests {
namespace {

PredicatePlugin load_predicates(const std::string& name) {
  return PredicatePlugin::load(SharedLibrary(module_file(name))).value();
}

TEST(Loader, SignsComeThroughWithTheirStage) {
  const PredicatePlugin plugin = load_predicates("integers");
  EXPECT_EQ(plugin.name(), "integers");
  EXPECT_TRUE(plugin.offers(Predicate::orient3d));
  EXPECT_FALSE(plugin.offers(Predicate::insphere));
  EXPECT_FALSE(plugin.offers_batch(Predicate::orient2d));
  const std::vector<Point2> points{{{0, 0}}, {{1, 0}}, {{0, 1}}, {{1, 1}}};
  const Kernel2Binding bound = plugin.bind2(points);
  const Kernel2& kernel = *std::get<0>(bound);
  const Decision decision = kernel.decide_orient2d(points[0], points[1], points[2]);
  EXPECT_EQ(decision.sign, Sign::positive);
  EXPECT_EQ(decision.stage, Stage::plugin);
  EXPECT_EQ(kernel.orient2d(points[0], points[2], points[1]), Sign::negative);
  EXPECT_EQ(kernel.incircle(points[0], points[1], points[2], points[3]), Sign::zero);
}

TEST(Loader, RefusalsNameThePoint) {
  const PredicatePlugin plugin = load_predicates("integers");
  const std::vector<Point2> points{{{0, 0}}, {{1, 0.5}}, {{0.5, 1}}};
  const Kernel2Binding bound = plugin.bind2(points);
  ASSERT_TRUE(std::holds_alternative<Refusal>(bound));
  EXPECT_EQ(std::get<Refusal>(bound).point, 1U);
}

TEST(Loader, ConstructedPointsAreAdmittedOnlyWithoutADomain) {
  const std::vector<Point2> points{{{0, 0}}, {{1, 0}}, {{0, 1}}};
  const Kernel2Binding limited = load_predicates("integers").bind2(points);
  const Kernel2Binding unlimited = load_predicates("naive").bind2(points);
  EXPECT_FALSE(std::get<0>(limited)->admits({{7, 7}}));
  EXPECT_TRUE(std::get<0>(unlimited)->admits({{7, 7}}));
  EXPECT_FALSE(std::get<0>(unlimited)->admits({{7, NAN}}));
}

TEST(Loader, AnAlgorithmRunsOverAPlugin) {
  std::vector<Point2> points;
  for (int x = 0; x < 6; ++x)
    for (int y = 0; y < 6; ++y) points.push_back({{double(x), double(y)}});
  std::vector<Index> order(points.size());
  std::iota(order.begin(), order.end(), Index{0});
  const Kernel2Binding bound = load_predicates("integers").bind2(points);
  for (const PlanarAlgorithm& algorithm : planar_algorithms()) {
    Settings settings;
    if (algorithm.about.reads_values) settings["data"] = "F1";
    const Triangulation t = triangulate(points, order, *std::get<0>(bound), algorithm, settings);
    EXPECT_EQ(t.outcome, Outcome::ok) << algorithm.about.name;
    EXPECT_EQ(t.triangles.size(), 50U) << algorithm.about.name;
  }
}

TEST(Loader, TriangulatorsCountWhatTheyDoNotKeep) {
  const std::vector<Point2> points{{{0, 0}}, {{1, 0}}, {{0, 1}}};
  const auto fan = TriangulatorPlugin::load(SharedLibrary(module_file("fan"))).value();
  const PluginMesh mesh = fan.triangulate(points);
  EXPECT_EQ(mesh.ending, TRIBUNAL_DONE);
  EXPECT_EQ(mesh.triangles, (std::vector<Triangle>{{0, 1, 2}}));
  EXPECT_FALSE(TriangulatorPlugin::load(SharedLibrary(module_file("naive"))));
}

}  // namespace
}  // namespace tribunal::plugin_tests
