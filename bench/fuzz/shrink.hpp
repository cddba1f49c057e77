// From a counterexample to the smallest one that greedy steps reach.
#pragma once

#include "bench/fuzz/case.hpp"

#include <compare>
#include <functional>

namespace tribunal::bench::fuzz {

/// How complicated a case is to look at: compared in this order.
struct CaseSize {
  int bits;       ///< of all mantissas, from the first to the last set bit; 0 for zero
  int exponents;  ///< sum of |floor(log2 |x|)|
  int distinct;   ///< different nonzero numbers
  int negative;   ///< negative numbers, -0 among them

  // The generated comparison asks whether an ordering is < 0, which the check takes for a null pointer.
  // NOLINTNEXTLINE(modernize-use-nullptr)
  friend auto operator<=>(const CaseSize&, const CaseSize&) = default;
};
CaseSize size_of(const Case& asked);

/// A case for which `fails` still holds and that no step makes smaller without losing that. Steps: move a
/// point to the origin; make points or numbers equal, zero or one; shorten mantissas, all at once, those of
/// one value or one by one; bring exponents towards zero, all, by axis, by point or one by one; drop signs;
/// and where none of these helps, several numbers at once. Each accepted step lowers size_of, so it ends; the
/// same arguments give the same result, and shrinking that again changes nothing. `fails` must hold for
/// `asked` and be a function of its argument.
Case shrink(const Case& asked, const std::function<bool(const Case&)>& fails);

}  // namespace tribunal::bench::fuzz
