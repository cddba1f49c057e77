// One cell, run in this process.
#pragma once

#include "bench/row.hpp"

namespace tribunal::bench {

/// A dataset larger than this is refused before it is generated.
inline constexpr std::uint64_t most_points = 100'000'000;

/// Runs the cell: an algorithm over a dataset and a backend, or an experiment. Failures are outcomes of the
/// row; what the process itself may die of (crash, hang, memory) needs a sandbox around this. Throws BadInput
/// when the cell names something that there is not, or asks for something impossible (parse_plan lets no such
/// cell through).
///
/// `counts`: counters by name (every field of Counters, `history.*`, predicate calls by stage, `points`,
/// `triangles`, `hull`, `dimension`, `duplicates`, `ties`) and no time. `time`: the same counters without the
/// predicates', from one untimed and verified run; then `repeats` timed ones, which must give the same mesh.
/// A wrong result has no time. Generation, binding, verification and I/O are in no sample.
Row run_cell(const Cell& cell);

/// A row with key, cell and command filled in and nothing known yet.
Row blank_row(const Cell& cell);

/// The command line that repeats a cell: `tribunal cell '<the cell as JSON>'`, quoted for a POSIX shell.
std::string repeat_command(const Cell& cell);

}  // namespace tribunal::bench
