// From a name the user typed to the thing it names, or one line that says what there is.
#pragma once

#include "algorithms/algorithm.hpp"
#include "datasets/dataset.hpp"
#include "predicates/backends/backend.hpp"

#include <string>

namespace tribunal::cli {

/// Each throws BadUsage with the nearest names when there is no such thing.
const PlanarAlgorithm& algorithm_named(const std::string& name);
const BackendEntry& backend_named(const std::string& name);
const Dataset& dataset_named(const std::string& name);
Order order_named(const std::string& name);

}  // namespace tribunal::cli
