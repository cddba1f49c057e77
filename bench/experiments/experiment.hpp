// Tasks that are no triangulation: what an experiment is, and which there are.
#pragma once

#include "algorithms/outcome.hpp"
#include "bench/row.hpp"

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tribunal::bench {

/// A parameter of an experiment: a whole number, or one of a list of names. Cells carry it as text; where a
/// plan leaves it out, the default is filled in.
struct Parameter {
  std::string_view name;
  std::string_view summary;                              ///< one line
  std::string_view standard;                             ///< the default
  std::uint64_t least = 0, most = 0;                     ///< of a whole number
  std::vector<std::string_view> (*choices)() = nullptr;  ///< null: a whole number
};

/// Which fields of a cell an experiment reads. A plan must give these and may give no others.
struct Reads {
  bool backend = false;
  bool dataset = false;  ///< with n (where the dataset has no fixed size) and bits
  bool n = false;        ///< a number of its own, without a dataset
  bool bits = false;
  bool seed = false;
  bool order = false;  ///< with order_seed
};

/// What an experiment found.
struct Finding {
  Outcome outcome = Outcome::ok;
  std::string reason = {};
  std::map<std::string, double> counters = {};
  std::map<std::string, std::string> texts = {};
  std::vector<double> seconds = {};  ///< samples of thread CPU time: all that a repetition may change
};

struct Experiment {
  std::string_view name;
  std::string_view cites;
  std::string_view summary;  ///< one line
  Reads reads;
  std::span<const Parameter> parameters;
  Finding (*run)(const Cell& cell);  ///< deterministic but for seconds
};

/// All experiments. No name is that of an algorithm.
std::span<const Experiment> experiments();

/// The experiment of that name, or null.
const Experiment* find_experiment(std::string_view name);

/// Why `value` is no value of the parameter; empty when it is one.
std::string refuse(const Parameter& parameter, std::string_view value);

/// The cell's value of a parameter that is a whole number. Throws BadInput when it is none in range.
std::uint64_t whole_number(const Cell& cell, const Parameter& parameter);

/// The cell's value of a parameter with choices. Throws BadInput when it is none of them.
std::string choice(const Cell& cell, const Parameter& parameter);

}  // namespace tribunal::bench
