#include "bench/measure.hpp"

#include <fstream>
#include <string>
#include <time.h>

namespace tribunal::bench {
namespace {

// A field of /proc/self/status, which counts in KiB; 0 where there is none.
std::uint64_t status_bytes(const std::string& field) {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
    if (line.rfind(field + ":", 0) == 0) return std::stoull(line.substr(field.size() + 1)) << 10;
  return 0;
}

// Writing 5 sets VmHWM back to the present size (proc(5), clear_refs). False where that is forbidden.
bool reset_high_water_mark() {
  std::ofstream file("/proc/self/clear_refs");
  file << '5' << std::flush;
  return file.good();
}

}  // namespace

double thread_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec) * 1e-9;
}

PeakMemory::PeakMemory() : before_(status_bytes(reset_high_water_mark() ? "VmRSS" : "VmHWM")) {}

std::uint64_t PeakMemory::growth() const {
  const std::uint64_t peak = status_bytes("VmHWM");
  return peak > before_ ? peak - before_ : 0;
}

}  // namespace tribunal::bench
