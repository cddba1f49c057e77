#include "cli/outputs.hpp"

#include "datasets/files/pslg.hpp"

#include <algorithm>
#include <filesystem>

namespace tribunal::cli {
namespace {
namespace fs = std::filesystem;

/// The inputs, and the points beside a .poly, which it may leave to them.
std::vector<fs::path> files_read(const std::vector<std::string>& inputs) {
  std::vector<fs::path> files(inputs.begin(), inputs.end());
  for (const std::string& input : inputs)
    if (ending_of(input) == ".poly") files.push_back(fs::path(input).replace_extension(".node"));
  return files;
}

std::vector<fs::path> files_written(const Outputs& outputs) {
  std::vector<fs::path> files;
  if (!outputs.mesh.empty() && outputs.mesh != "-") {
    for (const fs::path& file : mesh_files(outputs.mesh)) files.push_back(file);
    if (outputs.boundary && files.size() > 1) files.push_back(poly_beside(outputs.mesh));
  }
  for (const std::string& file : {outputs.stats, outputs.picture})
    if (!file.empty() && file != "-") files.emplace_back(file);
  return files;
}

void require_place(const fs::path& file) {
  std::error_code none;
  const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
  if (!fs::is_directory(folder, none))
    throw BadUsage(file.string() + ": there is no folder " + folder.string());
  if (fs::is_directory(file, none)) throw BadUsage(file.string() + ": is a folder");
}

/// A mesh of several files may meet an input by one that nobody named.
std::string would_overwrite(const fs::path& file, const Outputs& outputs, const fs::path& input) {
  const bool beside = file != outputs.mesh && file != outputs.stats && file != outputs.picture;
  return file.string() + (beside ? ", which goes beside " + outputs.mesh + "," : "") +
         " would overwrite the input " + input.string();
}

}  // namespace

void check_outputs(const Outputs& outputs, const Console& console) {
  if (console.json + (outputs.mesh == "-") + (outputs.stats == "-") > 1)
    throw BadUsage(console.json ? "--json and another output both want standard output"
                                : "two outputs both want standard output");
  std::error_code none;
  const std::vector<fs::path> written = files_written(outputs);
  for (const fs::path& file : written) {
    require_place(file);
    for (const fs::path& input : files_read(outputs.inputs))
      if (fs::equivalent(file, input, none)) throw BadUsage(would_overwrite(file, outputs, input));
  }
  std::vector<fs::path> places;
  places.reserve(written.size());
  for (const fs::path& file : written) places.push_back(fs::weakly_canonical(file));
  std::ranges::sort(places);
  const auto twice = std::ranges::adjacent_find(places);
  if (twice != places.end()) throw BadUsage(twice->string() + ": two outputs want this file");
}

}  // namespace tribunal::cli
