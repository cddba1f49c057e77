#include "bench/experiments/listed.hpp"

#include <algorithm>
#include <array>

namespace tribunal::bench {

std::span<const Experiment> experiments() {
  static const std::array all{
#define EXPERIMENT(name) name##_experiment,
#include "bench/experiments/list.def"
#undef EXPERIMENT
  };
  return all;
}

const Experiment* find_experiment(std::string_view name) {
  const auto all = experiments();
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const Experiment& e) { return e.name == name; });
  return found == all.end() ? nullptr : &*found;
}

}  // namespace tribunal::bench
