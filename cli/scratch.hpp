// A folder that is gone when its user is done.
#pragma once

#include <filesystem>

namespace tribunal::cli {

class ScratchFolder {
 public:
  ScratchFolder();  ///< throws std::system_error when there is no place for one
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  ~ScratchFolder();
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace tribunal::cli
