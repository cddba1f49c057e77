// How far flips of an insertion propagate.
#pragma once

#include <cstdint>

namespace tribunal {

enum class Propagation : std::uint8_t {
  both,     ///< forward and backward, until no flip improves
  forward,  ///< to edges away from the site only, as the circle test is content with
};

}  // namespace tribunal
