// Parameters of data-dependent triangulation.
#pragma once

#include "algorithms/data_dependent/franke.hpp"
#include "algorithms/flips/parameters.hpp"

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

namespace tribunal {

inline constexpr std::string_view third_column = "column";

constexpr Parameter data_parameter{
    .name = "data",
    .summary = "the points' third column, or a function of Franke's on the unit square",
    .standard = third_column,
    .choices = [] {
      std::vector<std::string_view> names{third_column};
      for (const auto& function : franke_functions()) names.push_back(function.name);
      return names;
    }};
constexpr Parameter cost_parameter{.name = "cost",
                                   .summary = "jump in normal derivatives, or angle between normals",
                                   .standard = "jnd",
                                   .choices = [] {
                                     return std::vector<std::string_view>{"jnd", "abn"};
                                   }};
constexpr Parameter norm_parameter{
    .name = "norm", .summary = "sum of costs, or of their squares", .standard = "l1", .choices = [] {
      return std::vector<std::string_view>{"l1", "l2"};
    }};

enum class Search : std::uint8_t { sweeps, shuffled, stack, best, look_ahead, annealing };
constexpr Parameter search_parameter{
    .name = "search", .summary = "which flips are tried in which order", .standard = "sweeps", .choices = [] {
      return std::vector<std::string_view>{"sweeps", "shuffled", "stack", "best", "look-ahead", "annealing"};
    }};

inline constexpr std::array data_dependent_parameters{data_parameter, cost_parameter, norm_parameter,
                                                      search_parameter, flip_seed_parameter};

}  // namespace tribunal
