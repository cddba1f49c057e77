// A campaign as a file: which cells, under which caps.
#pragma once

#include "bench/row.hpp"
#include "bench/sandbox.hpp"

#include <toml++/toml.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace tribunal::bench {

struct Plan {
  std::string name;
  Limits limits;
  std::vector<Cell> cells;   ///< no two with the same key
  std::string input_digest;  ///< of the plan's bytes; empty where it was no file of its own
};

/// More cells than this are a slip of the pen.
inline constexpr std::uint64_t most_cells = 1'000'000;

/// Reads a campaign file; docs/campaigns.md has the format. Throws BadInput "file:line:column: reason" for
/// anything that is not a campaign: bad TOML, unknown keys or names, wrong types, missing values, absurd
/// sizes.
Plan parse_plan(const std::filesystem::path& path);

/// The same from a table with the keys of a campaign file, which may stand inside another file (`filename`,
/// for errors). Where it has no `name`, it is the file's name without ending.
Plan read_plan(const toml::table& table, const std::string& filename);

/// The cells of such a table: for each [[cells]] in file order the product of its keys' values. From slowest
/// to fastest: n, dataset, bits, order, seed, order_seed, measure, repeats, parameters, task, backend; so
/// what is compared runs side by side.
std::vector<Cell> expand(const toml::table& table, const std::string& filename);

}  // namespace tribunal::bench
