#include "datasets/external/external.hpp"
#include "datasets/generators/generators.hpp"

#include <algorithm>
#include <array>

namespace tribunal {

std::span<const Dataset> datasets() {
  static const std::array all{
#define GENERATOR(name) generators::name,
#include "datasets/generators/list.def"
#undef GENERATOR
  };
  return all;
}

const Dataset* find_dataset(std::string_view name) {
  const auto all = datasets();
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const Dataset& d) { return d.about.name == name; });
  if (found != all.end()) return &*found;
  for (const ExternalDataset& external : external_datasets())
    if (external.dataset.about.name == name) return &external.dataset;
  return nullptr;
}

}  // namespace tribunal
