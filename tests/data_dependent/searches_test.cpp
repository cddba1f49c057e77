// Laws of the searches: each ends in a valid triangulation, no rougher than it began, that no flip improves.
#include "algorithms/data_dependent/searches.hpp"

#include "algorithms/data_dependent/optimize.hpp"
#include "algorithms/data_dependent/parameters.hpp"
#include "algorithms/flips/lawson.hpp"
#include "algorithms/mesh/canonical.hpp"
#include "tests/data_dependent/support.hpp"

namespace tribunal::data_dependent {
namespace {

bool improves_by_one_flip(const RoughMesh& rough) {
  for (Index edge = 0; edge < rough.mesh.edges(); ++edge)
    if (rough.is_flippable(edge) && rough.roughness.change_by_flip(rough.mesh, edge).is_better()) return true;
  return false;
}

TEST(Searches, EndInLocalOptima) {
  const Scatter scatter(80, 5);
  const Sites sites = scatter.sites();
  for (const FrankeFunction& function : franke_functions()) {
    const auto data = sample(function, scatter.points);
    for (const std::string_view cost : cost_parameter.choices())
      for (const std::string_view norm : norm_parameter.choices())
        for (const std::string_view search : search_parameter.choices()) {
          const Settings settings{
              {"cost", std::string(cost)}, {"norm", std::string(norm)}, {"search", std::string(search)}};
          SCOPED_TRACE(testing::Message() << function.name << " " << cost << " " << norm << " " << search);
          EdgeMesh mesh(scatter.delaunay);
          const Roughness roughness = chosen_roughness(scatter.points, data, settings);
          const double before = roughness.total(mesh);
          const FlipCounts counts = flip_for_data(sites, mesh, data, settings);
          EXPECT_GT(counts.flips, 0U);
          EXPECT_FALSE(improves_by_one_flip({sites, mesh, roughness}));
          // Annealing may climb; the others never do.
          if (search != "annealing") {
            EXPECT_LT(roughness.total(mesh), before);
          }
          const auto triangles = mesh.triangles();
          const auto verdict =
              verify::verify_planar(scatter.points, {triangles}, {.kind = verify::Kind::triangulation});
          EXPECT_TRUE(verdict.valid());
          EdgeMesh again(scatter.delaunay);
          flip_for_data(sites, again, data, settings);
          EXPECT_EQ(again.triangles(), triangles) << "not deterministic";
        }
  }
}

/// Every pair of flips that look-ahead tries, tried here in full.
TEST(LookAhead, LeavesNoPairThatGains) {
  const Scatter scatter(40, 8);
  const Sites sites = scatter.sites();
  const auto data = sample(franke_functions()[1], scatter.points);
  const Roughness roughness(scatter.points, data, Cost::jump_in_normal_derivatives, Norm::l1);
  EdgeMesh mesh(scatter.delaunay);
  flip_looking_ahead({sites, mesh, roughness}, most_flips(scatter.points.size()));
  const double total = roughness.total(mesh);
  for (Index first = 0; first < mesh.edges(); ++first) {
    if (!RoughMesh{sites, mesh, roughness}.is_flippable(first)) continue;
    mesh.flip(first);
    for (Index second = 0; second < mesh.edges(); ++second) {
      if (!RoughMesh{sites, mesh, roughness}.is_flippable(second)) continue;
      mesh.flip(second);
      EXPECT_GT(roughness.total(mesh), total * (1 - 1e-9));
      mesh.flip(second);
    }
    mesh.flip(first);
  }
}

TEST(Annealing, DependsOnItsSeedAlone) {
  const Scatter scatter(60, 2);
  const Sites sites = scatter.sites();
  const auto data = sample(franke_functions()[0], scatter.points);
  const Roughness roughness(scatter.points, data, Cost::angle_between_normals, Norm::l2);
  const auto annealed = [&](std::uint64_t seed) {
    EdgeMesh mesh(scatter.delaunay);
    anneal({sites, mesh, roughness}, most_flips(scatter.points.size()), {.seed = seed, .temperatures = 10});
    return digest(mesh.triangles());
  };
  EXPECT_EQ(annealed(1), annealed(1));
  EXPECT_NE(annealed(1), annealed(2));
}

/// Data on a plane leave nothing to gain but rounding, and rounding does not go round in circles.
TEST(Searches, EndOnFlatData) {
  const Scatter scatter(100, 4);
  const Sites sites = scatter.sites();
  std::vector<double> data;
  for (const Point2& p : scatter.points) data.push_back(0.1 * p[0] + 0.7 * p[1]);
  for (const std::string_view search : search_parameter.choices()) {
    EdgeMesh mesh(scatter.delaunay);
    EXPECT_NO_THROW(flip_for_data(sites, mesh, data, {{"search", std::string(search)}})) << search;
  }
}

TEST(Data, AreRefusedWhereTheyAreMissing) {
  const Scatter scatter(10, 1);
  EXPECT_THROW(chosen_data(scatter.points, {}, {}), Abandon);
  EXPECT_EQ(chosen_data(scatter.points, {}, {{"data", "F4"}}).size(), 10U);
  const std::vector<double> own(10, 7.0);
  EXPECT_EQ(chosen_data(scatter.points, own, {}), own);
  const auto order = insertion_order(scatter.points, Order::input, 1);
  const Triangulation t =
      triangulate(scatter.points, order, scatter.sites().kernel, *find_planar_algorithm("data-dependent"));
  EXPECT_EQ(t.outcome, Outcome::refused_input);
  EXPECT_NE(t.reason.find("third column"), std::string::npos);
}

}  // namespace
}  // namespace tribunal::data_dependent
