#include "cli/trials.hpp"

#include "bench/plan.hpp"

namespace tribunal::cli {

std::vector<bench::Cell> cells_of(const reports::Claim& claim, std::string_view tier) {
  return bench::expand(claim.tier(tier), claim.file);
}

RowsByKey by_key(std::span<const bench::Row> rows) {
  RowsByKey index;
  for (const bench::Row& row : rows) index.emplace(row.key, &row);
  return index;
}

reports::Tried try_on(const reports::Claim& claim, std::string_view tier, const RowsByKey& rows) {
  std::vector<bench::Row> own;
  for (const bench::Cell& cell : cells_of(claim, tier)) {
    const auto found = rows.find(bench::cell_key(cell));
    if (found == rows.end()) {
      own.clear();
      break;
    }
    own.push_back(*found->second);
  }
  return {claim, reports::try_claim(claim, own), claim_command(claim, tier)};
}

std::string claim_command(const reports::Claim& claim, std::string_view tier) {
  return "tribunal claims " + claim.id + " --tier " + std::string(tier);
}

}  // namespace tribunal::cli
