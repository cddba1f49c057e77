// What a trial of an outsider finds out.
#pragma once

#include "algorithms/triangulation.hpp"
#include "bench/sandbox.hpp"

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace tribunal::bench {

/// What came of one exercise. Right is right everywhere in it; wrong, crash, hang and out_of_memory are
/// failures; refused is no failure, for an outsider may have a domain.
enum class Finding : std::uint8_t { right, wrong, refused, crash, hang, out_of_memory, untried };

inline constexpr std::array<std::string_view, 7> finding_names{"right", "wrong",         "refused", "crash",
                                                               "hang",  "out_of_memory", "untried"};
constexpr std::string_view to_string(Finding f) { return finding_names[static_cast<std::size_t>(f)]; }

constexpr bool failed(Finding f) {
  return f == Finding::wrong || f == Finding::crash || f == Finding::hang || f == Finding::out_of_memory;
}

/// The finding that a sandboxed child's end is, where it did not come to a result of its own.
constexpr Finding finding_of(Outcome ending) {
  switch (ending) {
    case Outcome::ok:
      return Finding::right;
    case Outcome::timeout:
      return Finding::hang;
    case Outcome::out_of_memory:
      return Finding::out_of_memory;
    default:
      return Finding::crash;
  }
}

/// One exercise: a predicate on a query family, or a triangulation of a dataset.
struct Exercise {
  std::string task;     ///< a predicate's name, or "delaunay"
  std::string input;    ///< a family's or a dataset's name
  std::uint64_t n = 0;  ///< queries asked, or points triangulated
  Finding finding = Finding::untried;
  std::string reason;       ///< one line where the finding is not `right`
  std::uint64_t wrong = 0;  ///< wrong signs
  /// Per query, or of the largest triangulation; 0 unless right: a wrong result has no time.
  double seconds = 0;
};

/// A failure in as few points as were found to show it.
struct Counterexample {
  std::string task, input;
  Finding finding = Finding::wrong;
  std::vector<std::vector<double>> points;
  std::string exact;   ///< the sign there is ("+", "-" or "0"), or "valid"
  std::string got;     ///< the sign given, or what is wrong
  std::string replay;  ///< a command line that shows it again
  /// Of a wrong mesh of these points, normalised; corners may be out of range.
  std::vector<Triangle> triangles;
  std::string picture;  ///< an SVG document, where there is more to show than points and triangles
};

struct TrialOptions {
  std::uint64_t seed = 1;
  std::uint64_t queries = 10'000;  ///< of each predicate and family
  std::uint64_t points = 200;      ///< of each dataset
  Limits limits{.seconds = 5};     ///< of each exercise
  int wake = -1;                   ///< a descriptor that becomes readable where the trial is to end; -1: none
};

/// Called after each exercise; the trial goes on where it returns true.
using Watcher = std::function<bool(const Exercise&)>;

/// Why an exercise is untried when the trial was ended in the middle of it.
inline constexpr std::string_view interrupted_reason = "interrupted";

struct TrialResult {
  std::vector<Exercise> exercises;
  std::vector<Counterexample> counterexamples;
};

}  // namespace tribunal::bench
