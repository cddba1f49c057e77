// The currency of the bench and the reports: a cell is what is asked, a row is what came of it.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace tribunal::bench {

inline constexpr int row_schema = 1;

/// What a cell does: it counts predicate calls (through a Counted kernel) or takes time (through the bare
/// one).
enum class Measure : std::uint8_t { counts, time };

/// One (task, backend, input), complete: two cells with equal fields have equal results, times aside.
struct Cell {
  std::string task;     ///< name of an algorithm or of an experiment
  std::string backend;  ///< name of a backend
  std::string dataset;  ///< name of a dataset; empty for an experiment without one
  std::uint64_t n = 0;
  int bits = 0;                  ///< quantised to integers in [0, 2^bits); 0: raw doubles
  std::uint64_t seed = 1;        ///< of the dataset
  std::uint64_t order_seed = 1;  ///< of the insertion order
  std::string order = "random";  ///< random, input, hilbert, x or brio
  Measure measure = Measure::counts;
  int repeats = 1;                                ///< timed samples
  std::map<std::string, std::string> parameters;  ///< of an experiment, or of an algorithm where not standard
};

/// What came of a cell.
struct Row {
  int schema = row_schema;
  std::string key;  ///< cell_key(cell)
  Cell cell;
  std::string outcome;  ///< algorithms/outcome.hpp
  std::string reason;   ///< one line where the outcome is not ok
  std::map<std::string, double>
      counters;  ///< by name, e.g. "tau", "incircle", "incircle.exact", "history.nodes"
  std::map<std::string, std::string>
      texts;                     ///< results of an experiment that are no numbers, e.g. a sign map
  std::vector<double> seconds;   ///< samples of thread CPU time, triangulation alone
  std::uint64_t peak_bytes = 0;  ///< peak resident size minus that before
  std::string digest;            ///< of the canonical mesh; empty where there is none
  std::string command;           ///< repeats this cell
};

/// Hash of everything that determines the result: every field, in a canonical spelling. 16 hexadecimal
/// digits.
std::string cell_key(const Cell& cell);

/// Reading throws nlohmann::json::exception for what is no cell or row. A cell's fields but `task` may be
/// missing.
void to_json(nlohmann::json& json, const Cell& cell);
void from_json(const nlohmann::json& json, Cell& cell);
void to_json(nlohmann::json& json, const Row& row);
void from_json(const nlohmann::json& json, Row& row);

}  // namespace tribunal::bench
