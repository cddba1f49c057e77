// Signed integers of a width fixed at compile time: no allocation, and every loop has a constant length.
#pragma once

#include "predicates/sign.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace tribunal {

__extension__ using Int128 = __int128;
__extension__ using UInt128 = unsigned __int128;

/// Two's complement in `Words` words of 64 bits, least significant first. Sums and products are exact modulo
/// 2^(64 Words): whoever chooses the width sees to it that the true value fits.
template <std::size_t Words>
struct FixedInteger {
  std::array<std::uint64_t, Words> word{};

  constexpr bool is_negative() const { return word[Words - 1] >> 63 != 0; }

  friend constexpr FixedInteger operator+(FixedInteger a, const FixedInteger& b) {
    std::uint64_t carry = 0;
    for (std::size_t i = 0; i < Words; ++i) {
      const UInt128 sum = static_cast<UInt128>(a.word[i]) + b.word[i] + carry;
      a.word[i] = static_cast<std::uint64_t>(sum);
      carry = static_cast<std::uint64_t>(sum >> 64);
    }
    return a;
  }
  friend constexpr FixedInteger operator-(FixedInteger a, const FixedInteger& b) {
    a.template subtract_shifted<0>(b, ~std::uint64_t{0});
    return a;
  }

  /// Subtracts 2^(64 Shift) times b, of whose words only the bits of `mask` count.
  template <std::size_t Shift, std::size_t Others>
  constexpr void subtract_shifted(const FixedInteger<Others>& b, std::uint64_t mask) {
    std::uint64_t borrow = 0;
    for (std::size_t i = Shift; i < Words; ++i) {
      const std::uint64_t subtrahend = i - Shift < Others ? b.word[i - Shift] & mask : 0;
      const UInt128 difference = static_cast<UInt128>(word[i]) - subtrahend - borrow;
      word[i] = static_cast<std::uint64_t>(difference);
      borrow = static_cast<std::uint64_t>(difference >> 64) & 1;
    }
  }
  friend constexpr bool operator==(const FixedInteger&, const FixedInteger&) = default;
};

template <std::size_t Words>
constexpr Sign sign_of(const FixedInteger<Words>& a) {
  if (a.is_negative()) return Sign::negative;
  std::uint64_t any = 0;
  for (const std::uint64_t w : a.word) any |= w;
  return any != 0 ? Sign::positive : Sign::zero;
}

/// The smallest of int64, int128 and FixedInteger that holds `Bits` bits, the sign among them.
template <int Bits>
using SignedInteger = std::conditional_t<
    (Bits <= 64), std::int64_t,
    std::conditional_t<(Bits <= 128), Int128, FixedInteger<(static_cast<std::size_t>(Bits) + 63) / 64>>>;

namespace detail {
constexpr FixedInteger<1> to_words(std::int64_t a) { return {{static_cast<std::uint64_t>(a)}}; }
constexpr FixedInteger<2> to_words(Int128 a) {
  return {{static_cast<std::uint64_t>(a), static_cast<std::uint64_t>(a >> 64)}};
}
template <std::size_t Words>
constexpr const FixedInteger<Words>& to_words(const FixedInteger<Words>& a) {
  return a;
}

template <class T>
struct WordCount;
template <std::size_t Words>
struct WordCount<FixedInteger<Words>> : std::integral_constant<std::size_t, Words> {};
}  // namespace detail

/// The same value in the type To, which must be wide enough.
template <class To, class From>
constexpr To widen(const From& a) {
  if constexpr (std::is_same_v<To, From>) {
    return a;
  } else if constexpr (std::is_same_v<To, Int128>) {
    return static_cast<Int128>(a);
  } else {
    const auto narrow = detail::to_words(a);
    To wide;
    wide.word.fill(narrow.is_negative() ? ~std::uint64_t{0} : 0);
    for (std::size_t i = 0; i < narrow.word.size(); ++i) wide.word[i] = narrow.word[i];
    return wide;
  }
}

namespace detail {
/// Schoolbook product of the operands read as unsigned, modulo 2^(64 Words).
template <std::size_t Words, std::size_t A, std::size_t B>
constexpr FixedInteger<Words> unsigned_product(const FixedInteger<A>& a, const FixedInteger<B>& b) {
  FixedInteger<Words> product;
  for (std::size_t i = 0; i < A; ++i) {
    std::uint64_t carry = 0;
    for (std::size_t j = 0; j < B && i + j < Words; ++j) {
      const UInt128 t = static_cast<UInt128>(a.word[i]) * b.word[j] + product.word[i + j] + carry;
      product.word[i + j] = static_cast<std::uint64_t>(t);
      carry = static_cast<std::uint64_t>(t >> 64);
    }
    if (i + B < Words) product.word[i + B] = carry;
  }
  return product;
}

}  // namespace detail

/// a * b in the type To, which must be wide enough for the true product.
template <class To, class Left, class Right>
constexpr To multiply(const Left& a, const Right& b) {
  if constexpr (std::is_integral_v<To> || std::is_same_v<To, Int128>) {
    return static_cast<To>(a) * static_cast<To>(b);
  } else {
    // A negative a of A words reads as a + 2^(64 A), so the unsigned product has b * 2^(64 A) too much;
    // likewise b. Should the result be wider than both operands together, the product is completed by
    // extending its sign.
    constexpr std::size_t words = detail::WordCount<To>::value;
    const auto x = detail::to_words(a);
    const auto y = detail::to_words(b);
    constexpr std::size_t A = detail::WordCount<std::remove_const_t<decltype(x)>>::value;
    constexpr std::size_t B = detail::WordCount<std::remove_const_t<decltype(y)>>::value;
    constexpr std::size_t full = A + B < words ? A + B : words;
    auto product = detail::unsigned_product<full>(x, y);
    product.template subtract_shifted<A>(y, x.is_negative() ? ~std::uint64_t{0} : 0);
    product.template subtract_shifted<B>(x, y.is_negative() ? ~std::uint64_t{0} : 0);
    return widen<To>(product);
  }
}

static_assert(multiply<FixedInteger<3>>(std::int64_t{-3}, Int128{5} << 100) ==
              widen<FixedInteger<3>>(Int128{-15} << 100));
static_assert(sign_of(widen<FixedInteger<4>>(std::int64_t{-1}) + widen<FixedInteger<4>>(std::int64_t{1})) ==
              Sign::zero);

}  // namespace tribunal
