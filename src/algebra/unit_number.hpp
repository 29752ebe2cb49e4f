#pragma once
#include <algorithm>
#include <bit>
#include <cmath>

#include "phrame/algebra/integer.hpp"

namespace phrame::inline v0 {

// What the recurrences of unit_series() ask of integers: of those of any size, and of those of two
// words, which take a quarter of the time.

/// An integer of two words.
__extension__ using TwoWords = __int128;
/// So many bits may the factors of a ProductSum<TwoWords> have, and so many products there may be.
inline constexpr long most_factor_bits = 120;
inline constexpr std::size_t most_products = 32;

inline long bit_length(TwoWords x) {
  const TwoWords size = x < 0 ? -x : x;
  const auto high = static_cast<ulong>(size >> 64);
  return static_cast<long>(high != 0 ? 64 + std::bit_width(high)
                                     : std::bit_width(static_cast<ulong>(size)));
}
inline int sign(const Integer& x) { return x.sign(); }
inline int sign(TwoWords x) { return x < 0 ? -1 : x > 0 ? 1 : 0; }
inline double to_double(const Integer& x) { return fmpz_get_d(x.raw()); }
inline double to_double(TwoWords x) { return static_cast<double>(x); }
inline const Integer& to_integer(const Integer& x) { return x; }
inline Integer to_integer(TwoWords x) {
  Integer result;
  fmpz_set_signed_uiui(result.raw(), static_cast<ulong>(x >> 64), static_cast<ulong>(x));
  return result;
}
template <class Number>
Number from_integer(const Integer& x);
template <>
inline Integer from_integer(const Integer& x) {
  return x;
}
/// x < 2^127.
template <>
inline TwoWords from_integer(const Integer& x) {
  ulong high = 0;
  ulong low = 0;
  fmpz_get_signed_uiui(&high, &low, x.raw());
  return (static_cast<TwoWords>(static_cast<slong>(high)) << 64) | static_cast<TwoWords>(low);
}
/// @{ ⌊x/n⌋, n > 0.
inline Integer floor_quotient(Integer x, std::size_t n) {
  return fmpz_fdiv_q_ui(x.raw(), x.raw(), n), x;
}
inline TwoWords floor_quotient(TwoWords x, std::size_t n) {
  const auto by = static_cast<TwoWords>(n);
  const TwoWords quotient = x / by;
  return quotient * by > x ? quotient - 1 : quotient;
}
/// @}

/// A sum of products, from which its upper bits are taken.
template <class Number>
class ProductSum {
 public:
  void add(const Number& a, const Number& b) { fmpz_addmul(sum_.raw(), a.raw(), b.raw()); }
  /// k·a·b; a is the shorter one.
  void add(const Number& a, const Number& b, long k) {
    fmpz_mul_si(multiple_.raw(), a.raw(), k);
    add(multiple_, b);
  }
  /// ⌊sum/2^bits⌋.
  Number upper(long bits) const { return sum_ >> static_cast<ulong>(bits); }
  /// ⌊sum/d⌋, d > 0.
  Number over(const Number& d) const {
    Number quotient;
    return fmpz_fdiv_q(quotient.raw(), sum_.raw(), d.raw()), quotient;
  }

 private:
  Number sum_;
  Number multiple_;
};

/// With a = a₁2⁶⁴ + a₀, 0 ≤ a₀ < 2⁶⁴, |a₁| < 2⁵⁶, the sums of a₁b₁, of a₁b₀ + a₀b₁ and of a₀b₀ are
/// apart, the last as its two words: none exceeds 2^126.
template <>
class ProductSum<TwoWords> {
 public:
  void add(TwoWords a, TwoWords b) {
    const auto a0 = static_cast<TwoWords>(static_cast<ulong>(a));
    const auto b0 = static_cast<TwoWords>(static_cast<ulong>(b));
    const TwoWords a1 = a >> 64;
    const TwoWords b1 = b >> 64;
    ulong high = 0;
    ulong low = 0;
    umul_ppmm(high, low, static_cast<ulong>(a), static_cast<ulong>(b));
    low_ += low;
    middle_ += a1 * b0 + b1 * a0 + high;
    high_ += a1 * b1;
  }
  void add(TwoWords a, TwoWords b, long k) { add(a, k * b); }
  /// ⌊sum/2^bits⌋, 64 ≤ bits ≤ 128; a number of 126 bits where it has more.
  TwoWords upper(long bits) const {
    const TwoWords middle = middle_ + (low_ >> 64);
    const TwoWords high = high_ + (middle >> 64);
    const auto rest = static_cast<TwoWords>(static_cast<ulong>(middle));
    if (bit_length(high) + 128 - bits > 126) return static_cast<TwoWords>(1) << 125;
    return (high << (128 - bits)) + (rest >> (bits - 64));
  }

 private:
  TwoWords low_ = 0;
  TwoWords middle_ = 0;
  TwoWords high_ = 0;
};

}  // namespace phrame
