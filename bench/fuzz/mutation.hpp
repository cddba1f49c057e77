// Small changes of a case that is already hard.
#pragma once

#include "bench/fuzz/case.hpp"
#include "datasets/random.hpp"

#include <array>
#include <cstdint>
#include <string_view>

namespace tribunal::bench::fuzz {

/// One change; what its fields mean depends on the kind. Random numbers draw them, and so do the bytes of a
/// coverage-guided fuzzer: any values are valid, indices wrap around.
struct Mutation {
  enum class Kind : std::uint8_t {
    step,            ///< number `first` moves by `amount` ulps
    copy_number,     ///< number `second` becomes number `first`
    copy_point,      ///< point `second` becomes point `first`
    swap_points,     ///< points `first` and `second` change places
    scale_number,    ///< number `first` times 2^amount
    scale_axis,      ///< every coordinate of axis `first` times 2^amount
    scale_all,       ///< every number times 2^amount
    translate,       ///< number `second` is added to every coordinate of axis `first`
    move_to_origin,  ///< point `first` is subtracted from every point
    snap,            ///< number `first` loses its last |amount| mod 53 bits
    negate,          ///< number `first` changes its sign
    zero,            ///< number `first` becomes zero
  };
  static constexpr std::size_t kinds = 12;

  Kind kind;
  std::uint8_t first, second;
  std::int16_t amount;
};

/// A random one, with amounts mostly small.
Mutation draw_mutation(Random& random);

/// Changes the case; numbers that would overflow become the largest finite double.
void apply(const Mutation& mutation, Case& asked);

}  // namespace tribunal::bench::fuzz
