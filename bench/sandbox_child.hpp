// The child's side of the sandbox.
#pragma once

#include "bench/sandbox.hpp"

#include <functional>
#include <string>
#include <sys/types.h>

// AddressSanitizer reserves terabytes of address space, so that RLIMIT_AS cannot be used under it.
#if defined(__SANITIZE_ADDRESS__)
#define TRIBUNAL_ADDRESS_SANITIZER 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define TRIBUNAL_ADDRESS_SANITIZER 1
#endif
#endif

namespace tribunal::bench {

/// True where the parent watches the resident size because the address space cannot be capped.
#ifdef TRIBUNAL_ADDRESS_SANITIZER
inline constexpr bool watch_resident_size = true;
#else
inline constexpr bool watch_resident_size = false;
#endif

/// Exit status of a child that ran out of memory: it says so without allocating.
inline constexpr int out_of_memory_status = 86;

/// Everything a forked child does: caps itself, runs `work`, writes one frame to `pipe`, exits. `parent` is
/// the id of the process that forked.
[[noreturn]] void run_child(const std::function<std::string()>& work, const Limits& limits, int pipe,
                            pid_t parent);

}  // namespace tribunal::bench
