#include "cli/progress.hpp"

#include <nlohmann/json.hpp>

#include <cmath>
#include <ostream>
#include <string>
#include <unistd.h>

namespace tribunal::cli {
namespace {

/// "35 s", "4 min" or "2.5 h".
std::string time_left(double seconds) {
  if (seconds < 120) return std::to_string(std::lround(seconds)) + " s";
  if (seconds < 7200) return std::to_string(std::lround(seconds / 60)) + " min";
  const auto tenths = std::lround(seconds / 360);
  return std::to_string(tenths / 10) + "." + std::to_string(tenths % 10) + " h";
}

std::string line_of(const bench::Progress& progress) {
  std::string line = std::to_string(progress.done) + "/" + std::to_string(progress.total) + " cells";
  if (progress.failures > 0) line += ", " + std::to_string(progress.failures) + " failed";
  if (progress.done < progress.total && progress.seconds_left)
    line += ", about " + time_left(*progress.seconds_left) + " left";
  return line;
}

}  // namespace

std::function<void(const bench::Progress&)> progress_printer(Console& console) {
  std::ostream& log = console.log;
  switch (console.progress) {
    case Progress::none:
      return {};
    case Progress::json:
      return [&log](const bench::Progress& progress) {
        nlohmann::json line{
            {"done", progress.done}, {"total", progress.total}, {"failures", progress.failures}};
        line["seconds_left"] =
            progress.seconds_left ? nlohmann::json(*progress.seconds_left) : nlohmann::json(nullptr);
        if (progress.last) line["last"] = {{"key", progress.last->key}, {"outcome", progress.last->outcome}};
        log << line.dump() << '\n' << std::flush;
      };
    case Progress::automatic:
      if (isatty(STDERR_FILENO))
        return [&log](const bench::Progress& progress) {
          log << "\r\033[K" << line_of(progress) << (progress.done == progress.total ? "\n" : "")
              << std::flush;
        };
      [[fallthrough]];
    case Progress::plain:
      return [&log, twentieth = std::size_t{0}](const bench::Progress& progress) mutable {
        const std::size_t reached = progress.total ? 20 * progress.done / progress.total : 20;
        if (reached == twentieth) return;
        twentieth = reached;
        log << line_of(progress) << '\n' << std::flush;
      };
  }
  return {};
}

}  // namespace tribunal::cli
