// The sign of a formula on a lattice, by integers whose widths are fixed at compile time: a stage that
// backends share.
#pragma once

#include "predicates/arithmetic/bounded_integer.hpp"
#include "predicates/formulas/in_sphere.hpp"
#include "predicates/formulas/orient.hpp"
#include "predicates/formulas/query.hpp"
#include "predicates/lattice.hpp"

#include <cassert>
#include <cstdint>

namespace tribunal {

/// A coordinate on a lattice; differences of two are counted in its unit.
template <int Bits>
struct LatticeCoordinate {
  double value, inverse_unit;
};

/// Exact: the difference is, and so is scaling it by a power of two to an integer below 2^Bits.
template <int Bits>
BoundedInteger<Bits> operator-(LatticeCoordinate<Bits> a, LatticeCoordinate<Bits> b) {
  const double units = (a.value - b.value) * a.inverse_unit;
  return {static_cast<typename BoundedInteger<Bits>::Storage>(units)};
}

/// A coordinate that is an integer itself; differences of two are below 2^Bits in magnitude.
template <int Bits>
struct CountedCoordinate {
  SignedInteger<Bits + 1> count;
};

template <int Bits>
constexpr BoundedInteger<Bits> operator-(const CountedCoordinate<Bits>& a, const CountedCoordinate<Bits>& b) {
  return {a.count - b.count};
}

/// What the determinant of a formula is when differences are below 2^Bits.
template <class Formula, int Bits>
using IntegerDeterminant = decltype(Formula::determinant(Arguments<LatticeCoordinate<Bits>, Formula>{}));

/// Calls visit.operator()<Bits>() with the least step of the ladder that is no smaller than `bits` <= 53. The
/// steps are the coordinate sizes that Barth, section 3.7, speaks of: Knuth's 14, single precision, the
/// redundant example's 28, truncation to 36, double precision.
template <class Visitor>
auto visit_ladder(int bits, Visitor visit) {
  assert(bits <= Lattice::most_bits);
  if (bits <= 14) return visit.template operator()<14>();
  if (bits <= 24) return visit.template operator()<24>();
  if (bits <= 28) return visit.template operator()<28>();
  if (bits <= 36) return visit.template operator()<36>();
  return visit.template operator()<53>();
}

/// The exact sign of the determinant of points that the lattice contains.
template <class Formula>
Sign integer_sign(const Query<Formula>& query, const Lattice& lattice) {
  return visit_ladder(lattice.bits(), [&]<int Bits>() {
    return sign_of(Formula::determinant(
        convert_arguments<LatticeCoordinate<Bits>, Formula>(query, [unit = lattice.inverse_unit()](double c) {
          return LatticeCoordinate<Bits>{c, unit};
        })));
  });
}

/// The exact sign of the determinant of integer coordinates that differ by less than 2^bits, bits <= 53.
template <class Formula>
Sign integer_sign(const Arguments<std::int64_t, Formula>& counts, int bits) {
  return visit_ladder(bits, [&]<int Bits>() {
    Arguments<CountedCoordinate<Bits>, Formula> arguments;
    for (int i = 0; i < Formula::points; ++i)
      for (int j = 0; j < Formula::dimension; ++j)
        arguments[i][j] = {static_cast<SignedInteger<Bits + 1>>(counts[i][j])};
    return sign_of(Formula::determinant(arguments));
  });
}

namespace detail {
template <class Formula, int Bits>
constexpr int intermediate_bits = IntegerDeterminant<Formula, Bits>::magnitude_bits;

// The sizes of all intermediate values of the determinants as written; the determinants themselves are a few
// bits shorter (Hadamard), but straight-line code has to hold what it passes through.
static_assert(intermediate_bits<Orient<2>, 24> == 49 && intermediate_bits<Orient<2>, 53> == 107);
static_assert(intermediate_bits<Orient<3>, 24> == 75 && intermediate_bits<Orient<3>, 53> == 162);
static_assert(intermediate_bits<InSphere<2>, 24> == 100 && intermediate_bits<InSphere<2>, 28> == 116);
static_assert(intermediate_bits<InSphere<2>, 36> == 148 && intermediate_bits<InSphere<2>, 53> == 216);
static_assert(intermediate_bits<InSphere<3>, 24> == 127 && intermediate_bits<InSphere<3>, 28> == 147);
static_assert(intermediate_bits<InSphere<3>, 36> == 187 && intermediate_bits<InSphere<3>, 53> == 272);
}  // namespace detail

}  // namespace tribunal
