#pragma once
#include <compare>
#include <concepts>
#include <iosfwd>
#include <optional>
#include <string>

#include "phrame/algebra/handle.hpp"
#include "phrame/export.hpp"

namespace phrame::inline v0 {

/// The integer types of C++, without bool.
template <class T>
concept MachineInteger = std::integral<T> && !std::same_as<T, bool>;

/// An integer of any size: FLINT's fmpz, which holds those below 2^62 in one word. Copies own their
/// digits; a moved-from integer is 0. Boost's integers are one conversion away
/// (multiprecision.hpp).
class PHRAME_API Integer {
 public:
  Integer() = default;  ///< 0
  /// The value of x.
  template <MachineInteger T>
  Integer(T x) {  // NOLINT(google-explicit-constructor)
    if constexpr (std::signed_integral<T>)
      fmpz_set_si(raw(), x);
    else
      fmpz_set_ui(raw(), x);
  }
  explicit Integer(const fmpz_t x) { fmpz_set(raw(), x); }  ///< a copy of FLINT's
  /// "-12": decimal digits after an optional minus. Throws InputError on anything else.
  explicit Integer(const std::string& decimal) : Integer(decimal, 10) {}
  /// The same in a base from 2 to 36.
  Integer(const std::string& digits, int base);

  /// −1, 0 or 1.
  int sign() const { return fmpz_sgn(raw()); }
  /// The digits in a base from 2 to 36; digits above 9 are a, b, …
  std::string str(int base = 10) const;
  /// Throws DomainError where it does not fit.
  explicit operator long() const;
  /// The nearest double, ±∞ beyond them.
  explicit operator double() const;

  /// @{ Exact arithmetic.
  Integer& operator+=(const Integer& x) { return fmpz_add(raw(), raw(), x.raw()), *this; }
  Integer& operator-=(const Integer& x) { return fmpz_sub(raw(), raw(), x.raw()), *this; }
  Integer& operator*=(const Integer& x) { return fmpz_mul(raw(), raw(), x.raw()), *this; }
  /// @}
  /// @{ The quotient rounded towards 0, and the remainder, which has the sign of the dividend. Both
  /// throw DomainError for x = 0.
  Integer& operator/=(const Integer& x);
  Integer& operator%=(const Integer& x);
  /// @}
  /// 2ⁿ·this.
  Integer& operator<<=(unsigned long n) { return fmpz_mul_2exp(raw(), raw(), n), *this; }
  /// ⌊this/2ⁿ⌋.
  Integer& operator>>=(unsigned long n) { return fmpz_fdiv_q_2exp(raw(), raw(), n), *this; }
  Integer& operator++() { return *this += 1; }  ///< adds 1

  /// @{ As the assignments above, on a copy.
  friend Integer operator+(Integer a, const Integer& b) { return std::move(a += b); }
  friend Integer operator-(Integer a, const Integer& b) { return std::move(a -= b); }
  friend Integer operator*(Integer a, const Integer& b) { return std::move(a *= b); }
  friend Integer operator/(Integer a, const Integer& b) { return std::move(a /= b); }
  friend Integer operator%(Integer a, const Integer& b) { return std::move(a %= b); }
  friend Integer operator<<(Integer a, unsigned long n) { return std::move(a <<= n); }
  friend Integer operator>>(Integer a, unsigned long n) { return std::move(a >>= n); }
  /// @}
  friend Integer operator-(Integer a) { return fmpz_neg(a.raw(), a.raw()), std::move(a); }  ///< −a
  /// @{ By value.
  friend bool operator==(const Integer& a, const Integer& b) {
    return fmpz_equal(a.raw(), b.raw()) != 0;
  }
  friend std::strong_ordering operator<=>(const Integer& a, const Integer& b) {
    return fmpz_cmp(a.raw(), b.raw()) <=> 0;
  }
  /// @}

  fmpz* raw() { return handle_.get(); }
  const fmpz* raw() const { return handle_.get(); }

 private:
  flint::Fmpz handle_;
};

/// Writes x in base 10.
PHRAME_API std::ostream& operator<<(std::ostream& out, const Integer& x);

inline Integer abs(Integer x) { return fmpz_abs(x.raw(), x.raw()), x; }  ///< |x|
/// @{ The greatest common divisor and the least common multiple, both ≥ 0; gcd(0, 0) = 0.
PHRAME_API Integer gcd(const Integer& a, const Integer& b);
PHRAME_API Integer lcm(const Integer& a, const Integer& b);
/// @}
PHRAME_API Integer pow(const Integer& base, unsigned long exponent);  ///< baseᵉ; 0⁰ = 1
/// ⌊√x⌋. Throws DomainError for x < 0.
PHRAME_API Integer sqrt(const Integer& x);
/// ⌊a/b⌋. Throws DomainError for b = 0.
PHRAME_API Integer floor_quotient(const Integer& a, const Integer& b);
/// The residue of x in [0, m). Throws DomainError for m < 1.
PHRAME_API Integer modulo(const Integer& x, const Integer& m);
/// 1/x modulo m, in [0, m); no value where gcd(x, m) ≠ 1. Throws DomainError for m < 1.
PHRAME_API std::optional<Integer> inverse_modulo(const Integer& x, const Integer& m);
/// Euler's φ(n), n ≥ 1: how many of 1, …, n are coprime to n.
PHRAME_API unsigned long euler_phi(unsigned long n);
/// The number of bits of |x|; 0 for 0.
inline long bit_length(const Integer& x) { return static_cast<long>(fmpz_bits(x.raw())); }

}  // namespace phrame
