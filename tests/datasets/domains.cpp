// Datasets with segments are domains: simple loops, no crossings, and the shapes that they say.
#include "datasets/dataset.hpp"
#include "datasets/random.hpp"
#include "datasets/shapes/outline.hpp"
#include "tests/datasets/support.hpp"

#include <gmpxx.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace tribunal {
namespace {

int exact_side(const Point2& a, const Point2& b, const Point2& c) {
  return sgn((mpq_class(b[0]) - a[0]) * (mpq_class(c[1]) - a[1]) -
             (mpq_class(b[1]) - a[1]) * (mpq_class(c[0]) - a[0]));
}

using Ends = std::array<std::uint32_t, 2>;

bool meet(const DatasetGraph& graph, const Ends& s, const Ends& t) {
  const auto& p = graph.points;
  const auto box_apart = [&](std::size_t axis) {
    const auto [s_low, s_high] = std::minmax({p[s[0]][axis], p[s[1]][axis]});
    const auto [t_low, t_high] = std::minmax({p[t[0]][axis], p[t[1]][axis]});
    return s_high < t_low || t_high < s_low;
  };
  if (box_apart(0) || box_apart(1)) return false;
  return exact_side(p[s[0]], p[s[1]], p[t[0]]) * exact_side(p[s[0]], p[s[1]], p[t[1]]) <= 0 &&
         exact_side(p[t[0]], p[t[1]], p[s[0]]) * exact_side(p[t[0]], p[t[1]], p[s[1]]) <= 0;
}

bool share_an_end(const Ends& s, const Ends& t) {
  return s[0] == t[0] || s[0] == t[1] || s[1] == t[0] || s[1] == t[1];
}

/// How often a ray from p to the right crosses segments.
int crossings_right_of(const DatasetGraph& graph, const Point2& p) {
  int crossings = 0;
  for (const auto& [i, j] : graph.segments) {
    const Point2 &a = graph.points[i], &b = graph.points[j];
    if ((a[1] <= p[1]) == (b[1] <= p[1])) continue;
    crossings += exact_side(a[1] < b[1] ? a : b, a[1] < b[1] ? b : a, p) > 0;
  }
  return crossings;
}

class EveryDomain : public ::testing::TestWithParam<std::string_view> {
 protected:
  DatasetGraph graph(std::uint64_t n, std::uint64_t seed) const {
    return find_dataset(GetParam())->graph(n, seed);
  }
};

TEST_P(EveryDomain, IsMadeOfClosedLoopsThatDoNotMeet) {
  for (const std::uint64_t seed : {1, 2, 6, 9}) {
    const DatasetGraph domain = graph(300, seed);
    EXPECT_EQ(test::distinct(domain.points), domain.points.size());
    std::map<std::uint32_t, int> degree;
    for (const auto& [a, b] : domain.segments) ++degree[a], ++degree[b];
    for (const auto& [vertex, count] : degree) ASSERT_EQ(count, 2) << vertex;
    for (std::size_t i = 0; i < domain.segments.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) {
        const Ends &s = domain.segments[i], &t = domain.segments[j];
        ASSERT_TRUE(share_an_end(s, t) || !meet(domain, s, t)) << i << " meets " << j << ", seed " << seed;
      }
  }
}

TEST_P(EveryDomain, HasHolesInsideItsElements) {
  for (const std::uint64_t seed : {1, 5, 9})
    for (const std::uint64_t n : {1, 300, 2000}) {
      const DatasetGraph domain = graph(n, seed);
      ASSERT_FALSE(domain.holes.empty());
      for (const Point2& hole : domain.holes) {
        // Inside the box and one of the elements, past whatever else.
        EXPECT_GE(crossings_right_of(domain, hole), 2);
        EXPECT_EQ(crossings_right_of(domain, hole) % 2, 0);
      }
    }
}

TEST_P(EveryDomain, HasAboutThePointsAskedFor) {
  for (const std::uint64_t n : {352, 1000, 5000}) {
    const auto size = static_cast<double>(graph(n, 1).points.size());
    EXPECT_NEAR(size, static_cast<double>(n), 130);
  }
}

INSTANTIATE_TEST_SUITE_P(List, EveryDomain,
                         ::testing::Values("trailing-edge", "trailing-edge-blunt", "aerofoil",
                                           "aerofoil-blunt", "high-lift"),
                         [](const auto& name) {
                           std::string text(name.param);
                           std::ranges::replace(text, '-', '_');
                           return text;
                         });

/// Abbott and von Doenhoff, Theory of Wing Sections: ordinates of the NACA 0012 at 10, 30 and 60 % chord.
TEST(Aerofoil, HasThePublishedOrdinates) {
  for (const Point2& ordinate : {Point2{{0.1, 0.04683}}, Point2{{0.3, 0.06002}}, Point2{{0.6, 0.04563}}}) {
    const auto points = find_dataset("aerofoil-blunt")->graph(20000, 1).points;
    const auto nearest = std::ranges::min_element(
        points, {}, [&](const Point2& p) { return std::hypot(p[0] - ordinate[0], p[1] - ordinate[1]); });
    EXPECT_NEAR((*nearest)[1], ordinate[1], 2e-5) << ordinate[0];
  }
}

TEST(HighLift, HasTheGapsThatItsSeedsSay) {
  const std::array gaps{0.02, 0.015, 0.01};
  for (std::uint64_t seed = 1; seed <= 9; ++seed) {
    const DatasetGraph domain = find_dataset("high-lift")->graph(2032, seed);
    const auto& points = domain.points;  // 1000 of the main element, 500 each of flap and slat
    double gap[2] = {1, 1};
    for (std::size_t i = 0; i < 1000; ++i)
      for (std::size_t j = 1000; j < 2000; ++j)
        gap[j >= 1500] =
            std::min(gap[j >= 1500], std::hypot(points[i][0] - points[j][0], points[i][1] - points[j][1]));
    for (const double found : gap) EXPECT_NEAR(found, gaps[(seed - 1) / 3], 3e-4) << seed;
  }
}

TEST(TrailingEdge, GraphBeginsWithWholeStationsOfTheDataset) {
  for (const char* name : {"trailing-edge", "trailing-edge-blunt"}) {
    const auto points = find_dataset(name)->generate(1000, 2);
    const auto domain = find_dataset(name)->graph(1000, 2);
    std::size_t same = 0;
    while (same < points.size() && points[same] == domain.points[same]) ++same;
    EXPECT_GT(same, 950U) << name;
    EXPECT_LE(same, 1000U) << name;
  }
}

/// By all pairs of a vertex and a side.
double distance_by_definition(const shapes::Outline& a, const shapes::Outline& b) {
  double least = std::numeric_limits<double>::infinity();
  const auto look = [&](const shapes::Outline& points, const shapes::Outline& sides) {
    for (const Point2& p : points)
      for (std::size_t i = 0; i < sides.size(); ++i) {
        const Point2 &from = sides[i], &to = sides[(i + 1) % sides.size()];
        const double ux = to[0] - from[0], uy = to[1] - from[1], vx = p[0] - from[0], vy = p[1] - from[1];
        const double t = std::clamp((ux * vx + uy * vy) / (ux * ux + uy * uy), 0.0, 1.0);
        least = std::min(least, std::hypot(vx - t * ux, vy - t * uy));
      }
  };
  look(a, b);
  look(b, a);
  return least;
}

TEST(Outlines, DistanceIsThatOfTheNearestPair) {
  Random random(7);
  constexpr shapes::FourDigit section{.camber = 0.04, .camber_at = 0.4, .thickness = 0.12, .blunt = false};
  for (const std::uint64_t stations : {2, 31, 32, 33, 200}) {
    const shapes::Outline wing = shapes::outline_of(section, stations);
    for (int round = 0; round < 20; ++round) {
      const double x = 4 * random.unit() - 2, y = random.unit() + 0.5;
      const shapes::Outline other = shapes::moved(shapes::turned(wing, 1 + random.unit(), 0.6, 0.8), x, y);
      EXPECT_NEAR(shapes::distance(wing, other), distance_by_definition(wing, other), 1e-13) << stations;
    }
  }
}

}  // namespace
}  // namespace tribunal
