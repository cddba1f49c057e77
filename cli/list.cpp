// tribunal list: what is here.
#include "algorithms/list.hpp"

#include "algorithms/refiners.hpp"
#include "bench/outsider/probe.hpp"
#include "cli/peers.hpp"
#include "cli/verbs.hpp"
#include "datasets/dataset.hpp"
#include "datasets/external/external.hpp"
#include "datasets/files/files.hpp"
#include "predicates/backends/list.hpp"
#include "predicates/plugin/library.hpp"
#include "reports/claim.hpp"

#include <nlohmann/json.hpp>

#include <ostream>

namespace tribunal::cli {
namespace {
using nlohmann::json;

json parameter_json(const Parameter& parameter) {
  json entry{{"name", parameter.name},
             {"summary", parameter.summary},
             {"default", parameter.standard},
             {"values", describe_values(parameter)}};
  if (parameter.choices != nullptr) entry["choices"] = parameter.choices();
  return entry;
}

/// Of anything with a name, what it cites, a summary and parameters.
template <class About>
json algorithm_json(const About& about, int dimension, const char* verb,
                    std::span<const Parameter> parameters) {
  json listed = json::array();
  for (const Parameter& parameter : parameters) listed.push_back(parameter_json(parameter));
  return {{"name", about.name},       {"verb", verb},        {"dimension", dimension}, {"cites", about.cites},
          {"summary", about.summary}, {"parameters", listed}};
}

json list_algorithms() {
  json all = json::array();
  for (const PlanarAlgorithm& algorithm : planar_algorithms())
    all.push_back(
        algorithm_json(algorithm.about, algorithm.about.dimension, "triangulate", algorithm.parameters));
  for (const refinement::Refiner& refiner : refinement::refiners())
    all.push_back(algorithm_json(refiner, 2, "refine", refiner.parameters));
  return all;
}

json list_backends() {
  json all = json::array();
  for (const BackendEntry& entry : backends())
    all.push_back({{"name", entry.about->name},
                   {"exact", entry.about->exact},
                   {"dimensions", entry.bind3 ? json{2, 3} : json{2}},
                   {"domain", entry.about->domain},
                   {"cites", entry.about->cites},
                   {"summary", entry.about->summary}});
  return all;
}

json dataset_json(const Dataset& dataset, const std::string& missing) {
  const auto& [about, generate, graph] = dataset;
  return {{"name", about.name},       {"points", about.fixed_size ? json(about.fixed_size) : json("n")},
          {"integer", about.integer}, {"segments", graph != nullptr},
          {"cites", about.cites},     {"summary", about.summary},
          {"missing", missing}};
}

json list_datasets() {
  json all = json::array();
  for (const Dataset& dataset : datasets()) all.push_back(dataset_json(dataset, ""));
  for (const auto& [dataset, missing] : external_datasets()) all.push_back(dataset_json(dataset, missing()));
  return all;
}

/// Which datasets are no part of "*", and which of those cannot be read here.
std::string note_on_external_datasets() {
  std::string names, absent;
  for (const auto& [dataset, missing] : external_datasets()) {
    const std::string name(dataset.about.name);
    names += (names.empty() ? "" : ", ") + name;
    if (const std::string reason = missing(); !reason.empty()) absent += name + ": " + reason + '\n';
  }
  return "\n" + names + " are read from files of this system; \"*\" leaves them out.\n" + absent;
}

json list_claims() {
  json all = json::array();
  for (const auto& claim : reports::registered_claims())
    all.push_back({{"id", claim.id},
                   {"expected", reports::to_string(claim.expected)},
                   {"source", claim.source},
                   {"statement", claim.statement}});
  return all;
}

json list_formats() {
  json all = json::array();
  for (const auto& [name, holds, summary] : formats())
    all.push_back({{"name", name}, {"holds", holds}, {"summary", summary}});
  return all;
}

/// What each module that was built says of itself; one that cannot be loaded is listed with the reason.
json list_peers() {
  json all = json::array();
  for (const auto& [name, file] : built_peers()) {
    json peer{{"name", name}, {"file", file.string()}, {"offers", json::array()}, {"cites", ""}};
    try {
      const bench::PluginAbout about = bench::probe_plugin(file.string(), {.seconds = 10});
      const bench::OfferAbout& offer = about.first();
      for (const Predicate predicate : about.offered) peer["offers"].push_back(to_string(predicate));
      if (about.triangulator) peer["offers"].push_back("delaunay");
      if (about.triangulates_graphs) peer["offers"].push_back("constrained");
      if (about.refines) peer["offers"].push_back("refinement");
      peer["cites"] = offer.cites;
      peer["summary"] = offer.summary;
    } catch (const PluginError& error) {
      peer["summary"] = error.what();
    }
    all.push_back(std::move(peer));
  }
  return all;
}

std::string cell_text(const json& value) {
  if (value.is_string()) return value.get<std::string>();
  if (value.is_boolean()) return value.get<bool>() ? "yes" : "no";
  return value.dump();
}

/// A table with one column per key, in the order in which the keys are named.
void print_entries(Console& console, const json& entries, const std::vector<std::string>& keys) {
  std::vector<std::vector<std::string>> rows{keys};
  for (const json& entry : entries) {
    auto& row = rows.emplace_back();
    for (const std::string& key : keys) row.push_back(cell_text(entry.at(key)));
  }
  print_table(console, rows);
}

/// What `--set` takes, one line for each parameter of each algorithm.
void print_parameters(Console& console, const json& algorithms) {
  std::vector<std::vector<std::string>> rows{{"parameter of", "name", "default", "values", "summary"}};
  for (const json& algorithm : algorithms)
    for (const json& parameter : algorithm.at("parameters")) {
      auto& row = rows.emplace_back();
      row.push_back(cell_text(algorithm.at("name")));
      for (const char* key : {"name", "default", "values", "summary"})
        row.push_back(cell_text(parameter.at(key)));
    }
  console.out << '\n';
  print_table(console, rows);
}

}  // namespace

int list(const ListOptions& options, Console& console) {
  struct Listing {
    const char* what;
    json (*entries)();
    std::vector<std::string> columns;
    std::string note = {};  ///< below the table
  };
  const Listing listings[] = {
      {"algorithms", list_algorithms, {"name", "verb", "cites", "summary"}},
      {"backends",
       list_backends,
       {"name", "exact", "domain", "summary"},
       "\nEach exact one is also there as NAME+sos, which breaks in-sphere ties.\n"},
      {"datasets", list_datasets, {"name", "points", "summary"}, note_on_external_datasets()},
      {"claims", list_claims, {"id", "expected", "source", "statement"}},
      {"formats", list_formats, {"name", "holds", "summary"}},
      {"peers", list_peers, {"name", "cites", "summary", "file"}},
  };
  for (const Listing& listing : listings) {
    if (options.what != listing.what) continue;
    const json entries = listing.entries();
    if (console.json) {
      print_json(console, {{options.what, entries}});
      return good;
    }
    print_entries(console, entries, listing.columns);
    if (options.what == "algorithms") print_parameters(console, entries);
    console.out << listing.note;
    return good;
  }
  throw BadUsage("list what? algorithms, backends, datasets, claims, formats or peers, not '" + options.what +
                 "'");
}

}  // namespace tribunal::cli
