// Laws that every planar algorithm obeys, on every dataset, with every exact backend that accepts
// it.
#include "algorithms/mesh/canonical.hpp"
#include "tests/conformance/run.hpp"

namespace tribunal {
namespace {

struct Case {
  const PlanarAlgorithm* algorithm;
  const Dataset* dataset;
};

class PlanarConformance : public testing::TestWithParam<Case> {
 protected:
  std::vector<Point2> points(std::uint64_t n, std::uint64_t seed) const {
    return GetParam().dataset->generate(n, seed);
  }
  const PlanarAlgorithm& algorithm() const { return *GetParam().algorithm; }
};

std::string case_name(const testing::TestParamInfo<Case>& info) {
  return test_name(info.param.algorithm->about.name) + "_" + test_name(info.param.dataset->about.name);
}

std::vector<Case> all_cases() {
  std::vector<Case> cases;
  for (const auto& algorithm : planar_algorithms())
    for (const auto& dataset : datasets()) cases.push_back({&algorithm, &dataset});
  return cases;
}

// Sizes at which every algorithm is quick, and at which quantised data collide.
constexpr std::uint64_t sizes[] = {1, 2, 3, 4, 7, 30, 200};

TEST_P(PlanarConformance, ExactBackendsGiveTheOneValidTriangulation) {
  for (const std::uint64_t n : sizes) {
    const auto sites = points(n, 5);
    std::string reference;
    for (const BackendEntry& backend : backends()) {
      if (!backend.about->exact) continue;
      const Triangulation t = run(sites, algorithm(), backend.about->name);
      if (t.outcome == Outcome::out_of_domain) continue;
      ASSERT_EQ(t.outcome, Outcome::ok) << backend.about->name << " n=" << n << ": " << t.reason;
      const auto verdict = check(sites, t, algorithm().about.promise);
      EXPECT_TRUE(verdict.valid()) << backend.about->name << " n=" << n << "\n" << faults_of(verdict);
      EXPECT_EQ(verdict.dimension, t.dimension);
      EXPECT_EQ(verdict.hull, t.hull);
      const std::string found = to_hex(digest(t.triangles));
      if (reference.empty()) reference = found;
      EXPECT_EQ(found, reference) << backend.about->name << " n=" << n;
    }
  }
}

TEST_P(PlanarConformance, EulerCountsTriangles) {
  const auto sites = points(200, 2);
  const Triangulation t = run(sites, algorithm());
  const std::uint64_t distinct = sites.size() - t.duplicates.size();
  if (t.dimension == 2) {
    EXPECT_EQ(t.triangles.size(), 2 * distinct - 2 - t.hull);
    EXPECT_TRUE(t.edges.empty());
  } else {
    EXPECT_TRUE(t.triangles.empty());
    EXPECT_EQ(t.edges.size(), distinct - 1);
  }
}

// tau and tau_with_ghosts depend on points and order alone, ties or not: a strict conflict test leaves the
// same cavity whether it is flooded, scanned for or reached by flips.
TEST_P(PlanarConformance, AllInsertionsAgreeOnMeshAndTau) {
  if (!algorithm().about.incremental) return;
  for (const Order order : {Order::random, Order::input, Order::x, Order::hilbert}) {
    const auto sites = points(150, 3);
    const Triangulation mine = run(sites, algorithm(), "gmp", order, 9);
    const Triangulation first = run(sites, planar_algorithms()[0], "gmp", order, 9);
    EXPECT_EQ(digest(mine.triangles), digest(first.triangles));
    EXPECT_EQ(mine.edges, first.edges);
    EXPECT_EQ(mine.counters.tau, first.counters.tau);
    EXPECT_EQ(mine.counters.tau_with_ghosts, first.counters.tau_with_ghosts);
    EXPECT_EQ(mine.counters.outside_hull, first.counters.outside_hull);
  }
}

// With N distinct sites, E of them on an edge when inserted and F flips, ghosts counted (see Counters).
TEST_P(PlanarConformance, CounterIdentities) {
  if (!algorithm().about.incremental) return;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const auto sites = points(100, seed);
    const Triangulation t = run(sites, algorithm(), "gmp", Order::random, seed);
    if (t.dimension < 2) continue;
    const Counters& c = t.counters;
    const std::uint64_t n = sites.size() - t.duplicates.size();
    EXPECT_EQ(c.tau, c.tau_with_ghosts - 2 * c.outside_hull);
    EXPECT_EQ(c.tau_with_ghosts, c.created - c.flips - 1);
    if (!t.history) continue;
    EXPECT_EQ(c.created, 4 + 3 * (n - 3) + c.on_edge + 2 * c.flips);
    EXPECT_EQ(t.history->nodes, c.created);
    EXPECT_EQ(c.tau_with_ghosts, 3 * (n - 2) + c.on_edge + c.flips);
    EXPECT_EQ(c.conflict_tests, c.created - 4);
  }
}

TEST_P(PlanarConformance, SameInputSameBytes) {
  const auto sites = points(120, 4);
  const Triangulation a = run(sites, algorithm()), b = run(sites, algorithm());
  EXPECT_EQ(a.triangles, b.triangles);
  EXPECT_EQ(a.counters.created, b.counters.created);
  EXPECT_EQ(a.counters.location_steps, b.counters.location_steps);
}

// A backend that is not exact may fail, but it must end and say how.
TEST_P(PlanarConformance, WrongSignsEnd) {
  for (const BackendEntry& backend : backends()) {
    if (backend.about->exact) continue;
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
      const auto sites = points(150, seed);
      const Triangulation t = run(sites, algorithm(), backend.about->name, Order::random, seed);
      if (t.outcome == Outcome::ok) continue;
      EXPECT_FALSE(t.reason.empty());
      EXPECT_TRUE(t.outcome == Outcome::inconsistent_predicate || t.outcome == Outcome::loop ||
                  t.outcome == Outcome::out_of_domain)
          << to_string(t.outcome);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, PlanarConformance, testing::ValuesIn(all_cases()), case_name);

}  // namespace
}  // namespace tribunal
