// tribunal points: generate a dataset.
#include "cli/lookup.hpp"
#include "cli/verbs.hpp"
#include "datasets/files/files.hpp"

#include <nlohmann/json.hpp>

namespace tribunal::cli {

int points(const PointsOptions& options, Console& console) {
  const Dataset& dataset = dataset_named(options.dataset);
  std::vector<Point2> sites = generate(dataset, options.n, options.seed);
  if (options.bits != 0) {
    if (options.bits < 1 || options.bits > 53)
      throw BadUsage("--bits " + std::to_string(options.bits) + ": a lattice has 1 to 53 bits");
    sites = quantise(sites, options.bits);
  }
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
