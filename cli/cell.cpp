// tribunal cell: one cell, run in this process; a row's command repeats it so.
#include "bench/cell.hpp"

#include "cli/verbs.hpp"

#include <nlohmann/json.hpp>

namespace tribunal::cli {

int cell(const CellOptions& options, Console& console) {
  bench::Cell cell;
  try {
    cell = nlohmann::json::parse(options.cell).get<bench::Cell>();
  } catch (const nlohmann::json::exception& error) {
    throw BadUsage(std::string("the cell is not what a cell is: ") + error.what());
  }
  const bench::Row row = bench::run_cell(cell);
  print_json(console, row);
  return row.outcome == "ok"                                                ? good
         : row.outcome == "out_of_domain" || row.outcome == "refused_input" ? bad_input
                                                                            : judged_bad;
}

}  // namespace tribunal::cli
