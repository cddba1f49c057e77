// The one hash of the bench: names cells, runs and inputs. Not cryptographic.
#pragma once

#include "algorithms/mesh/canonical.hpp"

#include <cstdint>
#include <string>
#include <string_view>

namespace tribunal::bench {

/// FNV-1a over bytes (Fowler, Noll, Vo), 64 bits; pieces may be added one after the other.
class Hash {
 public:
  constexpr Hash& add(std::string_view bytes) {
    for (const char c : bytes) state_ = (state_ ^ static_cast<unsigned char>(c)) * 0x100000001b3;
    return *this;
  }
  constexpr std::uint64_t value() const { return state_; }

 private:
  std::uint64_t state_ = 0xcbf29ce484222325;
};

/// The hash as it is printed: 16 hexadecimal digits.
inline std::string hash_hex(std::string_view bytes) { return to_hex(Hash{}.add(bytes).value()); }

}  // namespace tribunal::bench
