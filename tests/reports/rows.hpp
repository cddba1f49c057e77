// Result rows made up for tests.
#pragma once

#include "bench/row.hpp"
#include "reports/claim.hpp"
#include "reports/trial.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace tribunal::reports {

/// A finished run of an algorithm on n uniform sites.
inline bench::Row run_row(const std::string& task, std::uint64_t n, std::uint64_t seed,
                          std::map<std::string, double> counters) {
  bench::Row row;
  row.cell.task = task;
  row.cell.backend = "filtered";
  row.cell.dataset = "uniform";
  row.cell.n = n;
  row.cell.seed = seed;
  row.cell.order_seed = seed;
  row.key = task + "-" + std::to_string(n) + "-" + std::to_string(seed);
  row.outcome = "ok";
  row.counters = std::move(counters);
  return row;
}

/// A claim with nothing but a rule.
inline Claim claim_of(const std::string& judge, nlohmann::json parameters = nlohmann::json::object()) {
  Claim claim;
  claim.id = "test";
  claim.title = "Test";
  claim.statement = "Stated for a test.";
  claim.source = "nobody";
  claim.rule = {judge, std::move(parameters)};
  return claim;
}

inline Judgement try_rule(const std::string& judge, nlohmann::json parameters,
                          const std::vector<bench::Row>& rows) {
  return try_claim(claim_of(judge, std::move(parameters)), rows);
}

}  // namespace tribunal::reports
