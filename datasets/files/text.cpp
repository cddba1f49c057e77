#include "datasets/files/text.hpp"

#include "datasets/files/files.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <memory>
#include <system_error>
#include <unistd.h>

namespace tribunal {
namespace fs = std::filesystem;
namespace {

[[noreturn]] void refuse(const fs::path& path, std::string_view verb, int error) {
  throw BadInput(name_of(path) + ": cannot " + std::string(verb) + ": " +
                 std::generic_category().message(error));
}

struct Close {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, Close>;

std::string read_all(std::FILE* file, const fs::path& path) {
  std::string text;
  std::size_t used = 0;
  for (;;) {
    text.resize(std::max<std::size_t>(2 * used, std::size_t{1} << 16));
    used += std::fread(text.data() + used, 1, text.size() - used, file);
    if (std::ferror(file) != 0) refuse(path, "read", errno);
    if (used < text.size()) break;
  }
  text.resize(used);
  return text;
}

/// Writes and flushes; 0 or the error.
int write_all(std::FILE* file, std::string_view text) {
  errno = 0;
  const bool good = std::fwrite(text.data(), 1, text.size(), file) == text.size() && std::fflush(file) == 0;
  return good ? 0 : errno;
}

void write_directly(const fs::path& path, std::string_view text) {
  const File file(std::fopen(path.c_str(), "wb"));
  if (!file) refuse(path, "write", errno);
  if (const int error = write_all(file.get(), text)) refuse(path, "write", error);
}

void write_and_rename(const fs::path& path, std::string_view text) {
  const fs::path target = fs::is_symlink(path) ? fs::weakly_canonical(path) : path;
  fs::path temporary = target;
  temporary += ".part";
  temporary += std::to_string(::getpid());
  File file(std::fopen(temporary.c_str(), "wb"));
  if (!file) refuse(path, "write", errno);
  int error = write_all(file.get(), text);
  file.reset();
  if (error == 0 && std::rename(temporary.c_str(), target.c_str()) != 0) error = errno;
  if (error == 0) return;
  std::remove(temporary.c_str());
  refuse(path, "write", error);
}

}  // namespace

std::string name_of(const fs::path& path) { return path == "-" ? "stdin" : path.string(); }

std::string read_text(const fs::path& path) {
  if (path == "-") return read_all(stdin, path);
  const File file(std::fopen(path.c_str(), "rb"));
  if (!file) refuse(path, "read", errno);
  return read_all(file.get(), path);
}

void write_text(const fs::path& path, std::string_view text) {
  std::error_code ignored;
  if (path == "-") {
    if (const int error = write_all(stdout, text)) refuse("stdout", "write", error);
  } else if (const auto status = fs::status(path, ignored);
             fs::exists(status) && !fs::is_regular_file(status)) {
    write_directly(path, text);
  } else {
    write_and_rename(path, text);
  }
}

}  // namespace tribunal
