// Experiment `data-orders`: local optima of data-dependent triangulation, by the order in which edges are
// visited.
//
// The corners of the unit square and n - 4 random points with values of one of Franke's functions; the
// Delaunay triangulation, flipped in `orders` shuffled orders. Counters: `orders`, `meshes` (different ones
// that came out), `least`, `mean`, `greatest` (roughness), `spread` = (greatest - least) / mean, `delaunay`
// (roughness before).
#include "algorithms/data_dependent/optimize.hpp"
#include "algorithms/data_dependent/parameters.hpp"
#include "algorithms/mesh/canonical.hpp"
#include "bench/experiments/franke_data.hpp"
#include "bench/experiments/listed.hpp"
#include "bench/input.hpp"

#include <algorithm>
#include <array>
#include <set>
#include <string>

namespace tribunal::bench {
namespace {

constexpr Parameter orders_parameter{
    .name = "orders", .summary = "how many orders", .standard = "20", .least = 2, .most = 10'000};
constexpr std::array parameters{function_parameter, cost_parameter, norm_parameter, orders_parameter};

Finding run_data_orders(const Cell& cell) {
  if (cell.n < 4 || cell.n > 10'000) return {Outcome::refused_input, "n is 4 to 10000"};
  const std::vector<Point2> points = corners_and_random_points(cell.n, cell.seed);
  const Kernel2Binding binding = cell_kernel(points, cell);
  if (const auto* refusal = std::get_if<Refusal>(&binding))
    return {Outcome::out_of_domain, describe(*refusal)};
  const Kernel2& kernel = *std::get<0>(binding);
  const Triangulation delaunay = delaunay_of(points, kernel);
  if (delaunay.outcome != Outcome::ok) return {delaunay.outcome, delaunay.reason};

  const std::vector<double> values = sample(chosen_function(cell), points);
  const Sites sites{points, kernel};
  Settings settings = cell.parameters;
  settings["search"] = "shuffled";
  const Roughness roughness = chosen_roughness(points, values, settings);
  std::set<std::uint64_t> meshes;
  std::vector<double> totals;
  for (auto order = whole_number(cell.parameters, orders_parameter); order > 0; --order) {
    settings["flip-seed"] = std::to_string(order);
    EdgeMesh mesh(delaunay.triangles);
    flip_for_data(sites, mesh, values, settings);
    meshes.insert(digest(mesh.triangles()));
    totals.push_back(roughness.total(mesh));
  }
  const double mean = std::accumulate(totals.begin(), totals.end(), 0.0) / static_cast<double>(totals.size());
  const auto [least, greatest] = std::minmax_element(totals.begin(), totals.end());
  return {.counters = {{"orders", static_cast<double>(totals.size())},
                       {"meshes", static_cast<double>(meshes.size())},
                       {"least", *least},
                       {"mean", mean},
                       {"greatest", *greatest},
                       {"spread", (*greatest - *least) / mean},
                       {"delaunay", roughness.total(EdgeMesh(delaunay.triangles))}}};
}

}  // namespace

constinit const Experiment data_orders_experiment{
    .name = "data-orders",
    .cites = "Dyn, Levin, Rippa 1990; Barth, section 3.4",
    .summary = "local optima of data-dependent flips, by the order in which edges are visited",
    .reads = {.backend = true, .n = true, .seed = true},
    .parameters = parameters,
    .run = run_data_orders,
};

}  // namespace tribunal::bench
