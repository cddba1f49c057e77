// Parameters whose values are names of lists kept elsewhere, for the experiments that share them.
#pragma once

#include "algorithms/list.hpp"
#include "bench/experiments/experiment.hpp"
#include "predicates/predicate.hpp"

#include <string_view>
#include <vector>

namespace tribunal::bench {

constexpr Parameter predicate_parameter{
    .name = "predicate", .summary = "the predicate on trial", .standard = "orient2d", .choices = [] {
      return std::vector<std::string_view>(predicate_names.begin(), predicate_names.end());
    }};

/// The cell's value of predicate_parameter.
inline Predicate chosen_predicate(const Cell& cell) {
  return choice_as<Predicate>(cell.parameters, predicate_parameter);
}

constexpr Parameter algorithm_parameter{
    .name = "algorithm", .summary = "the algorithm on trial", .standard = "green-sibson", .choices = [] {
      std::vector<std::string_view> names;
      for (const PlanarAlgorithm& algorithm : planar_algorithms()) names.push_back(algorithm.about.name);
      return names;
    }};

/// The cell's value of algorithm_parameter.
inline const PlanarAlgorithm& chosen_algorithm(const Cell& cell) {
  return *find_planar_algorithm(choice(cell.parameters, algorithm_parameter));
}

}  // namespace tribunal::bench
