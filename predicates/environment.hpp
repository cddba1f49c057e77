// The floating-point environment that certified signs rest on, witnessed at run time.
#pragma once

#include <string>

#if defined(__FAST_MATH__)
#error "Tribunal cannot be built with -ffast-math: error bounds would certify wrong signs"
#endif

namespace tribunal {

/// What was found; all true means that signs may be trusted.
struct FloatingPointWitness {
  bool no_contraction;    ///< a*b - c*d is not fused into an FMA
  bool round_to_nearest;  ///< the rounding mode is to nearest even
  bool subnormals;        ///< neither flush-to-zero nor denormals-are-zero
  bool double_precision;  ///< expressions are not evaluated in extended precision

  bool sound() const { return no_contraction && round_to_nearest && subnormals && double_precision; }
};

/// Looks at this thread's environment. Cheap; a library loaded later may change it, so long runs ask again.
FloatingPointWitness witness_floating_point();

/// One line that names what is wrong, empty when nothing is.
std::string describe_fault(const FloatingPointWitness& witness);

}  // namespace tribunal
