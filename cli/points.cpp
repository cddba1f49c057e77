// tribunal points: generate a dataset.
#include "cli/lookup.hpp"
#include "cli/verbs.hpp"
#include "datasets/files/files.hpp"
#include "datasets/files/pslg.hpp"

#include <nlohmann/json.hpp>

#include <filesystem>

namespace tribunal::cli {
namespace {

/// A .poly with the .node file beside that holds its points.
int write_graph(const PointsOptions& options, const Dataset& dataset, Console& console) {
  DatasetGraph graph = generate_graph(dataset, options.n, options.seed);
  if (options.bits != 0) graph = quantise(std::move(graph), options.bits);
  write_poly(options.output, graph.points, {graph.segments, graph.holes, "carved"});
  if (console.json)
    print_json(console, {{"dataset", options.dataset},
                         {"seed", options.seed},
                         {"n", graph.points.size()},
                         {"segments", graph.segments.size()},
                         {"file", options.output}});
  return good;
}

}  // namespace

int points(const PointsOptions& options, Console& console) {
  const Dataset& dataset = dataset_named(options.dataset);
  if (options.bits < 0 || options.bits > 53)
    throw BadUsage("--bits " + std::to_string(options.bits) + ": a lattice has 1 to 53 bits");
  if (dataset.graph != nullptr && ending_of(options.output) == ".poly")
    return write_graph(options, dataset, console);
  std::vector<Point2> sites = generate(dataset, options.n, options.seed);
  if (options.bits != 0) sites = quantise(sites, options.bits);
  if (console.json && options.output == "-") {
    nlohmann::json coordinates = nlohmann::json::array();
    for (const Point2& p : sites) coordinates.push_back({p[0], p[1]});
    print_json(console, {{"dataset", options.dataset}, {"seed", options.seed}, {"points", coordinates}});
    return good;
  }
  write_points(options.output, sites);
  if (console.json)
    print_json(console, {{"dataset", options.dataset},
                         {"seed", options.seed},
                         {"n", sites.size()},
                         {"file", options.output}});
  return good;
}

}  // namespace tribunal::cli
