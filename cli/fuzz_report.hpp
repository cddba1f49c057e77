// What `tribunal fuzz` prints.
#pragma once

#include "bench/fuzz/hunt.hpp"
#include "cli/console.hpp"

#include <cstdint>
#include <span>
#include <string>

namespace tribunal::cli {

/// What was found, how to repeat it, and where it was put.
struct FuzzFinding {
  const bench::fuzz::Counterexample* counterexample;
  std::string replay;
  std::string file, picture;  ///< empty: not written
};

/// As JSON, or as a table of who was asked what and below it the counterexamples.
void print_hunt(Console& console, std::uint64_t seed, const bench::fuzz::HuntReport& report,
                std::span<const FuzzFinding> findings);

}  // namespace tribunal::cli
