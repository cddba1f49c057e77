#include "cli/lookup.hpp"

#include "algorithms/list.hpp"
#include "cli/console.hpp"
#include "predicates/backends/list.hpp"

#include <algorithm>

namespace tribunal::cli {
namespace {

template <class Range, class Name>
[[noreturn]] void refuse(const char* kind, const std::string& name, const Range& all, Name name_of) {
  std::string message = std::string("there is no ") + kind + " '" + name + "'; there are";
  const char* separator = " ";
  for (const auto& entry : all) {
    message.append(separator).append(name_of(entry));
    separator = ", ";
  }
  throw BadUsage(message);
}

}  // namespace

const PlanarAlgorithm& algorithm_named(const std::string& name) {
  if (const auto* found = find_planar_algorithm(name)) return *found;
  refuse("algorithm", name, planar_algorithms(), [](const auto& a) { return a.about.name; });
}

const BackendEntry& backend_named(const std::string& name) {
  if (const auto* found = find_backend(name)) return *found;
  refuse("backend", name, backends(), [](const auto& b) { return b.about->name; });
}

const Dataset& dataset_named(const std::string& name) {
  if (const auto* found = find_dataset(name)) return *found;
  refuse("dataset", name, datasets(), [](const auto& d) { return d.about.name; });
}

Order order_named(const std::string& name) {
  Order order{};
  if (parse_order(name, order)) return order;
  refuse("order", name, order_names(), [](std::string_view o) { return o; });
}

Predicate predicate_named(const std::string& name) {
  for (const Predicate predicate : all_predicates)
    if (to_string(predicate) == name) return predicate;
  refuse("predicate", name, predicate_names, [](std::string_view p) { return p; });
}

const QueryFamily& query_family_named(const std::string& name) {
  if (const auto* found = find_query_family(name)) return *found;
  refuse("family of queries", name, query_families(), [](const auto& f) { return f.name; });
}

const MeshOptimizer& optimizer_named(const std::string& name) {
  if (const auto* found = find_mesh_optimizer(name)) return *found;
  refuse("criterion", name, mesh_optimizers(), [](const auto& o) { return o.name; });
}

const refinement::Refiner& refiner_named(const std::string& name) {
  if (const auto* found = refinement::find_refiner(name)) return *found;
  refuse("algorithm", name, refinement::refiners(), [](const auto& r) { return r.name; });
}

Settings settings_for(std::string_view owner, std::span<const Parameter> parameters,
                      const std::vector<std::string>& texts) {
  Settings settings;
  for (const std::string& text : texts) {
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos) throw BadUsage("--set wants NAME=VALUE, not '" + text + "'");
    const std::string name = text.substr(0, equals);
    if (!settings.emplace(name, text.substr(equals + 1)).second)
      throw BadUsage("--set gives " + name + " twice");
  }
  const std::string reason = refuse_settings(owner, parameters, settings);
  if (!reason.empty()) throw BadUsage(reason);
  return settings;
}

std::vector<std::string> each_once(std::span<const std::string> names) {
  std::vector<std::string> once;
  for (const std::string& name : names)
    if (std::ranges::find(once, name) == once.end()) once.push_back(name);
  return once;
}

namespace {
std::uint64_t usual_size(const Dataset& dataset) {
  return dataset.about.fixed_size ? dataset.about.fixed_size : 1000;
}
}  // namespace

std::vector<Point2> generate(const Dataset& dataset, std::uint64_t n, std::uint64_t seed) {
  return dataset.generate(n ? n : usual_size(dataset), seed);
}

DatasetGraph generate_graph(const Dataset& dataset, std::uint64_t n, std::uint64_t seed) {
  return dataset.graph(n ? n : usual_size(dataset), seed);
}

}  // namespace tribunal::cli
