// Stretched refinement: its laws on every domain, and what it refuses.
#include "algorithms/stretching/parameters.hpp"
#include "algorithms/verify/verify.hpp"
#include "tests/stretching/support.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace tribunal::stretching {
namespace {
using test::polygon;
using test::Sample;

Stretched refine(const Sample& sample, const Spacing& spacing, WallChoice walls = WallChoice::inner) {
  return refine_stretched(sample.graph(), sample.order, *sample.kernel, {spacing, walls, 100'000});
}

void expect_valid(const Sample& sample, const refinement::Refined& mesh) {
  const auto verdict = verify::verify_constrained(
      mesh.points, {mesh.triangles}, {sample.data.segments, sample.data.holes, verify::Domain::carved},
      {.kind = verify::Kind::triangulation});
  EXPECT_TRUE(verdict.valid()) << verdict.faults[0].detail;
}

class EveryDomain : public ::testing::TestWithParam<const char*> {};

TEST_P(EveryDomain, KeepsItsSegmentsAndItsPoints) {
  const Sample sample(find_dataset(GetParam())->graph(300, 2));
  const Stretched found = refine(sample, {1e-3, 1.3, 1});
  expect_valid(sample, found.mesh);
  EXPECT_GT(found.counts.inserted, 300U);
  EXPECT_EQ(found.mesh.points.size(), sample.data.points.size() + found.counts.inserted);
  for (std::size_t i = 0; i < sample.data.points.size(); ++i)
    EXPECT_EQ(found.mesh.points[i], sample.data.points[i]);
}

/// Vertices are numbered as they were inserted: none has an earlier one within the spacing of where it came
/// from, and that is the one exactly that far away or less.
TEST_P(EveryDomain, KeepsVerticesApart) {
  const Sample sample(find_dataset(GetParam())->graph(300, 2));
  const Spacing spacing{1e-3, 1.3, 1};
  const Stretched found = refine(sample, spacing);
  const auto& points = found.mesh.points;
  for (std::size_t v = sample.data.points.size(); v < points.size(); ++v) {
    double least = std::numeric_limits<double>::infinity();
    std::size_t nearest = 0;
    for (std::size_t w = 0; w < v; ++w) {
      const double apart = std::hypot(points[v][0] - points[w][0], points[v][1] - points[w][1]);
      if (apart < least) least = apart, nearest = w;
    }
    // Its origin is as far away as the spacing there, which is not less than where it is nearest to a wall.
    ASSERT_GE(least, spacing.at(0) * (1 - 1e-9)) << v << " and " << nearest;
    ASSERT_LE(least, spacing.at(found.distances[v]) * (1 + 1e-9)) << v << " and " << nearest;
  }
}

TEST_P(EveryDomain, GivesTheSameMeshAgain) {
  const Sample sample(find_dataset(GetParam())->graph(200, 1));
  const Stretched once = refine(sample, {1e-3, 1.4, 1}), again = refine(sample, {1e-3, 1.4, 1});
  EXPECT_EQ(once.mesh.points, again.mesh.points);
  EXPECT_EQ(once.mesh.triangles, again.mesh.triangles);
}

INSTANTIATE_TEST_SUITE_P(List, EveryDomain,
                         ::testing::Values("aerofoil", "aerofoil-blunt", "high-lift", "trailing-edge"),
                         [](const auto& name) {
                           std::string text(name.param);
                           std::ranges::replace(text, '-', '_');
                           return text;
                         });

TEST(Stretched, LaysLayersOnAFlatWall) {
  const Sample sample(polygon({{{0, 0}}, {{1, 0}}, {{2, 0}}, {{3, 0}}, {{4, 0}}, {{4, 4}}, {{0, 4}}}));
  const Stretched found = refine(sample, {0.01, 1.5, 0.5}, WallChoice::all);
  expect_valid(sample, found.mesh);
  double height = 0, step = 0.01;
  for (int layer = 0; layer < 5; ++layer, height += step, step *= 1.5) {
    const auto column = std::ranges::find_if(found.mesh.points, [&](const Point2& p) {
      return std::abs(p[0] - 2) < 1e-12 && std::abs(p[1] - height) < 1e-12;
    });
    EXPECT_NE(column, found.mesh.points.end()) << height;
  }
}

TEST(Stretched, AHighLiftMeshHasStretchedTrianglesAndNoFlatOnes) {
  const Sample sample(find_dataset("high-lift")->graph(352, 1));
  const Stretched found = refine(sample, {1e-4, 1.3, 10});
  double largest = 0, aspect = 0;
  for (const Triangle& t : found.mesh.triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      const Point2 &o = found.mesh.points[t[i]], &a = found.mesh.points[t[(i + 1) % 3]],
                   &b = found.mesh.points[t[(i + 2) % 3]];
      const double ux = a[0] - o[0], uy = a[1] - o[1], vx = b[0] - o[0], vy = b[1] - o[1];
      largest = std::max(largest, std::atan2(ux * vy - uy * vx, ux * vx + uy * vy) * 180 / std::acos(-1.0));
      aspect = std::max(aspect, (ux * ux + uy * uy) / (ux * vy - uy * vx));
    }
  EXPECT_LE(largest, 140);
  EXPECT_GE(aspect, 100);
}

TEST(Stretched, RefusesWhatMakesNoSense) {
  const Sample sample(find_dataset("aerofoil")->graph(100, 1));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const Spacing& spacing :
       {Spacing{0, 1.3, 1}, {-1, 1.3, 1}, {nan, 1.3, 1}, {1e-3, 0.5, 1}, {1e-3, nan, 1}}) {
    EXPECT_THROW(
        {
          try {
            refine(sample, spacing);
          } catch (const Abandon& abandon) {
            EXPECT_EQ(abandon.outcome, Outcome::refused_input);
            throw;
          }
        },
        Abandon);
  }
}

TEST(Stretched, RefusesSizesWhoseSquaresAreNoDoubles) {
  for (const double scale : {0x1p-900, 0x1p900}) {
    DatasetGraph domain = find_dataset("aerofoil")->graph(100, 1);
    for (Point2& p : domain.points) p = {{p[0] * scale, p[1] * scale}};
    const Sample sample(std::move(domain));
    EXPECT_THROW(refine(sample, {1e-3 * scale, 1.3, 1}), Abandon) << scale;
  }
}

TEST(Stretched, GivesUpAtTheMostVertices) {
  const Sample sample(find_dataset("aerofoil")->graph(100, 1));
  try {
    refine_stretched(sample.graph(), sample.order, *sample.kernel,
                     {{1e-6, 1.01, 1}, WallChoice::inner, 1500});
    FAIL() << "there is room for many more";
  } catch (const Abandon& abandon) {
    EXPECT_EQ(abandon.outcome, Outcome::refused_input);
    EXPECT_NE(std::string(abandon.what()).find("more than the 1500 vertices"), std::string::npos);
  }
}

TEST(Stretched, TakesPlacesThatDoublesDoNotTellApart) {
  const Sample sample(find_dataset("aerofoil")->graph(60, 1));
  const Stretched found = refine(sample, {1e-18, 3, 1});
  expect_valid(sample, found.mesh);
}

/// What bounds a hull may lie on no segment; beyond it there is nothing to swap with.
TEST(Stretched, FillsAHullWhoseEdgesAreNoSegments) {
  DatasetGraph corner{{{{0, 0}}}, {}, {}};
  for (std::uint32_t i = 1; i <= 20; ++i) {
    corner.points.push_back(i <= 10 ? Point2{{i / 10.0, 0}} : Point2{{1, (i - 10) / 10.0}});
    corner.segments.push_back({i - 1, i});
  }
  const Sample sample(std::move(corner));
  Graph graph = sample.graph();
  graph.domain = Domain::hull;
  const Stretched found =
      refine_stretched(graph, sample.order, *sample.kernel, {{0.02, 1.3, 1}, WallChoice::inner, 10'000});
  EXPECT_GT(found.counts.inserted, 10U);
  const auto verdict = verify::verify_constrained(found.mesh.points, {found.mesh.triangles},
                                                  {sample.data.segments, {}, verify::Domain::hull},
                                                  {.kind = verify::Kind::triangulation});
  EXPECT_TRUE(verdict.valid());
}

TEST(Stretched, EndsWhereItsVerticesLeaveTheBackendsDomain) {
  const Sample sample(polygon({{{0, 0}}, {{3, 0}}, {{3, 1}}, {{1, 2}}, {{1, 3}}, {{0, 3}}}));
  for (const char* name : {"knuth", "knuth64", "redundant", "fortune-van-wyk", "fixed"}) {
    const auto bound = find_backend(name)->bind2(sample.data.points);
    try {
      refine_stretched(sample.graph(), sample.order, *std::get<0>(bound),
                       {{0.02, 1.3, 1}, WallChoice::inner, 10'000});
      ADD_FAILURE() << name << " cannot place a vertex off its lattice";
    } catch (const Abandon& abandon) {
      EXPECT_EQ(abandon.outcome, Outcome::out_of_domain) << name;
    }
  }
}

TEST(Stretched, LayersOfEqualHeightAreLaidInThousands) {
  const Sample sample(polygon({{{0, 0}}, {{3, 0}}, {{3, 1}}, {{1, 1.3}}, {{1, 3}}, {{0, 3}}}));
  const Stretched found = refine(sample, {1e-3, 1, 1});
  EXPECT_GT(found.counts.inserted, 1000U);
  expect_valid(sample, found.mesh);
}

TEST(StretchingParameters, RefuseSpacingsThatAreNone) {
  for (const char* wall : {"0", "-1e-4", "nan", "inf", "wide", ""})
    EXPECT_NE(refuse_settings("stretched", parameters, {{"wall", wall}}), "") << wall;
  for (const char* rate : {"0.99", "-1", "nan", "x"})
    EXPECT_NE(refuse_settings("stretched", parameters, {{"growth", rate}}), "") << rate;
  EXPECT_EQ(refuse_settings("stretched", parameters, {{"wall", "1e-5"}, {"growth", "1"}}), "");
  EXPECT_EQ(options_of({{"wall", "1e-5"}}).spacing.wall, 1e-5);
  EXPECT_EQ(options_of({}).spacing.refuse(), "");
}

}  // namespace
}  // namespace tribunal::stretching
