#include "algorithms/list.hpp"

#include "algorithms/planar/bowyer.hpp"
#include "algorithms/planar/green_sibson.hpp"
#include "algorithms/planar/watson.hpp"

#include <algorithm>
#include <array>

namespace tribunal {
namespace {
constexpr std::array all{
    bowyer_algorithm,
    watson_algorithm,
    green_sibson_algorithm,
};
}  // namespace

std::span<const PlanarAlgorithm> planar_algorithms() { return all; }

const PlanarAlgorithm* find_planar_algorithm(std::string_view name) {
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const auto& a) { return a.about.name == name; });
  return found == all.end() ? nullptr : &*found;
}

}  // namespace tribunal
