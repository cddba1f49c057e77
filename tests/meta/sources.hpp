// The project's own files, as the tests of this layer read them.
#pragma once

#include <array>
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

namespace tribunal::meta {
namespace fs = std::filesystem;

inline const fs::path root = TRIBUNAL_SOURCE_DIR;
inline constexpr std::array rooms{"predicates", "algorithms", "datasets", "bench", "reports", "cli"};

struct Source {
  std::string path;  // from the root
  std::string text;
  std::vector<std::string> includes;  // project headers only
};

inline std::string read(const fs::path& path) {
  std::ifstream file(path);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

/// What the first group of the pattern matches in the text, in order.
inline std::vector<std::string> matches(const std::string& text, const std::string& pattern) {
  const std::regex regex(pattern);
  std::vector<std::string> found;
  for (auto at = std::sregex_iterator(text.begin(), text.end(), regex); at != std::sregex_iterator(); ++at)
    found.push_back((*at)[1]);
  return found;
}

inline std::vector<Source> sources_of(std::string_view room) {
  std::vector<Source> sources;
  for (const auto& entry : fs::recursive_directory_iterator(root / room)) {
    const std::string extension = entry.path().extension().string();
    if (extension != ".hpp" && extension != ".cpp" && extension != ".h") continue;
    Source source{fs::relative(entry.path(), root).string(), read(entry.path()), {}};
    source.includes = matches(source.text, "#include \"([^\"]+)\"");
    sources.push_back(std::move(source));
  }
  return sources;
}

/// A folder whose files define one listed entry each.
struct Entries {
  std::string_view folder;
  std::string_view mark;  ///< what its definition begins with; the first string behind it is its name
  std::string_view list;  ///< where it is listed
  std::string_view page;  ///< where users read of it
};

inline constexpr Entries backends{"predicates/backends", "BackendAbout about{", "predicates/backends/all.hpp",
                                  "docs/predicates.md"};
inline constexpr Entries algorithms{"algorithms/planar", "constinit const PlanarAlgorithm",
                                    "algorithms/planar/list.def", "docs/algorithms.md"};
inline constexpr Entries datasets{"datasets/generators", "constinit const Dataset",
                                  "datasets/generators/list.def", "docs/datasets.md"};
inline constexpr Entries families{"datasets/queries", "constinit const QueryFamily",
                                  "datasets/queries/list.def", "docs/benchmarks.md"};
inline constexpr Entries experiments{"bench/experiments", "constinit const Experiment",
                                     "bench/experiments/list.def", "docs/campaigns.md"};
inline constexpr Entries judges{"reports/judges", "constinit const Judge", "reports/judges/list.def",
                                "docs/claims.md"};
inline constexpr std::array all_entries{backends, algorithms, datasets, families, experiments, judges};

}  // namespace tribunal::meta
