// The predicates of a plug-in on trial: every query family, against exact arithmetic.
#pragma once

#include "bench/fuzz/case.hpp"
#include "bench/outsider/finding.hpp"
#include "predicates/predicate.hpp"

#include <span>
#include <string>

namespace tribunal::bench {

/// Asks the predicates of the library at `path` about every query family and what the fuzzer draws. Each
/// exercise runs in a child of its own, which binds the plug-in to all points at once and compares its signs
/// with those of GMP, found beforehand where no outsider's code has run; where all are right it is timed. A
/// predicate that hangs is not asked again. The first wrong sign of each exercise is shrunk to a
/// counterexample. The library must offer the predicates.
TrialResult try_predicates(const std::string& path, std::span<const Predicate> predicates,
                           const TrialOptions& options, const Watcher& watcher);

/// One query, the plug-in bound to its points alone: what a counterexample's replay runs.
TrialResult try_query(const std::string& path, const fuzz::Case& asked, const TrialOptions& options);

}  // namespace tribunal::bench
