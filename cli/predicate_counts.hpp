// What a run asked of its kernel, as JSON.
#pragma once

#include "predicates/counted.hpp"

#include <nlohmann/json.hpp>

namespace tribunal::cli {

/// {"incircle": {"calls": 9, "stages": {"filter": 8, "integer": 1}}, ...}: what was called, by deciding
/// stage.
inline nlohmann::json predicates_json(const PredicateCounts& counts) {
  nlohmann::json predicates = nlohmann::json::object();
  for (std::size_t row = 0; row < PredicateCounts::names.size(); ++row) {
    if (counts.total_of_row(row) == 0) continue;
    nlohmann::json stages = nlohmann::json::object();
    for (std::size_t s = 0; s < stage_names.size(); ++s)
      if (const auto calls = counts.calls[row][s]) stages[std::string(stage_names[s])] = calls;
    predicates[std::string(PredicateCounts::names[row])] = {{"calls", counts.total_of_row(row)},
                                                            {"stages", stages}};
  }
  return predicates;
}

}  // namespace tribunal::cli
