#include "bench/whole/contestant.hpp"

#include "algorithms/constrained/constrained.hpp"
#include "algorithms/constrained/parameters.hpp"
#include "algorithms/list.hpp"
#include "algorithms/refinement/chew_parameters.hpp"
#include "algorithms/refiners.hpp"
#include "algorithms/triangulate.hpp"
#include "bench/input.hpp"
#include "bench/measure.hpp"
#include "datasets/files/files.hpp"
#include "predicates/backends/list.hpp"

#include <utility>

namespace tribunal::bench {
namespace {

constexpr std::string_view refiner = "chew", graph_triangulator = "constrained";

RaceKind kind_of(const Method& method, const Dataset& dataset) {
  if (method.algorithm == refiner) return RaceKind::refinement;
  if (method.algorithm == graph_triangulator && offers(dataset, RaceKind::graph)) return RaceKind::graph;
  return RaceKind::triangulation;
}

Bounds bounds_of(const Settings& settings) {
  const refinement::ChewOptions options = refinement::chew_options(settings);
  using Size = refinement::Size::Kind;
  if (options.size.kind == Size::none) return {options.bound.sine_squared};
  if (options.size.kind != Size::uniform) throw BadInput("races are to one size everywhere: size=NUMBER");
  return {options.bound.sine_squared, options.size.length};
}

Lap lap_of(Triangulation mesh) {
  return {.outcome = mesh.outcome, .reason = std::move(mesh.reason), .triangles = std::move(mesh.triangles)};
}

Lap lap_of(refinement::RefinedGraph refined, std::size_t given) {
  Lap lap = lap_of(std::move(refined.report.mesh));
  auto& [points, triangles, subsegments] = refined.mesh;
  lap.triangles = std::move(triangles);
  if (points.size() > given)
    lap.vertices.assign(points.begin() + static_cast<std::ptrdiff_t>(given), points.end());
  for (const auto& part : subsegments) lap.subsegments.push_back(part.ends);
  return lap;
}

/// Which of the ways to call an algorithm is the method's, over a kernel and in an order.
Lap run_bound(const Method& method, RaceKind kind, const Ground& ground, std::span<const Index> order,
              const Kernel2& kernel, double start) {
  const Graph graph{ground.points, ground.segments, ground.holes,
                    kind == RaceKind::refinement ? Domain::carved : Domain::hull};
  const auto timed = [start](auto result, auto... more) {
    const double seconds = thread_seconds() - start;
    Lap lap = lap_of(std::move(result), more...);
    lap.seconds = seconds;
    return lap;
  };
  switch (kind) {
    case RaceKind::triangulation:
      break;
    case RaceKind::graph:
      return timed(triangulate_graph(graph, order, kernel, constrained::recovery(method.settings)).mesh);
    case RaceKind::refinement:
      return timed(refinement::find_refiner(refiner)->run({graph, order, kernel, method.settings}),
                   ground.points.size());
  }
  return timed(
      triangulate(ground.points, order, kernel, *find_planar_algorithm(method.algorithm), method.settings));
}

Lap run_method(const Method& method, RaceKind kind, std::uint64_t order_seed, const Ground& ground) {
  const double start = thread_seconds();
  const auto order = insertion_order(ground.points, method.order, order_seed);
  const Kernel2Binding bound = find_backend(method.backend)->bind2(ground.points);
  if (const auto* refusal = std::get_if<Refusal>(&bound)) return {Outcome::out_of_domain, describe(*refusal)};
  return run_bound(method, kind, ground, order, *std::get<0>(bound), start);
}

}  // namespace

std::string describe(const Method& method) {
  std::string text = method.algorithm;
  for (const auto& [name, value] : method.settings) text.append(" ").append(name).append("=").append(value);
  text.append(", ").append(method.backend).append(", ");
  return text.append(order_names()[static_cast<std::size_t>(method.order)]).append(" order");
}

Course course_of(const Method& method, const Dataset& dataset, std::uint64_t n) {
  const std::string name(dataset.about.name);
  const RaceKind kind = kind_of(method, dataset);
  if (kind == RaceKind::triangulation) return {name, n};
  if (!offers(dataset, kind)) throw BadInput("dataset " + name + " encloses no domain to be refined");
  Course course{name, dataset.about.fixed_size > 0 ? 0 : n, kind};
  if (kind == RaceKind::refinement)
    course.bounds = bounds_of(method.settings);
  else if (constrained::domain(method.settings).value_or(Domain::hull) != Domain::hull)
    throw BadInput("races over segments are over the whole hull: domain=hull");
  return course;
}

Contestant contestant_of(const Method& method, RaceKind kind, std::uint64_t order_seed) {
  const PlanarAlgorithm* algorithm = find_planar_algorithm(method.algorithm);
  return {describe(method), algorithm == nullptr ? Promise::delaunay : algorithm->about.promise,
          [method, kind, order_seed](const Ground& ground) {
            return run_method(method, kind, order_seed, ground);
          }};
}

}  // namespace tribunal::bench
