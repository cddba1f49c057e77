// The hunt for wrong signs: batches against the oracle until time or number runs out.
#pragma once

#include "bench/fuzz/corpus.hpp"
#include "bench/fuzz/oracle.hpp"
#include "bench/fuzz/subject.hpp"

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tribunal::bench::fuzz {

struct HuntProgress {
  std::uint64_t checked;  ///< queries
  std::uint64_t wrong;    ///< answers
};

struct HuntOptions {
  std::vector<Subject> subjects;
  std::vector<Predicate> predicates{all_predicates.begin(), all_predicates.end()};
  std::uint64_t seed = 1;
  std::optional<std::uint64_t> queries;  ///< how many are drawn; nothing: no limit
  std::optional<double> seconds;         ///< wall clock; nothing: the clock is not read
  OracleKind oracle = OracleKind::staged;
  std::vector<CorpusEntry> corpus;  ///< asked first, and mutated
  /// Called after each batch; stops the hunt when it returns false. May be empty.
  std::function<bool(const HuntProgress&)> progress;
};

/// What an answer can break.
enum class Law : std::uint8_t {
  truth,         ///< it is the true sign, or breaks a tie
  antisymmetry,  ///< a broken tie changes its sign when two neighbouring points change places
};
inline constexpr std::array<std::string_view, 2> law_names{"truth", "antisymmetry"};
constexpr std::string_view to_string(Law law) { return law_names[static_cast<std::size_t>(law)]; }

/// The law that a bound subject's decision about a case breaks; nothing when it is right. A tie may be broken
/// symbolically, but only a tie.
std::optional<Law> broken_law(const BoundSubject& bound, const Case& asked, const Decision& decision,
                              Sign exact);

/// A wrong answer, shrunk.
struct Counterexample {
  std::string backend = {};
  Case asked = {};
  Sign exact = Sign::zero, got = Sign::zero;
  Stage stage = Stage::rounded;  ///< that gave the wrong sign
  Law law = Law::truth;          ///< that it breaks
  std::string source = {};       ///< what drew the case that was shrunk
  bool alone = false;            ///< fails also when only its own points are bound; else it is as drawn
  std::uint64_t drawn = 0;       ///< queries of the sequence up to and with its batch
};

/// What one subject did with one predicate.
struct Tally {
  using ByStage = std::array<std::uint64_t, stage_names.size()>;

  std::string backend;
  bool exact = false;  ///< the backend promises exactness
  Predicate predicate = Predicate::orient2d;
  std::uint64_t checked = 0;  ///< answers compared with the truth
  std::uint64_t refused = 0;  ///< queries in batches that it would not bind
  std::uint64_t wrong = 0;    ///< answers that were not the truth
  ByStage stages{};           ///< answers by deciding stage
  /// Of every `threshold_sample`-th query: answers within two ulps of the stage's threshold, i.e. where
  /// moving one coordinate of the last point by at most two ulps makes another stage decide.
  ByStage near_threshold{};
  std::string refusal = {};  ///< why the first refused batch was refused
  std::optional<Counterexample> counterexample = {};
};
inline constexpr std::size_t threshold_sample = 32;

struct HuntReport {
  std::uint64_t checked = 0;      ///< queries that at least one subject answered
  std::optional<double> seconds;  ///< that it took; nothing where the clock was not read
  std::vector<Tally> tallies;     ///< subject by subject, predicate by predicate
  OracleKind oracle = OracleKind::staged;
  std::uint64_t asked_gmp = 0, rechecked = 0;
  std::vector<OracleFault> oracle_faults;
  std::vector<std::string> breaches;  ///< subjects that left the floating-point environment changed, and how
};

/// Draws the sequence of batches of the seed, asks every subject that binds a batch, and compares with the
/// oracle. A subject's first wrong batch for a predicate gives its simplest case to the shrinker; later ones
/// are counted. Without `seconds` the report is a function of the options. Throws std::runtime_error when the
/// floating-point environment is not sound: then the oracle is not, either.
HuntReport hunt(const HuntOptions& options);

}  // namespace tribunal::bench::fuzz
