#include "algorithms/list.hpp"

#include "algorithms/planar/listed.hpp"

#include <algorithm>
#include <array>

namespace tribunal {

std::span<const PlanarAlgorithm> planar_algorithms() {
  static const std::array all{
#define ALGORITHM(name) name##_algorithm,
#include "algorithms/planar/list.def"
#undef ALGORITHM
  };
  return all;
}

const PlanarAlgorithm* find_planar_algorithm(std::string_view name) {
  const auto all = planar_algorithms();
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const auto& a) { return a.about.name == name; });
  return found == all.end() ? nullptr : &*found;
}

}  // namespace tribunal
