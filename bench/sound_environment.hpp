// The floating-point environment as it was before foreign code ran.
#pragma once

#include "predicates/environment.hpp"

#include <cfenv>
#include <string>

namespace tribunal::bench {

/// Remembers this thread's environment, which must be sound.
class SoundEnvironment {
 public:
  SoundEnvironment() { std::fegetenv(&sound_); }

  /// What code that ran since has done to the environment, empty: nothing that matters. Puts it right.
  std::string restore() const {
    std::string fault = describe_fault(witness_floating_point());
    std::fesetenv(&sound_);
    return fault;
  }

 private:
  std::fenv_t sound_{};
};

}  // namespace tribunal::bench
