#include "bench/outsider/command.hpp"

#include "bench/outsider/printable.hpp"
#include "bench/outsider/replay.hpp"
#include "datasets/files/files.hpp"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstddef>
#include <cstring>
#include <fcntl.h>
#include <fstream>
#include <optional>
#include <sys/resource.h>
#include <sys/wait.h>
#include <system_error>
#include <unistd.h>
#include <utility>

namespace tribunal::bench {
namespace {
namespace fs = std::filesystem;
using End = OutsiderMesh::End;

constexpr rlim_t largest_file = rlim_t{256} << 20;
constexpr int not_executable = 126, not_found = 127;  // exit statuses of the shell

struct Placeholder {
  std::size_t place, length;
  std::string format;  ///< ".off"; empty where none is named
};

/// The first {word} or {word.format} from `from` on; a format is of small letters.
std::optional<Placeholder> find_placeholder(const std::string& command, const std::string& word,
                                            std::size_t from) {
  const std::string opening = "{" + word;
  for (std::size_t at = command.find(opening, from); at != std::string::npos;
       at = command.find(opening, at + 1)) {
    const std::size_t end = command.find('}', at), start = at + opening.size();
    if (end == std::string::npos) return std::nullopt;
    const std::string format = command.substr(start, end - start);
    const bool is_format =
        format.size() > 1 && format[0] == '.' &&
        std::all_of(format.begin() + 1, format.end(), [](char c) { return 'a' <= c && c <= 'z'; });
    if (format.empty() || is_format) return Placeholder{at, end + 1 - at, format};
  }
  return std::nullopt;
}

/// Puts `folder`/word.format wherever {word} or {word.format} stands, and returns that file's name; the first
/// says the format.
fs::path fill_in(std::string& command, const std::string& word, const std::string& format,
                 const fs::path& folder) {
  auto found = find_placeholder(command, word, 0);
  if (!found) throw BadInput("--command " + shell_word(command) + ": it names no {" + word + "}");
  fs::path file = folder / (word + (found->format.empty() ? format : found->format));
  const std::string name = shell_word(file.string());
  for (; found; found = find_placeholder(command, word, found->place + name.size()))
    command.replace(found->place, found->length, name);
  return file;
}

/// The shell's wait status. It and what it starts die with this process's group.
int run_shell(const std::string& command, const fs::path& errors) {
  const pid_t shell = fork();
  if (shell < 0) throw std::system_error(errno, std::generic_category(), "fork");
  if (shell == 0) {
    const int log = open(errors.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600);
    if (log >= 0) dup2(log, STDERR_FILENO);
    const rlimit size{largest_file, largest_file};
    setrlimit(RLIMIT_FSIZE, &size);
    execl("/bin/sh", "sh", "-c", command.c_str(), static_cast<char*>(nullptr));
    _exit(not_found);
  }
  int status = 0;
  while (waitpid(shell, &status, 0) < 0 && errno == EINTR) {
  }
  return status;
}

/// The signal that killed the command, told by the system or by the shell.
std::optional<int> signal_of(int status) {
  if (WIFSIGNALED(status)) return WTERMSIG(status);
  if (WEXITSTATUS(status) > 128) return WEXITSTATUS(status) - 128;
  return std::nullopt;
}

std::string first_line(const fs::path& path) {
  std::ifstream file(path);
  std::string line;
  std::getline(file, line);
  return line;
}

/// Position by position, for a mesh file that carries coordinates.
bool are_the_points(const std::vector<Point2>& vertices, std::span<const Point2> points) {
  return vertices.empty() || std::ranges::equal(vertices, points);
}

}  // namespace

CommandTriangulator::CommandTriangulator(std::string command, fs::path folder)
    : command_(std::move(command)), folder_(std::move(folder)), filled_(command_) {
  points_ = fill_in(filled_, "points", ".xy", folder_);
  mesh_ = fill_in(filled_, "mesh", ".off", folder_);
  write_points(points_, {});
  (void)mesh_files(mesh_);
}

OutsiderMesh CommandTriangulator::triangulate(std::span<const Point2> points) const {
  for (const auto& leftover : fs::directory_iterator(folder_)) fs::remove_all(leftover);
  write_points(points_, points);
  const fs::path errors = folder_ / "errors";
  const auto start = std::chrono::steady_clock::now();
  const int status = run_shell(filled_, errors);
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();

  if (const auto signal = signal_of(status))
    return {End::crash, std::string("signal: ") + strsignal(*signal), {}, 0};
  const std::string said = printable(without_folder(first_line(errors)));
  if (WEXITSTATUS(status) == not_found || WEXITSTATUS(status) == not_executable)
    return {End::no_program, options() + ": " + said, {}, 0};
  if (WEXITSTATUS(status) != 0)
    return {End::refused, "exit status " + std::to_string(WEXITSTATUS(status)) + ": " + said, {}, 0};
  return read(points, seconds);
}

OutsiderMesh CommandTriangulator::read(std::span<const Point2> points, double seconds) const {
  if (!fs::exists(mesh_)) return {End::garbage, "it wrote no mesh", {}, 0};
  try {
    MeshFile mesh = read_mesh(mesh_, points.size());
    if (!are_the_points(mesh.points, points))
      return {End::garbage, "the vertices of its mesh are not the points", {}, 0};
    return {End::done, {}, std::move(mesh.triangles), seconds};
  } catch (const BadInput& error) {
    return {End::garbage, printable(without_folder(error.what())), {}, 0};
  }
}

std::string CommandTriangulator::options() const { return "--command " + shell_word(command_); }

/// Messages must not depend on where the files were.
std::string CommandTriangulator::without_folder(std::string text) const {
  const std::string prefix = folder_.string() + "/";
  for (std::size_t at; (at = text.find(prefix)) != std::string::npos;) text.erase(at, prefix.size());
  return text;
}

}  // namespace tribunal::bench
