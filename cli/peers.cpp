#include "cli/peers.hpp"

#include "algorithms/peers/peers.hpp"

#include <string>
#include <system_error>

namespace tribunal::cli {
namespace fs = std::filesystem;

std::vector<std::pair<std::string_view, fs::path>> built_peers() {
  std::vector<std::pair<std::string_view, fs::path>> built;
  std::error_code none;
  const fs::path folder = fs::read_symlink("/proc/self/exe", none).parent_path() / "peers";
  for (const std::string_view name : peer_names) {
    const fs::path file = folder / (std::string(name) + ".so");
    if (fs::exists(file, none)) built.emplace_back(name, file);
  }
  return built;
}

}  // namespace tribunal::cli
