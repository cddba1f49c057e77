// The test that every filter ends in.
#pragma once

#include "predicates/sign.hpp"

namespace tribunal {

/// The sign of `determinant` where its magnitude exceeds the threshold; zero where it does not, or either is
/// NaN. Without branches.
inline Sign sign_beyond(double determinant, double threshold) {
  return static_cast<Sign>((determinant > threshold) - (determinant < -threshold));
}

}  // namespace tribunal
