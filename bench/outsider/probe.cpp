#include "bench/outsider/probe.hpp"

#include "algorithms/plugin/loader.hpp"
#include "algorithms/plugin/mesher_loader.hpp"
#include "bench/outsider/printable.hpp"
#include "predicates/plugin/loader.hpp"

#include <nlohmann/json.hpp>

#include <string_view>

namespace tribunal::bench {
namespace {
using nlohmann::json;

constexpr std::string_view exception_mark = "exception: ";

json about(const auto& offer) {
  return {printable(offer.name()), printable(offer.cites()), printable(offer.summary())};
}

std::optional<OfferAbout> read_about(const json& value) {
  if (value.is_null()) return std::nullopt;
  return OfferAbout{value.at(0), value.at(1), value.at(2)};
}

/// In the child.
std::string look(const std::string& path) {
  const SharedLibrary library(path);
  json seen{{"predicates", nullptr}, {"triangulator", nullptr}, {"mesher", nullptr},
            {"graphs", false},       {"refines", false},        {"offered", json::array()}};
  if (const auto predicates = PredicatePlugin::load(library)) {
    seen["predicates"] = about(*predicates);
    for (const Predicate predicate : all_predicates)
      if (predicates->offers(predicate)) seen["offered"].push_back(static_cast<int>(predicate));
  }
  if (const auto triangulator = TriangulatorPlugin::load(library))
    seen["triangulator"] = about(*triangulator);
  if (const auto mesher = MesherPlugin::load(library)) {
    seen["mesher"] = about(*mesher);
    seen["graphs"] = mesher->triangulates();
    seen["refines"] = mesher->refines();
  }
  return seen.dump();
}

}  // namespace

PluginAbout probe_plugin(const std::string& path, const Limits& limits) {
  const Ending ending = run_sandboxed([&] { return look(path); }, limits);
  if (ending.outcome != Outcome::ok) {
    if (ending.reason.starts_with(exception_mark))
      throw PluginError(ending.reason.substr(exception_mark.size()));
    throw PluginError(path + ": fails when it is loaded: " + ending.reason);
  }
  const json seen = json::parse(ending.result);
  PluginAbout plugin{.predicates = read_about(seen["predicates"]),
                     .triangulator = read_about(seen["triangulator"]),
                     .mesher = read_about(seen["mesher"]),
                     .offered = {},
                     .triangulates_graphs = seen["graphs"],
                     .refines = seen["refines"]};
  for (const int predicate : seen["offered"]) plugin.offered.push_back(static_cast<Predicate>(predicate));
  if (!plugin.predicates && !plugin.triangulator && !plugin.mesher)
    throw PluginError(path +
                      ": defines none of tribunal_predicates_entry, tribunal_triangulator_entry and "
                      "tribunal_mesher_entry");
  return plugin;
}

}  // namespace tribunal::bench
