// Writes the page of made-up rows to standard output: one of everything that it can show.
#include "reports/page/page.hpp"
#include "tests/reports/rows.hpp"

#include <cmath>
#include <iostream>

namespace tribunal::reports {
namespace {

std::vector<bench::Row> made_up_rows() {
  std::vector<bench::Row> rows;
  for (std::uint64_t n = 100; n <= 25600; n *= 2)
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
      const auto size = static_cast<double>(n);
      const double jitter = std::sqrt(size) * (static_cast<double>(seed) - 10.5) / 10;
      rows.push_back(run_row("green-sibson", n, seed,
                             {{"tau", 5.8 * size - 100 + jitter},
                              {"triangles", 2 * size},
                              {"dimension", 2},
                              {"tests", 4 * size * std::log(size) + 9 * size + jitter}}));
    }
  for (const char* outcome : {"loop", "non_delaunay", "out_of_domain"}) {
    rows.push_back(run_row("green-sibson", 100, 77, {}));
    rows.back().cell.backend = "double";
    rows.back().outcome = outcome;
    rows.back().command = "tribunal cell";
  }
  rows.push_back(
      run_row("sign-map", 0, 1, {{"wrong", 2}, {"false_zero", 2}, {"inverted", 0}, {"false_nonzero", 0}}));
  rows.back().texts = {{"signs", "+[6]0[4]-[6]"}, {"exact", "+[8]-[8]"}};
  for (const char* backend : {"double", "filtered"}) {
    rows.push_back(run_row("predicate-timing", 1000, 1,
                           {{"queries", 1000}, {"wrong", backend == std::string("double") ? 170.0 : 0.0}}));
    rows.back().cell.backend = backend;
    rows.back().cell.parameters = {{"predicate", "orient2d"}, {"family", "near"}};
    if (backend == std::string("filtered")) rows.back().seconds = {1.8e-5, 1.9e-5, 2.0e-5};
  }
  return rows;
}

}  // namespace
}  // namespace tribunal::reports

int main() {
  using namespace tribunal;
  const std::vector<bench::Row> rows = reports::made_up_rows();
  const std::span<const bench::Row> runs(rows.data(), 9 * 20);
  std::vector<reports::Tried> trials;
  for (const reports::Claim& claim :
       {reports::claim_of("mean-below-bound", {{"bound", "tau"}}),
        reports::claim_of("growth-model",
                          {{"law", "N log N"}, {"counters", nlohmann::json::array({"tests"})}}),
        reports::claim_of("scope-identities")})
    trials.push_back({claim, reports::try_claim(claim, runs), "tribunal claims test"});
  trials[0].claim.id = "bound";
  trials[1].claim.id = "growth";
  std::cout << reports::page({nlohmann::json{{"schema", 1}}, rows, trials});
}
