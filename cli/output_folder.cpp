#include "cli/output_folder.hpp"

#include "datasets/files/files.hpp"

#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <system_error>
#include <unistd.h>

namespace tribunal::cli {

void require_writable_folder(const std::string& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw BadInput(folder + ": " + error.message());
  std::string probe = (std::filesystem::path(folder) / ".tribunal-XXXXXX").string();
  const int file = mkstemp(probe.data());
  if (file < 0) throw BadInput(folder + ": " + std::generic_category().message(errno));
  close(file);
  unlink(probe.c_str());
}

}  // namespace tribunal::cli
