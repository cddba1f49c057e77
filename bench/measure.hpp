// What a computation costs: processor time of this thread and peak memory of this process.
#pragma once

#include <cstdint>

namespace tribunal::bench {

/// Processor time used by the calling thread so far, in seconds. Unlike the wall clock it does not run while
/// other jobs have the core.
double thread_seconds();

/// Growth of the peak resident size since construction. The kernel's high-water mark is set back at the start
/// where that is allowed; elsewhere only growth beyond the process's earlier peak is seen.
class PeakMemory {
 public:
  PeakMemory();
  /// Peak resident size since construction minus the resident size at construction, in bytes (granularity:
  /// pages).
  std::uint64_t growth() const;

 private:
  std::uint64_t before_;
};

}  // namespace tribunal::bench
