// What a run of the micro benchmark looks like: as JSON and as tables.
#pragma once

#include "bench/micro/goals.hpp"
#include "bench/micro/predicate_bench.hpp"
#include "cli/console.hpp"

#include <nlohmann/json_fwd.hpp>

#include <span>
#include <string>

namespace tribunal::cli {

/// Three significant digits, never an exponent: "1.26", "12.6", "1260".
std::string three_digits(double value);

/// "1.2 to 1.3"; "-" for an interval that is one value, as after a single round, which tells of no spread.
std::string span_text(const bench::Interval& interval);

/// As cli/schemas/bench.schema.json says.
nlohmann::json bench_document(const bench::PredicateBenchOptions& plan,
                              std::span<const bench::MicroCell> cells,
                              std::span<const bench::MeasuredGoal> goals);

/// Per predicate a table of times, subjects by families, and the shares of deciding stages where several
/// decide; then the ratios aimed at.
void print_bench(Console& console, const bench::PredicateBenchOptions& plan,
                 std::span<const bench::MicroCell> cells, std::span<const bench::MeasuredGoal> goals);

}  // namespace tribunal::cli
