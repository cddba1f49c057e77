// What is done to integer configurations to make hard doubles of them.
#pragma once

#include "bench/fuzz/case.hpp"
#include "datasets/random.hpp"

#include <array>
#include <cstdint>
#include <string_view>

namespace tribunal::bench::fuzz {

/// Coordinates of one batch are dressed alike, so that backends that want a common lattice can bind it. Names
/// and meanings:
enum class Fabric : std::uint8_t {
  plain,      ///< as drawn
  nudged,     ///< one coordinate moved by one unit
  ulps,       ///< up to three coordinates moved by up to four ulps
  scaled,     ///< times one power of two, anywhere from the subnormal numbers to next to overflow
  stretched,  ///< times one power of two per axis: orientations keep their degeneracy
  divided,    ///< divided by 3, 7 or 10: degenerate but for rounding
  turned,     ///< turned in the plane of the first two axes by a rational angle, rounded
  shifted,    ///< translated by a large power of two, which takes the low bits away
  mixed,      ///< each coordinate times a power of two of its own
};
inline constexpr std::array<std::string_view, 9> fabric_names{
    "plain", "nudged", "ulps", "scaled", "stretched", "divided", "turned", "shifted", "mixed"};
constexpr std::string_view to_string(Fabric fabric) { return fabric_names[static_cast<std::size_t>(fabric)]; }

class Dressing {
 public:
  /// Draws a fabric and its measures for a batch of cases of this predicate with coordinates of `bits` bits.
  Dressing(Predicate predicate, int bits, Random& random);

  Fabric fabric() const { return fabric_; }

  /// Dresses a case whose coordinates are integers; all stay finite. Most cases of the fabrics that move
  /// points are left exactly as they were, so that a batch holds ties and near-ties.
  void apply(Case& asked, Random& random) const;

 private:
  void turn(Case& asked) const;

  Fabric fabric_;
  std::array<int, 3> exponents_{};  ///< by axis: of the power of two that multiplies
  double divisor_ = 1, offset_ = 0, cosine_ = 1, sine_ = 0;
};

}  // namespace tribunal::bench::fuzz
