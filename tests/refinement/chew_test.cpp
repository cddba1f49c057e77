// Circumcentre refinement: what it promises, judged by the exact checker and by angles taken again.
#include "algorithms/refinement/chew.hpp"

#include "algorithms/mesh/canonical.hpp"
#include "datasets/dataset.hpp"
#include "predicates/backends/list.hpp"
#include "tests/constrained/lattice_graph.hpp"
#include "tests/refinement/judged.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <set>

namespace tribunal::refinement {
namespace {

constexpr std::uint64_t few = 20'000;  // vertices

Refinement refine(const DatasetGraph& domain, const ChewOptions& options, Domain kind = Domain::carved,
                  std::string_view backend = "filtered") {
  const Kernel2Binding bound = find_backend(backend)->bind2(domain.points);
  const auto order = insertion_order(domain.points, Order::random, 1);
  return refine_by_circumcentres({domain.points, domain.segments, domain.holes, kind}, order,
                                 *std::get<0>(bound), options);
}

Corners corners(const Refined& mesh, const Triangle& t) {
  return {mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]};
}

/// Written anew: the squared sine of the smallest angle is exactly cross^2 / (|u|^2 |v|^2) at one corner.
bool below_30_degrees(const Corners& t) {
  for (std::size_t i = 0; i < 3; ++i) {
    const auto at = [&](std::size_t k, std::size_t axis) { return mpq_class(t[(i + k) % 3][axis]); };
    const mpq_class ux = at(1, 0) - at(0, 0), uy = at(1, 1) - at(0, 1), vx = at(2, 0) - at(0, 0),
                    vy = at(2, 1) - at(0, 1);
    const mpq_class dot = ux * vx + uy * vy;
    if (dot > 0 && 4 * dot * dot > 3 * (ux * ux + uy * uy) * (vx * vx + vy * vy)) return true;
  }
  return false;
}

std::uint64_t sharp(const Refined& mesh) {
  return static_cast<std::uint64_t>(
      std::count_if(mesh.triangles.begin(), mesh.triangles.end(),
                    [&](const Triangle& t) { return below_30_degrees(corners(mesh, t)); }));
}

TEST(Chew, DomainsOfTheHardKinds) {
  for (const char* name : {"gulf", "fractal-coast", "wedge", "comb", "fan", "aerofoil", "high-lift"}) {
    SCOPED_TRACE(name);
    const DatasetGraph domain = find_dataset(name)->graph(100, 1);
    const Refinement done = refine(domain, {.most_vertices = few});
    ASSERT_EQ(done.report.mesh.outcome, Outcome::ok) << done.report.mesh.reason;
    EXPECT_EQ(faults_of(done.mesh, domain.holes, verify::Domain::carved), "");
    expect_paths(done.mesh, domain.points, domain.segments);
    EXPECT_EQ(sharp(done.mesh), done.counts.forced);
    EXPECT_EQ(done.counts.unresolved, 0U);
    if (done.counts.small_input_angles == 0) {
      EXPECT_EQ(done.counts.forced, 0U);
    }
  }
}

// Without small input angles all angles are between 30 and 120 degrees, at every size.
TEST(Chew, AnglesBetween30And120Degrees) {
  const DatasetGraph square{
      {{{0, 0}}, {{3, 0}}, {{3, 1}}, {{2, 1}}, {{2, 2}}, {{0, 2}}, {{1, 1}}, {{1, 1.5}}},
      {{0, 1}, {1, 2}, {2, 3}, {3, 4}, {4, 5}, {5, 0}, {6, 7}},
      {}};
  for (const char* size : {"none", "0.5", "0.07", "0.02 + 0.1 * hypot(x - 1, y)", "boundary"}) {
    SCOPED_TRACE(size);
    const Size wanted = Size::parse(size);
    const Refinement done = refine(square, {.size = wanted, .most_vertices = few});
    ASSERT_EQ(done.report.mesh.outcome, Outcome::ok) << done.report.mesh.reason;
    EXPECT_EQ(faults_of(done.mesh, {}, verify::Domain::carved), "");
    EXPECT_EQ(sharp(done.mesh), 0U);
    for (const Triangle& t : done.mesh.triangles) {
      const Corners at = corners(done.mesh, t);
      EXPECT_LE(extreme_angles(at)[1], 120.0001);
      const auto edges = edge_lengths(at);
      if (wanted.kind == Size::Kind::uniform) {
        EXPECT_LE(*std::max_element(edges.begin(), edges.end()), wanted.length);
      }
    }
  }
}

TEST(Chew, WedgeKeepsItsOneSmallAngle) {
  const Refinement done = refine(find_dataset("wedge")->graph(3, 1), {.most_vertices = few});
  EXPECT_EQ(done.counts.small_input_angles, 1U);
  EXPECT_GE(done.counts.forced, 1U);
  EXPECT_LE(done.counts.forced, 10U);
}

TEST(Chew, GivesUpBeyondItsVertices) {
  const DatasetGraph slots = find_dataset("slot")->graph(8, 1);
  const Refinement refused = refine(slots, {.most_vertices = 2000});
  EXPECT_EQ(refused.report.mesh.outcome, Outcome::refused_input);
  EXPECT_NE(refused.report.mesh.reason.find("2000 vertices"), std::string::npos);
  EXPECT_TRUE(refused.mesh.triangles.empty());
}

TEST(Chew, BackendsAgreeOrRefuse) {
  const DatasetGraph comb = find_dataset("comb")->graph(20, 1);
  std::set<std::uint64_t> digests;
  for (const BackendEntry& backend : backends()) {
    if (!backend.about->exact) continue;
    const Kernel2Binding bound = backend.bind2(comb.points);
    if (std::holds_alternative<Refusal>(bound)) continue;
    const Refinement done = refine(comb, {.most_vertices = few}, Domain::carved, backend.about->name);
    if (done.report.mesh.outcome == Outcome::ok)
      digests.insert(digest(done.mesh.triangles));
    else
      EXPECT_EQ(done.report.mesh.outcome, Outcome::out_of_domain) << backend.about->name;
  }
  EXPECT_EQ(digests.size(), 1U);
}

TEST(Chew, WrongSignsEnd) {
  const DatasetGraph coast = find_dataset("fractal-coast")->graph(60, 2);
  for (const BackendEntry& backend : backends()) {
    const Kernel2Binding bound = backend.bind2(coast.points);
    if (std::holds_alternative<Refusal>(bound)) continue;
    const Refinement done = refine(coast, {.most_vertices = 3000}, Domain::carved, backend.about->name);
    EXPECT_TRUE(done.report.mesh.outcome == Outcome::ok || !done.report.mesh.reason.empty());
  }
}

TEST(Size, TextsThatAreNone) {
  for (const char* text : {"0", "-1", "nan", "inf", "1e999", "x +", "z", "sqrt 2", "(x", "max(x)", "1/0", ""})
    EXPECT_THROW(Size::parse(text), Abandon) << text;
  EXPECT_EQ(Size::parse("2 * 3 - 4 / 2 ^ 2").length, 5);
  EXPECT_EQ(Size::parse("none").kind, Size::Kind::none);
  EXPECT_EQ(Size::parse("min(x, 2)").kind, Size::Kind::formula);
}

TEST(Formula, Precedence) {
  constexpr std::array<std::string_view, 2> names{"x", "y"};
  const auto value = [&](std::string_view text) { return Formula(text, names)(std::array{3.0, 2.0}); };
  EXPECT_EQ(value("-x ^ 2"), -9);
  EXPECT_EQ(value("2 ^ 3 ^ 2"), 512);
  EXPECT_EQ(value("x - y - 1"), 0);
  EXPECT_EQ(value("x / y / 2"), 0.75);
  EXPECT_EQ(value("-(x - y) * -2"), 2);
  EXPECT_EQ(value("max(x, min(y, 7)) + hypot(x + 1, y - 5)"), 8);
  EXPECT_EQ(value("2^-1"), 0.5);
}

// The filtered comparison against rational numbers, on triangles around the bound.
TEST(Shape, SharperIsExact) {
  Random random(21);
  int sharper = 0;
  for (int i = 0; i < 20'000; ++i) {
    // Of a regular hexagon's corner: 30 degrees up to rounding.
    const double scale = random.unit() + 0.5, u = random.unit(), v = random.unit();
    const double x = scale * 1.7320508075688772, y = scale;
    const Corners t{{{{u, v}}, {{u + x, v + (i % 2) * 0x1p-52}}, {{u + x, v + y}}}};
    const bool expected = below_30_degrees(t);
    EXPECT_EQ(is_sharper(t, {0.25}), expected);
    sharper += expected;
  }
  EXPECT_GT(sharper, 2000);
  EXPECT_LT(sharper, 18'000);
}

// A hull bent by earlier splits leaves no double on its old line; a circumcentre rounded to just beside a
// held edge leaves none on the edge. Both need splits all the same.
TEST(Chew, RoundingIsNoReasonToStop) {
  const DatasetGraph bent{
      {{{5, 0}}, {{1, 2}}, {{4, 1}}, {{1, 5}}, {{1, 2}}}, {{0, 1}, {1, 2}, {2, 3}, {3, 4}}, {}};
  const Refinement hull = refine(bent, {.bound = AngleBound::degrees(20)}, Domain::hull);
  EXPECT_EQ(hull.counts.unresolved, 0U);
  EXPECT_GT(hull.counts.splits, 0U);
  const DatasetGraph beside{
      {{{4, 4}}, {{4, 6}}, {{0, 3}}, {{1, 2}}, {{3, 3}}}, {{0, 1}, {1, 2}, {2, 3}, {3, 4}, {4, 0}}, {}};
  const Refinement done = refine(beside, {.size = Size::parse("0.7")});
  EXPECT_EQ(done.counts.unresolved, 0U);
  EXPECT_EQ(sharp(done.mesh), 0U);
  EXPECT_EQ(faults_of(done.mesh, {}, verify::Domain::carved), "");
}

// Powers of two change nothing but exponents, as far as doubles go.
TEST(Chew, ScaleDoesNotMatter) {
  const auto wedge = [](double scale) {
    std::vector<Point2> points;
    for (const Point2 p :
         {Point2{{0, 0}}, {{8, 0}}, {{8, 5}}, {{0, 5}}, {{3, 2}}, {{5, 2.125}}, {{5, 2.625}}})
      points.push_back({{p[0] * scale, p[1] * scale}});
    return DatasetGraph{points, {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}, {4, 6}}, {}};
  };
  for (const char* size : {"none", "boundary"}) {
    const Refinement one = refine(wedge(1), {.size = Size::parse(size)});
    ASSERT_EQ(one.report.mesh.outcome, Outcome::ok);
    EXPECT_EQ(one.counts.small_input_angles, 1U);
    for (const double scale : {0x1p-900, 0x1p-400, 0x1p-210, 0x1p190, 0x1p500, 0x1p1000}) {
      const Refinement other = refine(wedge(scale), {.size = Size::parse(size)});
      EXPECT_EQ(other.mesh.triangles, one.mesh.triangles) << size << ' ' << scale;
    }
  }
}

/// What became of random graphs on the lattice.
struct Fates {
  int meshed = 0, given_up = 0, unresolved = 0;
};

/// One random graph, refined as far as 3000 vertices go.
void refine_random(Random& random, int i, Fates& fates) {
  constexpr std::array domains{Domain::hull, Domain::carved, Domain::even_odd};
  const Domain domain = domains[static_cast<std::size_t>(i % 3)];
  LatticeGraph graph = random_graph(random);
  if (i % 2 == 1)
    for (Point2& p : graph.points) p = {{0.6 * p[0] - 0.8 * p[1], 0.8 * p[0] + 0.6 * p[1]}};
  SCOPED_TRACE("case " + std::to_string(i) + "\n" + describe(graph));
  const DatasetGraph whole{graph.points, graph.segments,
                           domain == Domain::carved ? graph.holes : std::vector<Point2>{}};
  const ChewOptions options{.bound = AngleBound::degrees(i % 5 == 0 ? 20 : 30),
                            .size = i % 4 == 0 ? Size::parse("0.7") : Size{},
                            .most_vertices = 3000};
  const Refinement done = refine(whole, options, domain);
  if (done.report.mesh.outcome != Outcome::ok) {
    EXPECT_EQ(done.report.mesh.outcome, Outcome::refused_input) << done.report.mesh.reason;
    const bool endless = done.report.mesh.reason.find("vertices") != std::string::npos;
    fates.given_up += i % 2 == 0 && endless;  // off the lattice there are slots and needles of one double
    return;
  }
  ++fates.meshed;
  const auto meant = domain == Domain::even_odd ? verify::Domain::even_odd : verify::Domain::carved;
  EXPECT_EQ(faults_of(done.mesh, whole.holes, meant), "");
  expect_paths(done.mesh, whole.points, whole.segments);
  // Off the lattice points are nearly on one line, and doubles end between them.
  fates.unresolved += i % 2 == 0 && done.counts.unresolved > 0;
  const Refinement again = refine(whole, options, domain);
  EXPECT_EQ(digest(again.mesh.triangles), digest(done.mesh.triangles));
}

TEST(Chew, RandomGraphs) {
  const int cases = std::getenv("TRIBUNAL_LONG_TIERS") == nullptr ? 600 : 100'000;
  Random random(22);
  Fates fates;
  for (int i = 0; i < cases && !::testing::Test::HasFailure(); ++i) refine_random(random, i, fates);
  EXPECT_GT(fates.meshed, cases / 10);
  EXPECT_EQ(fates.given_up, 0);
  EXPECT_EQ(fates.unresolved, 0);
}

}  // namespace
}  // namespace tribunal::refinement
