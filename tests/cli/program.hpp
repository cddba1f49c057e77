// The program as its users meet it: arguments and standard input in, status and both outputs out.
#pragma once

#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace tribunal::cli {

struct Ended {
  int status = -1;  ///< exit status; 128 + signal when killed
  std::string out, err;

  nlohmann::json json() const { return nlohmann::json::parse(out); }
  /// True when standard error is exactly one line.
  bool one_line_error() const { return !err.empty() && err.find('\n') == err.size() - 1; }
};

/// Runs tribunal with these arguments.
Ended tribunal(const std::vector<std::string>& arguments, const std::string& input = "");

/// A folder of this test's own, empty at the start and removed at the end.
class Folder {
 public:
  Folder();
  ~Folder();
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  /// The path of a file in it.
  std::string operator/(std::string_view name) const { return (path_ / name).string(); }
  /// Writes a file and returns its path.
  std::string write(std::string_view name, std::string_view text) const;

 private:
  std::filesystem::path path_;
};

std::string read(const std::string& path);

}  // namespace tribunal::cli
