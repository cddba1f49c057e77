// Datasets that are read from files of the user's system.
#pragma once

#include "datasets/dataset.hpp"

#include <span>
#include <string>
#include <string_view>

namespace tribunal {

/// A dataset whose file another package installs, if any did. `datasets()` leaves it out, so that "all
/// datasets" are the same everywhere; `find_dataset` finds it. Without the file its functions throw BadInput.
struct ExternalDataset {
  Dataset dataset;
  /// What the user would have to install, in one line; "" where nothing is missing.
  std::string (*missing)();
};

std::span<const ExternalDataset> external_datasets();

/// What is missing for the dataset of that name; "" for those that need nothing, and for unknown names.
std::string missing_for(std::string_view dataset);

}  // namespace tribunal
