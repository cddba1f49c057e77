// The time that a plug-in's predicate takes.
#pragma once

#include "bench/fuzz/case.hpp"
#include "predicates/plugin/loader.hpp"

#include <span>

namespace tribunal::bench {

/// Processor time per query, in seconds, with what the plug-in's interface and the kernel's cost: the median
/// of a few passes over the cases, all of one predicate, whose points the plug-in must not refuse.
double seconds_per_query(const PredicatePlugin& plugin, std::span<const fuzz::Case> cases);

}  // namespace tribunal::bench
