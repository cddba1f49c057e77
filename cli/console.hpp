// Where verbs write: results to standard output, progress and logs to standard error.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <cstdint>
#include <iosfwd>
#include <stdexcept>
#include <string>
#include <vector>

namespace tribunal::cli {

enum class Progress : std::uint8_t { automatic, plain, json, none };

/// Exit statuses of the program.
enum Status : int {
  good = 0,
  judged_bad = 1,      ///< the judged thing failed: invalid mesh, unexpected verdict, counterexample
  bad_input = 2,       ///< bad usage or bad input, told in one line
  internal_error = 3,  ///< a fault of this program
};

/// Bad usage that only a verb can see; what() is one line.
struct BadUsage : std::runtime_error {
  using std::runtime_error::runtime_error;
};

struct Console {
  std::ostream& out;
  std::ostream& log;
  bool json = false;  ///< one JSON document on `out`, nothing else
  Progress progress = Progress::automatic;
};

/// Prints the one document of a --json run.
void print_json(Console& console, const nlohmann::json& document);

/// Prints rows as columns, two blanks apart, each as wide as its widest entry; the last column is not padded.
void print_table(Console& console, const std::vector<std::vector<std::string>>& rows);

}  // namespace tribunal::cli
