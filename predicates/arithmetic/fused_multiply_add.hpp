// a b + c rounded once, as one instruction where the processor has it.
#pragma once

#include <cmath>

/// Functions marked so are compiled for processors with FMA instructions; call them behind
/// has_fused_multiply_add().
#if defined(__x86_64__) && !defined(__FMA__)
#define TRIBUNAL_FMA [[gnu::target("fma")]]
#else
#define TRIBUNAL_FMA
#endif

namespace tribunal {

/// Whether this processor runs what is marked TRIBUNAL_FMA.
inline bool has_fused_multiply_add() {
#if defined(__x86_64__) && !defined(__FMA__)
  return __builtin_cpu_supports("fma") != 0;
#else
  return true;
#endif
}

}  // namespace tribunal
