// Laws of tie breaking: it is what an actual small perturbation gives, hence alternating and the same in
// every order; it changes no sign that is not zero; and it leaves no tie among points in general position.
#include "predicates/symbolic/simulation_of_simplicity.hpp"
#include "tests/laws/kernels.hpp"

#include <boost/multiprecision/cpp_int.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <string>
#include <vector>

namespace tribunal::laws {
namespace {

using Integer = boost::multiprecision::cpp_int;
using Matrix = std::vector<std::vector<Integer>>;

/// Sign of the determinant by Leibniz's sum.
Sign leibniz_sign(const Matrix& m) {
  std::vector<std::size_t> permutation(m.size());
  std::iota(permutation.begin(), permutation.end(), std::size_t{0});
  Integer determinant = 0;
  do {
    Integer term = 1;
    for (std::size_t i = 0; i < m.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        if (permutation[j] > permutation[i]) term = -term;
    for (std::size_t i = 0; i < m.size(); ++i) term *= m[i][permutation[i]];
    determinant += term;
  } while (std::next_permutation(permutation.begin(), permutation.end()));
  return static_cast<Sign>(determinant.sign());
}

template <int D>
Matrix integer_rows(const auto& points, bool lifted) {
  Matrix m;
  for (const auto& p : points) {
    auto& row = m.emplace_back(1, Integer(1));
    Integer lift = 0;
    for (int axis = 0; axis < D; ++axis) {
      row.emplace_back(static_cast<std::int64_t>(p[axis]));
      lift += row.back() * row.back();
    }
    if (lifted) row.push_back(lift);
  }
  return m;
}

/// How many of the points are lexicographically greater than the i-th.
std::size_t greater(const auto& points, std::size_t i) {
  return static_cast<std::size_t>(
      std::count_if(points.begin(), points.end(), [&](const auto& p) { return points[i] < p; }));
}

constexpr int step =
    40;  // a unit is 2^40 times an infinitesimal that is next to it: ample for small integers

/// In-sphere with each lift raised by a number, 2^40 times less for every point that is greater.
template <int D>
Sign in_sphere_of_raised(const Case<D>& points) {
  Matrix m = integer_rows<D>(points, true);
  for (std::size_t i = 0; i < m.size(); ++i)
    m[i].back() = (m[i].back() << step * (D + 2)) + (Integer(1) << (step * (D + 1 - greater(points, i))));
  return -leibniz_sign(m);
}

/// The determinant with every entry but the ones perturbed by a number that is 2^10 times less than the
/// product of all greater ones: by the point's rank, then the column.
template <int D>
Sign perturbed_throughout(const auto& points, bool lifted) {
  Matrix m = integer_rows<D>(points, lifted);
  const std::size_t n = m.size(), columns = n - 1, all = n * columns;
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 1; j < n; ++j) {
      const std::size_t k = greater(points, i) * columns + (columns - j);  // 0 for the greatest infinitesimal
      m[i][j] = (m[i][j] << 10 * (std::size_t{1} << all)) +
                (Integer(1) << 10 * ((std::size_t{1} << all) - (std::size_t{1} << k)));
    }
  return leibniz_sign(m);
}

template <int D>
std::vector<Point<D>> lattice(int size) {
  std::vector<Point<D>> points;
  for (int x = 0; x < size; ++x)
    for (int y = 0; y < size; ++y)
      if constexpr (D == 2)
        points.push_back({{double(x), double(y)}});
      else
        for (int z = 0; z < size; ++z) points.push_back({{double(x), double(y), double(z)}});
  return points;
}

template <int D>
Case<D> draw_case(const std::vector<Point<D>>& points, Random& random) {
  Case<D> c{};
  for (auto& p : c) p = points[random.below(points.size())];
  return c;
}

template <int D>
bool distinct(const Case<D>& points) {
  auto sorted = points;
  std::sort(sorted.begin(), sorted.end());
  return std::adjacent_find(sorted.begin(), sorted.end()) == sorted.end();
}

TEST(Symbolic, EveryExactBackendHasOneByName) {
  std::size_t exact = 0;
  for (const BackendEntry& entry : backends()) {
    const std::string name = std::string(entry.about->name) + "+sos";
    const BackendEntry* found = find_backend(name);
    EXPECT_EQ(found != nullptr, entry.about->exact) << name;
    if (found == nullptr) continue;
    ++exact;
    EXPECT_EQ(found->about->name, name);
    EXPECT_EQ(found->about->domain, entry.about->domain);
    EXPECT_EQ(found->bind3 != nullptr, entry.bind3 != nullptr);
  }
  EXPECT_EQ(symbolic_backends().size(), exact);
  EXPECT_EQ(find_backend("gmp+sos+sos"), nullptr);
}

class TieBreaking : public EveryBackend {};

template <int D>
void breaks_ties_as_raised_lifts_would(const BackendEntry& symbolic, const BackendEntry& plain) {
  Random random(D);
  std::vector<Point<D>> points = lattice<D>(D == 2 ? 5 : 3);
  for (const auto& p : integer_sphere<D>(25)) points.push_back(p);
  const auto kernel = bind<D>(symbolic, points), exact = bind<D>(plain, points);
  int ties = 0, broken = 0;
  for (int i = 0; i < 4000; ++i) {
    const Case<D> c = draw_case<D>(points, random);
    ASSERT_EQ(orient(*kernel, c), orient(*exact, c)) << "orientations stay true";
    const Decision decision = decide_in_sphere(*kernel, c), before = decide_in_sphere(*exact, c);
    if (before.sign != Sign::zero) {
      ASSERT_EQ(decision.sign, before.sign);
      ASSERT_EQ(decision.stage, before.stage);
      continue;
    }
    ++ties;
    ASSERT_EQ(decision.stage, Stage::symbolic);
    ASSERT_EQ(decision.sign, distinct<D>(c) ? in_sphere_of_raised<D>(c) : Sign::zero) << hexadecimal<D>(c);
    broken += decision.sign != Sign::zero;
  }
  EXPECT_GT(ties, 500);
  EXPECT_GT(broken, 50);
}

TEST_P(TieBreaking, IsWhatRaisingTheLiftsGives) {
  const std::string name(entry().about->name);
  const BackendEntry& plain = *find_backend(name.substr(0, name.size() - 4));
  breaks_ties_as_raised_lifts_would<2>(entry(), plain);
  if (entry().bind3 != nullptr) breaks_ties_as_raised_lifts_would<3>(entry(), plain);
}

/// All quadruples of a grid: only collinear or repeated points remain tied.
TEST_P(TieBreaking, LeavesNoTieAmongPointsThatSpanThePlane) {
  const auto points = lattice<2>(4);
  const auto kernel = bind<2>(entry(), points);
  for (std::size_t i = 0; i < 16 * 16 * 16 * 16; ++i) {
    const Case<2> c{points[i % 16], points[i / 16 % 16], points[i / 256 % 16], points[i / 4096]};
    const auto& [a, b, p, q] = c;
    const bool flat = orient(*kernel, c) == Sign::zero && kernel->orient2d(a, b, q) == Sign::zero &&
                      kernel->orient2d(a, p, q) == Sign::zero && kernel->orient2d(b, p, q) == Sign::zero;
    ASSERT_EQ(in_sphere(*kernel, c) == Sign::zero, flat || !distinct<2>(c)) << hexadecimal<2>(c);
  }
}

INSTANTIATE_TEST_SUITE_P(, TieBreaking, testing::ValuesIn([] {
                           std::vector<const BackendEntry*> all;
                           for (const BackendEntry& entry : symbolic_backends()) all.push_back(&entry);
                           return all;
                         }()),
                         name_of);

/// Swapping two points changes the sign, and only that.
TEST(Symbolic, TieBreakingAlternates) {
  const auto kernel = bind<3>(*find_backend("filtered+sos"), {{{0, 0, 0}}, {{1, 1, 1}}});
  const auto points = lattice<3>(2);  // all on one sphere
  Random random(8);
  for (int i = 0; i < 5000; ++i) {
    Case<3> c = draw_case<3>(points, random);
    const Sign before = in_sphere(*kernel, c);
    const auto j = random.below(5), k = (j + 1 + random.below(4)) % 5;
    std::swap(c[j], c[k]);
    ASSERT_EQ(in_sphere(*kernel, c), -before);
  }
}

// Full simulation of simplicity.

template <int D>
void simulates_as_perturbed(int cases) {
  Random random(40 + D);
  const auto points = lattice<D>(3);
  int ties = 0;
  for (int i = 0; i < cases; ++i) {
    const Case<D> c = draw_case<D>(points, random);
    if (!distinct<D>(c)) continue;
    std::array<Point<D>, D + 1> simplex{};
    std::copy(c.begin(), c.end() - 1, simplex.begin());
    const Decision orientation = simulate_orient<D>(simplex);
    ties += orientation.stage == Stage::symbolic;
    ASSERT_NE(orientation.sign, Sign::zero);
    ASSERT_EQ(orientation.sign, perturbed_throughout<D>(simplex, false)) << hexadecimal<D>(c);
    ASSERT_EQ(orientation.stage == Stage::exact, true_orient<D>(c) != Sign::zero);
    if constexpr (D == 2) {
      const Decision circle = simulate_in_sphere<2>(c);
      ASSERT_NE(circle.sign, Sign::zero);
      ASSERT_EQ(circle.sign, -perturbed_throughout<2>(c, true)) << hexadecimal<2>(c);
      ASSERT_EQ(circle.stage == Stage::exact, true_in_sphere<2>(c) != Sign::zero);
    }
  }
  EXPECT_GT(ties, cases / 60);
}
TEST(SimulationOfSimplicity, IsWhatAPerturbationOfAllCoordinatesGives) {
  simulates_as_perturbed<2>(300);
  simulates_as_perturbed<3>(60);
}

TEST(SimulationOfSimplicity, RepeatedPointsStayTied) {
  EXPECT_EQ(simulate_orient<2>({{{{1, 2}}, {{0, 0}}, {{1, 2}}}}).sign, Sign::zero);
  EXPECT_EQ(simulate_orient<2>({{{{-0.0, 2}}, {{0, 2}}, {{1, 2}}}}).sign, Sign::zero);
}

TEST(SimulationOfSimplicity, WorksForAnyFiniteDoubles) {
  EXPECT_NE(simulate_orient<2>({{{{0x1p-1074, 0}}, {{0, 0}}, {{0x1p1023, 0}}}}).sign, Sign::zero);
  EXPECT_NE(simulate_in_sphere<3>(
                {{{{0, 0, 0}}, {{0x1p-1074, 0, 0}}, {{1, 0, 0}}, {{2, 0, 0}}, {{0x1p1023, 0, 0}}}})
                .sign,
            Sign::zero);
}

/// With all triples oriented, Knuth's five axioms of CC systems hold, nondegeneracy among them: for all
/// quintuples of a 3 x 3 grid.
TEST(SimulationOfSimplicity, IsACcSystem) {
  const auto points = lattice<2>(3);
  bool ccw[9][9][9] = {};
  for (std::size_t p = 0; p < 9; ++p)
    for (std::size_t q = 0; q < 9; ++q)
      for (std::size_t r = 0; r < 9; ++r)
        ccw[p][q][r] = simulate_orient<2>({points[p], points[q], points[r]}).sign == Sign::positive;
  for (std::size_t p = 0; p < 9; ++p)
    for (std::size_t q = 0; q < 9; ++q)
      for (std::size_t r = 0; r < 9; ++r) {
        if (p == q || q == r || r == p) continue;
        ASSERT_EQ(ccw[p][q][r], ccw[q][r][p]);
        ASSERT_NE(ccw[p][q][r], ccw[p][r][q]) << "antisymmetry and nondegeneracy";
        for (std::size_t t = 0; t < 9; ++t) {
          if (t == p || t == q || t == r) continue;
          if (ccw[t][q][r] && ccw[p][t][r] && ccw[p][q][t]) {
            ASSERT_TRUE(ccw[p][q][r]) << "interiority";
          }
          for (std::size_t s = 0; s < 9; ++s)
            if (ccw[t][s][p] && ccw[t][s][q] && ccw[t][s][r] && ccw[t][p][q] && ccw[t][q][r]) {
              ASSERT_TRUE(ccw[t][p][r]) << "transitivity";
            }
        }
      }
}

}  // namespace
}  // namespace tribunal::laws
