// Segments that cross, split: nothing crosses afterwards, nothing has changed sides, and nothing has moved
// far.
#include "algorithms/constrained/crossings.hpp"

#include "algorithms/constrained/rational_point.hpp"
#include "datasets/dataset.hpp"
#include "datasets/real.hpp"
#include "predicates/backends/list.hpp"
#include "tests/constrained/lattice_graph.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace tribunal {
namespace {

mpq_class cross_product(const RationalPoint& a, const RationalPoint& b, const RationalPoint& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}
int side(Point2 a, Point2 b, Point2 c) { return sgn(cross_product(rational(a), rational(b), rational(c))); }

/// The vertices of the pieces of one segment, from its start.
std::vector<Index> chain_of(const SplitGraph& split, Index segment) {
  std::vector<Index> chain;
  for (std::size_t i = 0; i < split.segments.size(); ++i) {
    if (split.origin[i] != segment) continue;
    if (chain.empty()) chain.push_back(split.segments[i][0]);
    EXPECT_EQ(split.segments[i][0], chain.back());
    chain.push_back(split.segments[i][1]);
  }
  return chain;
}

/// The chain runs from end to end, monotone, within so many units in the last place, and no point is on its
/// other side.
void expect_faithful(const LatticeGraph& graph, const SplitGraph& split, Index segment, int units) {
  const auto [a, b] = graph.segments[segment];
  const Point2 from = graph.points[a], to = graph.points[b];
  const auto chain = chain_of(split, segment);
  ASSERT_GE(chain.size(), 2U);
  EXPECT_EQ(chain.front(), a);
  EXPECT_EQ(chain.back(), b);
  for (std::size_t i = 1; i < chain.size(); ++i) {
    const Point2 p = split.points[chain[i - 1]], q = split.points[chain[i]];
    if (from == to) continue;
    for (std::size_t axis = 0; axis < 2; ++axis) {
      EXPECT_TRUE(from[axis] <= to[axis] ? p[axis] <= q[axis] : p[axis] >= q[axis]);
    }
    for (const Point2& v : graph.points)
      if (std::min(p[0], q[0]) < v[0] && v[0] < std::max(p[0], q[0])) {
        EXPECT_GE(side(from, to, v) * side(p, q, v), 0);
      }
    const double size = std::max(std::fabs(q[0]), std::fabs(q[1]));
    const mpq_class unit(std::nextafter(size, std::numeric_limits<double>::infinity()) - size);
    const RationalPoint u = rational(from), v = rational(to);
    const mpq_class across = cross_product(u, v, rational(q));
    const mpq_class length2 = (v.x - u.x) * (v.x - u.x) + (v.y - u.y) * (v.y - u.y);
    EXPECT_LE(across * across, units * units * unit * unit * length2);
  }
}

void expect_settled(const LatticeGraph& graph, int units = 2) {
  constexpr Domain domain = Domain::hull;
  const SplitGraph split = split_crossings(graph.as(domain));
  ASSERT_EQ(split.segments.size(), split.origin.size());
  for (Index s = 0; s < graph.segments.size(); ++s) expect_faithful(graph, split, s, units);
  for (std::size_t i = 0; i < graph.points.size(); ++i) EXPECT_EQ(split.points[i], graph.points[i]);
  const Kernel2Binding bound = find_backend("filtered")->bind2(split.points);
  const auto t = triangulate_graph(split.graph(graph.as(domain)),
                                   insertion_order(split.points, Order::brio, 1), *std::get<0>(bound));
  ASSERT_EQ(t.mesh.outcome, Outcome::ok) << t.mesh.reason;
  const auto verdict = verify::verify_constrained(split.points, {t.mesh.triangles},
                                                  {split.segments, graph.holes, verify::Domain::hull});
  EXPECT_TRUE(verdict.valid()) << (verdict.valid() ? "" : verdict.faults[0].detail);
}

TEST(Crossings, SplitOnLattices) {
  Random random(21);
  int crossing = 0;
  for (int i = 0; i < 1500 && !HasFailure(); ++i) {
    const LatticeGraph graph = random_graph(random);
    SCOPED_TRACE(describe(graph));
    crossing += any_crossing(graph);
    expect_settled(graph);
  }
  EXPECT_GT(crossing, 100);
}

LatticeGraph random_segments(Random& random, std::size_t n, double stretch, double offset) {
  LatticeGraph graph;
  for (Index i = 0; i < n; ++i) {
    for (int end = 0; end < 2; ++end)
      graph.points.push_back({{offset + random.unit() * stretch, offset + random.unit()}});
    graph.segments.push_back({2 * i, 2 * i + 1});
  }
  return graph;
}

TEST(Crossings, SplitAnywhere) {
  Random random(22);
  for (const double stretch : {1.0, 1e-9, 1e6})
    for (const double offset : {0.0, 1e6, -1e12})
      expect_settled(random_segments(random, 40, stretch, offset));
}

// Lines through almost one point, and lines almost on one another: crossings closer together than doubles can
// tell.
TEST(Crossings, SplitWherePointsAreCloserThanDoubles) {
  Random random(23);
  for (int round = 0; round < 40 && !HasFailure(); ++round) {
    LatticeGraph star, bundle;
    for (Index i = 0; i < 12; ++i) {
      const double angle = 0.5 + static_cast<double>(i);
      const Point2 direction{{std::cos(angle), std::sin(angle)}};
      for (const double end : {-1.0, 1.0})
        star.points.push_back({{0.1 + end * direction[0] + random.unit() * 1e-16, 0.7 + end * direction[1]}});
      star.segments.push_back({2 * i, 2 * i + 1});
      for (const double end : {0.0, 1.0})
        bundle.points.push_back({{0.3 + end + random.unit() * 0.1, 0.3 + 0.7 * end + random.unit() * 4e-16}});
      bundle.segments.push_back({2 * i, 2 * i + 1});
    }
    expect_settled(star);
    expect_settled(bundle);
  }
}

/// Segments between the points two by two.
LatticeGraph segments_between(std::vector<Point2> points) {
  LatticeGraph graph;
  for (Index i = 0; i < points.size(); i += 2) graph.segments.push_back({i, i + 1});
  graph.points = std::move(points);
  return graph;
}

// On an axis doubles are finer across it than along it, without end at its origin: what bends by a place in y
// crosses anew a place farther on in x.
TEST(Crossings, SplitWhereDoublesAreFinerInOneDirection) {
  expect_settled(segments_between(
      {{{-0.43, 1.66}}, {{0.43, -0.26}}, {{-0.79, 1.56}}, {{0.79, -0.16}}, {{-0.49, 1.27}}, {{0.49, 0.13}}}));
  expect_settled(segments_between({{{1.1102230246251565e-16, 1.0000000000000002}},
                                   {{1.0000000000000002, 4.440892098500626e-16}},
                                   {{3.3306690738754696e-16, 1.0}},
                                   {{1.0000000000000007, 1.1102230246251565e-16}},
                                   {{2.220446049250313e-16, 1.0000000000000004}},
                                   {{1.0000000000000004, -0.9999999999999994}}}));
  Random random(29);
  for (int round = 0; round < 300 && !HasFailure(); ++round) {
    const double height = std::array{0.7, 1.0, 35.2}[random.below(3)];
    std::vector<Point2> points;
    for (int line = 0; line < 3; ++line) {
      const double x = std::round(100 * random.unit()) / 100 + 0.01,
                   y = std::round(200 * random.unit()) / 100 - 1;
      points.push_back({{-x, height + y}});
      points.push_back({{x, height - y}});
    }
    expect_settled(segments_between(std::move(points)));
  }
}

// Pieces that end in one point and cross a third segment near it, one unit of the lattice farther on each
// time.
TEST(Crossings, SplitWherePiecesLeapOverEachOther) {
  LatticeGraph three;
  three.points = {{{0.2, 0.9999999999999973}},
                  {{0.4, 0.9999999999999982}},
                  {{0.8, 0.9999999999999982}},
                  {{1000.2, 1.0}},
                  {{1000.4, 1.0000000000000018}}};
  three.segments = {{0, 4}, {1, 3}, {3, 2}};
  expect_settled(three);
}

TEST(Crossings, SplitBundlesOfDoublesNextToEachOther) {
  Random random(31);
  for (int round = 0; round < 12 && !HasFailure(); ++round) {
    std::vector<Point2> points;
    const auto height = [&] { return 1 + (static_cast<double>(random.below(19)) - 9) * 0x1p-52; };
    const double length = round % 2 == 0 ? 10 : 1000;
    const bool diagonal = round % 3 == 0;
    for (int line = 0; line < 30; ++line) {
      for (const double start : {0.0, length}) {
        const double x = start + random.unit();
        points.push_back({{x, diagonal ? x * height() : height()}});
      }
    }
    // What crosses the bundle stays where it is, too.
    for (int line = 0; line < 3; ++line) {
      points.push_back({{length * random.unit(), -1}});
      points.push_back({{length * random.unit(), length + 1}});
    }
    expect_settled(segments_between(std::move(points)), 8);
  }
}

TEST(Crossings, CoarseNumbersKeepWhatIsThereAndAreMonotone) {
  const std::vector<Point2> there{{{0.0, -4.0}}, {{3.25, 1e-20}}, {{1e-300, 1.0}}};
  const CoarseNumbers lattice(there, 0, 0);
  for (const Point2& p : there) EXPECT_EQ(lattice.nearest(rational(p)), p);
  const double unit = std::ldexp(1.0, -50);  // of the last place of 4
  EXPECT_EQ(lattice.nearest({mpq_class(1) + mpq_class(unit) / 3, mpq_class(unit) * 2 / 3}),
            (Point2{{1.0, unit}}));
  EXPECT_EQ(lattice.nearest({mpq_class(unit) / 1000, mpq_class(unit) / 1000}), (Point2{{1e-300, 1e-20}}));
  Point2 last{{0.0, -4.0}};
  for (int step = 1; step <= 1000; ++step) {
    const mpq_class part(step, 1000);
    const Point2 here = lattice.nearest({part * mpq_class(unit) * 3, part * mpq_class(unit) * 3 - 4});
    EXPECT_LE(last[0], here[0]);
    EXPECT_LE(last[1], here[1]);
    last = here;
  }
}

TEST(Crossings, CoarseNumbersHaveFewerPlaces) {
  const std::vector<Point2> there{{{-4.0, -4.0}}, {{4.0, 4.0}}, {{1.0000000000000002, 0.3}}};
  const CoarseNumbers coarse(there, 3, -20);
  const auto rounded = [&](double value) { return coarse.nearest({mpq_class(value), mpq_class(value)}); };
  EXPECT_EQ(rounded(1 + 3 * 0x1p-49), (Point2{{1 + 3 * 0x1p-49, 1 + 3 * 0x1p-49}}));
  EXPECT_EQ(rounded(1 + 3 * 0x1p-52), (Point2{{1.0000000000000002, 1}})) << "x is there, or 2^-49 apart";
  EXPECT_EQ(rounded(-0.75 + 0x1p-53), (Point2{{-0.75, -0.75}}));
  constexpr double most = std::numeric_limits<double>::max();
  const std::vector<Point2> ends{{{-most, most}}, {{most, -most}}};
  const mpq_class nearly = mpq_class(most) - 1;
  EXPECT_EQ(CoarseNumbers(ends, 3, 0).nearest({nearly, -nearly}), (Point2{{most, -most}}));
  EXPECT_EQ(rounded(0x1.8p-71), (Point2{{0x1p-70, 0x1p-70}})) << "none is finer than 2^-70";
}

TEST(Crossings, NearestDoubles) {
  const auto half = [](double low) -> mpq_class {
    return (mpq_class(low) + mpq_class(std::nextafter(low, 1e300))) / 2;
  };
  EXPECT_EQ(nearest({mpq_class(1, 3), mpq_class(-1, 3)}), (Point2{{1.0 / 3, -1.0 / 3}}));
  EXPECT_EQ(nearest({half(1.0), half(std::nextafter(1.0, 2.0))}),
            (Point2{{1.0, std::nextafter(std::nextafter(1.0, 2.0), 2.0)}}));
  EXPECT_EQ(nearest({mpq_class(5e-324) / 3, mpq_class(5e-324) * 2 / 3}), (Point2{{0.0, 5e-324}}));
  EXPECT_EQ(nearest({mpq_class(0), mpq_class(std::numeric_limits<double>::max())}),
            (Point2{{0.0, std::numeric_limits<double>::max()}}));
}

// The lattice of the county borders is coarse enough for some of them to cross.
TEST(Crossings, OfTheCounties) {
  const RealGraph arcs = county_arcs();
  const Graph graph{arcs.points, arcs.segments};
  const SplitGraph split = split_crossings(graph);
  EXPECT_GT(split.points.size(), arcs.points.size());
  const Kernel2Binding bound = find_backend("filtered")->bind2(split.points);
  for (const Domain domain : {Domain::hull, Domain::carved}) {
    const auto t = triangulate_graph({split.points, split.segments, {}, domain},
                                     insertion_order(split.points, Order::brio, 1), *std::get<0>(bound));
    ASSERT_EQ(t.mesh.outcome, Outcome::ok) << t.mesh.reason;
    const auto verdict = verify::verify_constrained(
        split.points, {t.mesh.triangles}, {split.segments, {}, static_cast<verify::Domain>(domain)});
    EXPECT_TRUE(verdict.valid()) << (verdict.valid() ? "" : verdict.faults[0].detail);
  }
}

}  // namespace
}  // namespace tribunal
