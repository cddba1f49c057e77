// The micro benchmark of predicates: every subject over every family, checked before it is timed.
#pragma once

#include "bench/campaign.hpp"
#include "bench/micro/stopwatch.hpp"
#include "bench/micro/subject.hpp"
#include "predicates/counted.hpp"
#include "predicates/predicate.hpp"

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace tribunal::bench {

/// Of one cell of the micro benchmark.
enum class MicroOutcome : std::uint8_t {
  timed,
  wrong_signs,  ///< at least one sign differs from the exact one: not timed, for a wrong result has no speed
  out_of_domain,  ///< the subject refuses the queries
  at_fault,       ///< it left the floating-point environment changed: no time of its holds
};
inline constexpr std::array<std::string_view, 4> micro_outcome_names{"timed", "wrong_signs", "out_of_domain",
                                                                     "at_fault"};
constexpr std::string_view to_string(MicroOutcome o) {
  return micro_outcome_names[static_cast<std::size_t>(o)];
}

/// What came of one subject, predicate and family.
struct MicroCell {
  std::string subject;
  Predicate predicate;
  std::string_view family;
  MicroOutcome outcome = MicroOutcome::out_of_domain;
  std::string reason;                 ///< of a refusal or a fault
  std::uint64_t queries = 0;          ///< checked
  std::uint64_t wrong = 0;            ///< of them differ from the exact sign
  PredicateCounts::ByStage stages{};  ///< queries by deciding stage
  std::vector<double> nanoseconds;    ///< per query, one value per round; the rounds of cells that share
                                      ///< predicate and family were taken side by side

  bool broke_promise = false;  ///< at fault, or wrong although it promises the true sign

  /// Takes back what was measured.
  void accuse(std::string fault) {
    outcome = MicroOutcome::at_fault;
    reason = std::move(fault);
    nanoseconds.clear();
    broke_promise = true;
  }

  double wrong_rate() const {
    return queries == 0 ? 0 : static_cast<double>(wrong) / static_cast<double>(queries);
  }
};

struct PredicateBenchOptions {
  std::vector<Subject> subjects;
  std::map<std::string, std::string> faults = {};  ///< of subjects that were at fault when they were loaded
  std::vector<Predicate> predicates;
  std::vector<const QueryFamily*> families;
  std::size_t queries = 100'352;
  std::uint64_t seed = 1;
  StopwatchOptions stopwatch = {};
  std::function<void(const Progress&)> progress = {};
  std::function<bool()> interrupted = {};  ///< asked after each round; may be empty
};

/// One cell per predicate, family and subject, in this order; fewer families, and fewer rounds of the last,
/// where the run is interrupted. A subject that leaves the floating-point environment changed is at fault,
/// and the others never notice.
std::vector<MicroCell> bench_predicates(const PredicateBenchOptions& options);

}  // namespace tribunal::bench
