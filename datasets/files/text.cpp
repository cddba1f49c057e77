#include "datasets/files/text.hpp"

#include "datasets/files/files.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <memory>
#include <system_error>
#include <unistd.h>
#include <utility>
#include <vector>

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

/// Of binary data, or a device that never ends, no more is read than up to the first zero byte.
[[noreturn]] void refuse_zero(std::string_view before, const fs::path& path) {
  throw BadInput(name_of(path) + ":" + std::to_string(1 + std::ranges::count(before, '\n')) +
                 ": a zero byte: this is no text");
}

std::string read_all(std::FILE* file, const fs::path& path) {
  std::string text;
  std::size_t used = 0;
  for (;;) {
    text.resize(std::max<std::size_t>(2 * used, std::size_t{1} << 16));
    const std::size_t read = std::fread(text.data() + used, 1, text.size() - used, file);
    if (std::ferror(file) != 0) refuse(path, "read", errno);
    if (const std::size_t zero = text.find('\0', used); zero < used + read)
      refuse_zero({text.data(), zero}, path);
    used += read;
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

/// A complete file beside the one that it is to replace; removed unless it does.
class Temporary {
 public:
  Temporary(const fs::path& path, std::string_view text)
      : path_(path), target_(fs::is_symlink(path) ? fs::weakly_canonical(path) : path), name_(target_) {
    name_ += ".part";
    name_ += std::to_string(::getpid());
    File file(std::fopen(name_.c_str(), "wb"));
    if (!file) refuse(path_, "write", errno);
    const int error = write_all(file.get(), text);
    file.reset();
    if (error == 0) return;
    std::remove(name_.c_str());
    refuse(path_, "write", error);
  }
  Temporary(Temporary&& other) noexcept
      : path_(std::move(other.path_)),
        target_(std::move(other.target_)),
        name_(std::exchange(other.name_, {})) {}
  Temporary(const Temporary&) = delete;
  Temporary& operator=(const Temporary&) = delete;
  Temporary& operator=(Temporary&&) = delete;
  ~Temporary() {
    if (!name_.empty()) std::remove(name_.c_str());
  }

  void replace_target() {
    if (std::rename(name_.c_str(), target_.c_str()) != 0) refuse(path_, "write", errno);
    name_.clear();
  }

 private:
  fs::path path_, target_, name_;
};

bool is_special(const fs::path& path) {
  std::error_code ignored;
  const auto status = fs::status(path, ignored);
  return fs::exists(status) && !fs::is_regular_file(status);
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
  const TextFile file{path, text};
  write_texts({&file, 1});
}

void write_texts(std::span<const TextFile> files) {
  std::vector<Temporary> temporaries;
  temporaries.reserve(files.size());
  for (const auto& [path, text] : files)
    if (path != "-" && !is_special(path)) temporaries.emplace_back(path, text);
  for (const auto& [path, text] : files) {
    if (path == "-") {
      if (const int error = write_all(stdout, text)) refuse("stdout", "write", error);
    } else if (is_special(path)) {
      write_directly(path, text);
    }
  }
  for (Temporary& temporary : temporaries) temporary.replace_target();
}

}  // namespace tribunal
