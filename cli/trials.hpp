// Where campaigns and claims meet: a claim's cells, and its verdict from the rows of a run.
#pragma once

#include "bench/row.hpp"
#include "reports/trial.hpp"

#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tribunal::cli {

/// The cells of a claim's tier.
std::vector<bench::Cell> cells_of(const reports::Claim& claim, std::string_view tier);

using RowsByKey = std::map<std::string, const bench::Row*, std::less<>>;
RowsByKey by_key(std::span<const bench::Row> rows);

/// Judges the claim by those rows that are its tier's; untried when some of its cells have no row.
reports::Tried try_on(const reports::Claim& claim, std::string_view tier, const RowsByKey& rows);

/// The command that repeats a claim's trial.
std::string claim_command(const reports::Claim& claim, std::string_view tier);

}  // namespace tribunal::cli
