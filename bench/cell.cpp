#include "bench/cell.hpp"

#include "algorithms/list.hpp"
#include "algorithms/mesh/canonical.hpp"
#include "algorithms/triangulate.hpp"
#include "bench/experiments/experiment.hpp"
#include "bench/input.hpp"
#include "bench/judge.hpp"
#include "bench/measure.hpp"
#include "datasets/files/files.hpp"
#include "predicates/counted.hpp"

#include <nlohmann/json.hpp>

#include <utility>

namespace tribunal::bench {
namespace {

void check_sizes(const Cell& cell) {
  if (cell.n > most_points) throw BadInput("n is at most " + std::to_string(most_points));
  if (cell.bits < 0 || cell.bits > 53) throw BadInput("bits is a whole number from 0 to 53");
  if (cell.repeats < 1) throw BadInput("repeats is at least 1");
}

void check_parameters(const Cell& cell, std::span<const Parameter> parameters) {
  if (const std::string reason = refuse_settings(cell.task, parameters, cell.parameters); !reason.empty())
    throw BadInput(reason);
}

void set_outcome(Row& row, Outcome outcome, std::string reason) {
  row.outcome = to_string(outcome);
  row.reason = std::move(reason);
}

void count_structure(const Triangulation& t, std::map<std::string, double>& counters) {
  for (const auto& [name, value] : by_name(t.counters)) counters[name] = static_cast<double>(value);
  counters["triangles"] = static_cast<double>(t.triangles.size());
  counters["hull"] = static_cast<double>(t.hull);
  counters["duplicates"] = static_cast<double>(t.duplicates.size());
  counters["dimension"] = t.dimension;
  if (!t.history) return;
  counters["history.nodes"] = static_cast<double>(t.history->nodes);
  counters["history.depth_mean"] = t.history->depth_mean;
  counters["history.depth_late_mean"] = t.history->depth_late_mean;
  counters["history.depth_max"] = static_cast<double>(t.history->depth_max);
}

void run_experiment(const Experiment& experiment, const Cell& cell, Row& row) {
  check_parameters(cell, experiment.parameters);
  Finding finding = experiment.run(cell);
  set_outcome(row, finding.outcome, std::move(finding.reason));
  row.counters = std::move(finding.counters);
  row.texts = std::move(finding.texts);
  row.seconds = std::move(finding.seconds);
}

/// One algorithm on one input, as often as the cell asks.
class AlgorithmCell {
 public:
  AlgorithmCell(const PlanarAlgorithm& algorithm, const Cell& cell)
      : algorithm_(algorithm),
        cell_(cell),
        points_(cell_points(cell)),
        order_(cell_order(points_, cell, cell.order_seed)) {
    check_parameters(cell, algorithm.parameters);
  }

  void run(Row& row) const {
    row.counters["points"] = static_cast<double>(points_.size());
    const Kernel2Binding binding = cell_kernel(points_, cell_);
    if (const auto* refusal = std::get_if<Refusal>(&binding)) {
      set_outcome(row, Outcome::out_of_domain, describe(*refusal));
      return;
    }
    const Kernel2& kernel = *std::get<0>(binding);
    const Triangulation first = run_verified(kernel, row);
    if (cell_.measure == Measure::time && row.outcome == to_string(Outcome::ok))
      take_times(kernel, first, row);
  }

 private:
  Triangulation run_verified(const Kernel2& kernel, Row& row) const {
    PredicateCounts calls;
    const CountedKernel2 counted(kernel, calls);
    const bool counts = cell_.measure == Measure::counts;
    const PeakMemory memory;
    Triangulation result =
        triangulate(points_, order_, counts ? counted : kernel, algorithm_, cell_.parameters);
    row.peak_bytes = memory.growth();
    for (const auto& [name, value] : calls.named()) row.counters[name] = static_cast<double>(value);
    set_outcome(row, result.outcome, result.reason);
    if (result.outcome != Outcome::ok) return result;
    count_structure(result, row.counters);
    const Judgement judgement = judge(points_, result, algorithm_.about.promise);
    set_outcome(row, judgement.outcome, judgement.reason);
    row.counters["ties"] = static_cast<double>(judgement.ties);
    row.digest = to_hex(digest(result.triangles));
    return result;
  }

  void take_times(const Kernel2& kernel, const Triangulation& first, Row& row) const {
    for (int repeat = 0; repeat < cell_.repeats; ++repeat) {
      const double start = thread_seconds();
      const Triangulation again = triangulate(points_, order_, kernel, algorithm_, cell_.parameters);
      row.seconds.push_back(thread_seconds() - start);
      if (again.triangles == first.triangles) continue;
      set_outcome(row, Outcome::inconsistent_predicate, "a repetition gave another mesh");
      row.seconds.clear();
      return;
    }
  }

  const PlanarAlgorithm& algorithm_;
  const Cell& cell_;
  std::vector<Point2> points_;
  std::vector<Index> order_;
};

}  // namespace

std::string repeat_command(const Cell& cell) {
  std::string command = "tribunal cell '";
  for (const char c : nlohmann::json(cell).dump()) {
    if (c == '\'')
      command += "'\\''";
    else
      command += c;
  }
  return command + "'";
}

Row blank_row(const Cell& cell) {
  Row row;
  row.key = cell_key(cell);
  row.cell = cell;
  row.command = repeat_command(cell);
  return row;
}

Row run_cell(const Cell& cell) {
  check_sizes(cell);
  Row row = blank_row(cell);
  if (const Experiment* experiment = find_experiment(cell.task))
    run_experiment(*experiment, cell, row);
  else if (const PlanarAlgorithm* algorithm = find_planar_algorithm(cell.task))
    AlgorithmCell(*algorithm, cell).run(row);
  else
    throw BadInput("no algorithm or experiment is named \"" + cell.task + "\"");
  return row;
}

}  // namespace tribunal::bench
