// From a name the user typed to the thing it names, or one line that says what there is.
#pragma once

#include "algorithms/algorithm.hpp"
#include "algorithms/optimizers.hpp"
#include "algorithms/refiners.hpp"
#include "datasets/dataset.hpp"
#include "datasets/queries/queries.hpp"
#include "predicates/backend.hpp"
#include "predicates/predicate.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tribunal::cli {

/// Each throws BadUsage with the nearest names when there is no such thing.
const PlanarAlgorithm& algorithm_named(const std::string& name);
const BackendEntry& backend_named(const std::string& name);
const Dataset& dataset_named(const std::string& name);
Order order_named(const std::string& name);
Predicate predicate_named(const std::string& name);
const QueryFamily& query_family_named(const std::string& name);
const MeshOptimizer& optimizer_named(const std::string& name);
const refinement::Refiner& refiner_named(const std::string& name);

/// "name=value" texts as settings that `owner` takes, which has these parameters. Throws BadUsage for what is
/// none, and for a name that comes twice.
Settings settings_for(std::string_view owner, std::span<const Parameter> parameters,
                      const std::vector<std::string>& texts);

/// The names in their order, those said twice once.
std::vector<std::string> each_once(std::span<const std::string> names);

/// n points of the dataset; n = 0: all of one of fixed size, 1000 of any other.
std::vector<Point2> generate(const Dataset& dataset, std::uint64_t n, std::uint64_t seed);

/// The same with segments, of a dataset that has any.
DatasetGraph generate_graph(const Dataset& dataset, std::uint64_t n, std::uint64_t seed);

}  // namespace tribunal::cli
