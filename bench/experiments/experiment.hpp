// Tasks that are no triangulation: what an experiment is, and which there are.
#pragma once

#include "algorithms/outcome.hpp"
#include "algorithms/parameter.hpp"
#include "bench/row.hpp"

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tribunal::bench {

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
  Finding (*run)(const Cell& cell);  ///< of accepted parameters; deterministic but for seconds
};

/// All experiments. No name is that of an algorithm.
std::span<const Experiment> experiments();

/// The experiment of that name, or null.
const Experiment* find_experiment(std::string_view name);

}  // namespace tribunal::bench
