// The peers that were built with this program.
#pragma once

#include <filesystem>
#include <string_view>
#include <utility>
#include <vector>

namespace tribunal::cli {

/// Name and file of each, in the order of their list: those that stand in peers/ beside the program.
std::vector<std::pair<std::string_view, std::filesystem::path>> built_peers();

}  // namespace tribunal::cli
