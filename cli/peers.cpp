#include "cli/peers.hpp"

#include "algorithms/peers/peers.hpp"

#include <array>
#include <string>
#include <system_error>

namespace tribunal::cli {
namespace fs = std::filesystem;

std::vector<std::pair<std::string_view, fs::path>> built_peers() {
  std::vector<std::pair<std::string_view, fs::path>> built;
  std::error_code none;
  const fs::path beside = fs::read_symlink("/proc/self/exe", none).parent_path();
  // Of a build, and of an installation.
  const std::array folders{beside / "peers", beside.parent_path() / "lib/tribunal/peers"};
  for (const std::string_view name : peer_names)
    for (const fs::path& folder : folders)
      if (const fs::path file = folder / (std::string(name) + ".so"); fs::exists(file, none)) {
        built.emplace_back(name, file);
        break;
      }
  return built;
}

}  // namespace tribunal::cli
