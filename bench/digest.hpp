// The digest of a run: what two runs of one plan must agree in.
#pragma once

#include "bench/row.hpp"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace tribunal::bench {

/// False for the outcomes that depend on the machine and its load (timeout, out_of_memory).
bool is_deterministic(const Row& row);

/// Cell key, outcome, counters, texts and mesh digest as one line: everything a repetition must reproduce.
std::string digest_line(const Row& row);

struct RunDigest {
  std::string digest;    ///< 16 hexadecimal digits over the deterministic rows, sorted by key
  std::size_t rows = 0;  ///< rows that went into it
  std::vector<std::string>
      excluded;  ///< keys of timeout and out_of_memory rows, sorted: listed, not digested
};

/// Independent of the order of `rows`, hence of jobs, machines and interruptions. O(n log n).
RunDigest digest_run(std::span<const Row> rows);

}  // namespace tribunal::bench
