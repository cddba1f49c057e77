// Cases from the bytes of coverage-guided fuzzers, and what is done with them.
#pragma once

#include "bench/fuzz/case.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace tribunal::bench::fuzz {

/// A case for any bytes; what is missing at their end is zero. Byte 0 modulo 4 names the predicate; byte 1
/// the source:
///   even  the doubles that follow, as they stand in memory, little end first; not finite ones become finite;
///   odd   a batch of the generators: the 8 bytes that follow are its seed, the next one the case's number in
///   it.
/// What then follows are mutations, 5 bytes each: kind, first, second, amount (two bytes, little end first).
Case case_of_bytes(std::span<const std::uint8_t> bytes);

/// Asks every backend that promises exactness and binds the case; one line that says who was wrong and how to
/// repeat it, empty when nobody was.
std::string judge_bytes(std::span<const std::uint8_t> bytes);

/// "orient2d 0x0p+0 ...": what `tribunal sign` takes to ask the case again.
std::string query_text(const Case& asked);

}  // namespace tribunal::bench::fuzz
