#include "algorithms/data_dependent/optimize.hpp"

#include "algorithms/data_dependent/parameters.hpp"
#include "algorithms/data_dependent/roughness_criterion.hpp"

#include <algorithm>
#include <string>

namespace tribunal {
namespace {

FlipCounts flip_downhill(const RoughMesh& rough, const FlipOptions& options) {
  RoughnessCriterion criterion(rough.roughness);
  return flip_to_optimum(rough.sites, rough.mesh, criterion, options);
}

}  // namespace

std::vector<double> chosen_data(std::span<const Point2> points, std::span<const double> values,
                                const Settings& settings) {
  const std::string name = choice(settings, data_parameter);
  if (name == third_column) {
    if (values.size() != points.size())
      throw Abandon(
          Outcome::refused_input,
          "data are read from the third column, and there is none (--set data=F1 takes a function)");
    return {values.begin(), values.end()};
  }
  const auto& functions = franke_functions();
  const auto function =
      std::find_if(functions.begin(), functions.end(), [&](const auto& f) { return f.name == name; });
  return sample(*function, points);
}

Roughness chosen_roughness(std::span<const Point2> points, std::span<const double> data,
                           const Settings& settings) {
  return {points, data, choice_as<Cost>(settings, cost_parameter), choice_as<Norm>(settings, norm_parameter)};
}

FlipCounts flip_for_data(const Sites& sites, EdgeMesh& mesh, std::span<const double> data,
                         const Settings& settings) {
  const Roughness roughness = chosen_roughness(sites.points, data, settings);
  const RoughMesh rough{sites, mesh, roughness};
  const std::uint64_t seed = whole_number(settings, flip_seed_parameter);
  const std::uint64_t most = most_flips(sites.points.size());
  switch (choice_as<Search>(settings, search_parameter)) {
    case Search::sweeps:
      return flip_downhill(rough, {.method = Method::sweeps});
    case Search::shuffled:
      return flip_downhill(rough, {.method = Method::sweeps, .scan = Scan::shuffled, .seed = seed});
    case Search::stack:
      return flip_downhill(rough, {.method = Method::stack});
    case Search::best:
      return flip_best_first(rough, most);
    case Search::look_ahead:
      return flip_looking_ahead(rough, most);
    case Search::annealing:
      return anneal(rough, most, {.seed = seed});
  }
  return {};
}

}  // namespace tribunal
