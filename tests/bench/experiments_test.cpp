// Experiments against values known from elsewhere: identities, other counts of the same thing, published
// figures.
#include "algorithms/list.hpp"
#include "algorithms/triangulate.hpp"
#include "bench/cell.hpp"
#include "bench/experiments/tau_bound.hpp"
#include "bench/input.hpp"
#include "tests/bench/support.hpp"

#include <algorithm>
#include <numeric>

namespace tribunal::bench {
namespace {

TEST(Scopes, SatisfyTheirIdentitiesInGeneralPosition) {
  for (const int n : {3, 4, 6, 12, 25}) {
    const Row row = run_one("experiment='scopes'\nbackend='gmp'\ndataset='uniform'\nn=" + std::to_string(n));
    ASSERT_EQ(row.outcome, "ok") << row.reason;
    ASSERT_EQ(row.counters.at("collinear") + row.counters.at("cocircular"), 0);
    const double hull = row.counters.at("hull");
    EXPECT_EQ(row.counters.at("T.0"), 2 * n - 2 - hull);
    EXPECT_EQ(row.counters.at("T." + std::to_string(n - 3)), hull - 2);
    EXPECT_EQ(row.counters.at("residual_reflection"), 0);
    EXPECT_EQ(row.counters.at("residual_sets"), 0);
    EXPECT_EQ(row.counters.at("residual_ends"), 0);
    EXPECT_EQ(row.counters.at("violations_upper"), 0);
    EXPECT_LE(row.counters.at("tau_expected"), row.counters.at("tau_bound") * (1 + 1e-15));
  }
}

TEST(Scopes, ExpectTheMeanTauOfAllOrders) {
  Cell cell = plan_of("[[cells]]\nexperiment='scopes'\nbackend='gmp'\ndataset='uniform'\nn=6\n").cells[0];
  const std::vector<Point2> points = cell_points(cell);
  const Kernel2Binding kernel = cell_kernel(points, cell);
  std::vector<Index> order(points.size());
  std::iota(order.begin(), order.end(), Index{0});
  double sum = 0, orders = 0;
  do {
    const Triangulation t =
        triangulate(points, order, *std::get<0>(kernel), *find_planar_algorithm("bowyer"));
    sum += static_cast<double>(t.counters.tau);
    ++orders;
  } while (std::next_permutation(order.begin(), order.end()));
  EXPECT_EQ(orders, 720);
  EXPECT_NEAR(run_cell(cell).counters.at("tau_expected"), sum / orders, 1e-12);
}

TEST(Scopes, DegenerateSetsAreSaidToBe) {
  const Row row = run_one("experiment='scopes'\nbackend='gmp'\ndataset='grid'\nn=16\n");
  EXPECT_GT(row.counters.at("collinear"), 0);
  EXPECT_GT(row.counters.at("cocircular"), 0);
}

TEST(Scopes, TooManySitesAreRefused) {
  EXPECT_EQ(run_one("experiment='scopes'\nbackend='gmp'\ndataset='uniform'\nn=61\n").outcome,
            "refused_input");
}

// Barth, eq. (3.3.0), computed independently with rational harmonic numbers.
TEST(TauBound, HasItsKnownValues) {
  EXPECT_NEAR(tau_bound(3), 1, 1e-12);
  EXPECT_NEAR(tau_bound(4), 3.25, 1e-12);
  EXPECT_NEAR(tau_bound(10), 26.565, 5e-4);
  EXPECT_NEAR(tau_bound(1000), 5898.218, 5e-4);
  EXPECT_NEAR(tau_bound(100000), 599829.148, 5e-4);
}

TEST(TauOverOrders, AgreesWithCellsOfTheirOwn) {
  const std::string input = "backend='gmp'\ndataset='uniform'\nn=80\nseed=5\n";
  const Row row = run_one(
      "experiment='tau-over-orders'\norder_seed=7\nparameters={orders=4,algorithm='watson'}\n" + input);
  std::vector<double> tau;
  for (const Cell& cell : plan_of("[[cells]]\nalgorithm='watson'\norder_seed='7..10'\n" + input).cells)
    tau.push_back(run_cell(cell).counters.at("tau"));
  ASSERT_EQ(tau.size(), 4u);
  EXPECT_DOUBLE_EQ(row.counters.at("tau_mean"), std::accumulate(tau.begin(), tau.end(), 0.0) / 4);
  EXPECT_EQ(row.counters.at("tau_max"), *std::max_element(tau.begin(), tau.end()));
  EXPECT_EQ(row.counters.at("tau_min"), *std::min_element(tau.begin(), tau.end()));
}

struct KnownMap {
  const char* figure;
  double false_zero, inverted;
};

// Counted anew over the doubles of Kettner et al.'s figures with the pivot p, without contraction to FMAs.
TEST(SignMap, OfDoubleHasItsKnownErrors) {
  for (const auto& [figure, false_zero, inverted] :
       {KnownMap{"2a", 11300, 672}, KnownMap{"2b", 19138, 638}, KnownMap{"2c", 9418, 920}}) {
    const Row row = run_one("experiment='sign-map'\nbackend='double'\nparameters={figure='" +
                            std::string(figure) + "'}\n");
    EXPECT_EQ(row.counters.at("false_zero"), false_zero) << figure;
    EXPECT_EQ(row.counters.at("inverted"), inverted) << figure;
    EXPECT_EQ(row.counters.at("false_nonzero"), 0) << figure;
    EXPECT_NE(row.texts.at("signs"), row.texts.at("exact"));
  }
}

TEST(SignMap, OfAnExactBackendHasNone) {
  const Row row = run_one("experiment='sign-map'\nbackend='filtered'\n");
  EXPECT_EQ(row.counters.at("wrong"), 0);
  EXPECT_EQ(row.texts.at("signs"), row.texts.at("exact"));
}

TEST(SignMap, RunLengthsCoverThePixels) {
  const Row row = run_one("experiment='sign-map'\nbackend='double'\n");
  std::size_t pixels = 0;
  const std::string& text = row.texts.at("signs");
  for (std::size_t i = 0; i < text.size(); i = text.find(']', i) + 1) {
    ASSERT_NE(std::string("+-0").find(text[i]), std::string::npos);
    ASSERT_EQ(text[i + 1], '[');
    pixels += std::stoul(text.substr(i + 2));
  }
  EXPECT_EQ(pixels, 256u * 256);
}

TEST(SignDifferential, FindsDoubleWrongAndExactBackendsRight) {
  for (const char* predicate : {"orient2d", "incircle"})
    for (const char* generator : {"uniform", "near-cancelling", "grid"}) {
      const std::string rest = "'\nn=400\nbits=40\nparameters={predicate='" + std::string(predicate) +
                               "',generator='" + generator + "'}\n";
      const Row filtered = run_one("experiment='sign-differential'\nbackend='filtered" + rest);
      EXPECT_EQ(filtered.counters.at("wrong"), 0) << predicate << ' ' << generator;
      const Row rounded = run_one("experiment='sign-differential'\nbackend='double" + rest);
      const bool degenerate = std::string(generator) != "uniform";
      // On a grid both products of a vanishing orient2d are the same number, which rounds alike.
      const bool hard =
          degenerate && !(std::string(generator) == "grid" && predicate == std::string("orient2d"));
      EXPECT_EQ(rounded.counters.at("wrong") > 0, hard) << predicate << ' ' << generator;
      EXPECT_EQ(rounded.counters.at("zeros") > 0, degenerate) << predicate << ' ' << generator;
    }
}

TEST(SignDifferential, KeepsItsCoordinatesInTheLattice) {
  for (const char* predicate : {"orient2d", "incircle"})
    for (const char* generator : {"uniform", "near-cancelling", "grid"}) {
      const Row row = run_one(
          "experiment='sign-differential'\nbackend='knuth'\nn=2000\nbits=14\nparameters={predicate='" +
          std::string(predicate) + "',generator='" + generator + "'}\n");
      EXPECT_EQ(row.outcome, "ok") << predicate << ' ' << generator << ": " << row.reason;
      EXPECT_EQ(row.counters.at("wrong"), 0) << predicate << ' ' << generator;
    }
}

TEST(KnuthPrinted, IsRefutedByItsWitnesses) {
  const Row row = run_one("experiment='knuth-printed'\nn=20000\n");
  const auto at = [&](const char* name) { return row.counters.at(name); };
  EXPECT_EQ(at("witness.1.exact"), 0);
  EXPECT_EQ(at("witness.1.printed"), -1);
  EXPECT_EQ(at("witness.2.exact"), 1);
  EXPECT_EQ(at("witness.2.corrected"), 1);
  EXPECT_GT(at("wrong.printed"), 0);
  EXPECT_GT(at("wrong.third_product"), 0);
  EXPECT_EQ(at("wrong.late_exits"), 0);
  EXPECT_EQ(at("wrong.corrected"), 0);
  EXPECT_EQ(at("wrong.redundant"), 0);
}

TEST(KnuthPrinted, CarryIsWrongMoreOftenNearZero) {
  const std::string rest = "experiment='knuth-printed'\nn=20000\nparameters={generator='";
  const Row uniform = run_one(rest + "uniform'}\n"), near = run_one(rest + "near-cancelling'}\n");
  EXPECT_GT(near.counters.at("wrong.carry"), 10 * uniform.counters.at("wrong.carry"));
  EXPECT_EQ(near.counters.at("wrong.corrected"), 0);
}

TEST(PredicateTiming, TimesWhatIsRight) {
  const std::string rest = "'\nn=300\nparameters={predicate='insphere',family='degF'}\n";
  const Row right = run_one("experiment='predicate-timing'\nbackend='gmp" + rest);
  EXPECT_EQ(right.outcome, "ok");
  EXPECT_EQ(right.counters,
            (std::map<std::string, double>{{"queries", 300}, {"wrong", 0}, {"stage.exact", 300}}));
  EXPECT_FALSE(right.seconds.empty());
  const Row wrong = run_one("experiment='predicate-timing'\nbackend='double" + rest);
  EXPECT_EQ(wrong.outcome, "ok");
  EXPECT_GT(wrong.counters.at("wrong"), 0);
  EXPECT_TRUE(wrong.seconds.empty());
  const Row refused = run_one("experiment='predicate-timing'\nbackend='knuth" + rest);
  EXPECT_EQ(refused.outcome, "out_of_domain");
  EXPECT_FALSE(refused.reason.empty());
}

}  // namespace
}  // namespace tribunal::bench
