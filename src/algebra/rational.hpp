#pragma once
#include <optional>
#include <string>
#include <string_view>

#include "phrame/algebra/integer.hpp"
#include "phrame/export.hpp"

namespace phrame::inline v0 {

/// A fraction of integers of any size, always in lowest terms with a positive denominator: FLINT's
/// fmpq. A moved-from fraction is 0. Boost's fractions are one conversion away
/// (multiprecision.hpp).
class PHRAME_API Rational {
 public:
  Rational() = default;  ///< 0
  /// An integer of any machine type.
  template <MachineInteger T>
  Rational(T x) : Rational(Integer(x)) {}  // NOLINT(google-explicit-constructor)
  /// An integer.
  // NOLINTNEXTLINE(google-explicit-constructor)
  Rational(const Integer& x) { fmpz_set(fmpq_numref(raw()), x.raw()); }
  /// n/d. Throws DomainError for d = 0.
  Rational(const Integer& n, const Integer& d);
  explicit Rational(const fmpq_t x) { fmpq_set(raw(), x); }               ///< a copy of FLINT's
  explicit Rational(const fmpz_t x) { fmpz_set(fmpq_numref(raw()), x); }  ///< the integer

  /// −1, 0 or 1.
  int sign() const { return fmpq_sgn(raw()); }
  std::string str() const;  ///< "3/7", "-2"
  /// The nearest double, ±∞ beyond them; where that is subnormal, perhaps the one next to it.
  explicit operator double() const;

  /// @{ Exact arithmetic.
  Rational& operator+=(const Rational& x) { return fmpq_add(raw(), raw(), x.raw()), *this; }
  Rational& operator-=(const Rational& x) { return fmpq_sub(raw(), raw(), x.raw()), *this; }
  Rational& operator*=(const Rational& x) { return fmpq_mul(raw(), raw(), x.raw()), *this; }
  /// @}
  /// Throws DomainError for x = 0.
  Rational& operator/=(const Rational& x);

  /// @{ Exact arithmetic; a quotient by 0 throws DomainError.
  friend Rational operator+(Rational a, const Rational& b) { return std::move(a += b); }
  friend Rational operator-(Rational a, const Rational& b) { return std::move(a -= b); }
  friend Rational operator*(Rational a, const Rational& b) { return std::move(a *= b); }
  friend Rational operator/(Rational a, const Rational& b) { return std::move(a /= b); }
  friend Rational operator-(Rational a) { return fmpq_neg(a.raw(), a.raw()), std::move(a); }
  /// @}
  /// @{ By value.
  friend bool operator==(const Rational& a, const Rational& b) {
    return fmpq_equal(a.raw(), b.raw()) != 0;
  }
  friend std::strong_ordering operator<=>(const Rational& a, const Rational& b) {
    return fmpq_cmp(a.raw(), b.raw()) <=> 0;
  }
  /// @}

  fmpq* raw() { return handle_.get(); }
  const fmpq* raw() const { return handle_.get(); }

 private:
  flint::Fmpq handle_;
};

/// Writes "3/7", "-2".
PHRAME_API std::ostream& operator<<(std::ostream& out, const Rational& x);

/// The numerator in lowest terms, which has the sign of x.
inline Integer numerator(const Rational& x) { return Integer(fmpq_numref(x.raw())); }
/// The denominator in lowest terms, > 0.
inline Integer denominator(const Rational& x) { return Integer(fmpq_denref(x.raw())); }
inline Rational abs(Rational x) { return fmpq_abs(x.raw(), x.raw()), x; }  ///< |x|
/// The greatest integer ≤ x.
PHRAME_API Integer floor(const Rational& x);
/// The fraction in [a, b], a ≤ b, that has the least denominator, and of several the one nearest to
/// 0.
PHRAME_API Rational simplest_between(const Rational& a, const Rational& b);

/// The longest number text that parse_rational accepts, in characters.
inline constexpr std::size_t max_number_length = 100'000;
/// The largest |exponent| it accepts: decimal for "1e9", binary for "0x1p9".
inline constexpr long max_number_exponent = 100'000;

/// The exact value of "3/7", "-2", "0.9515", "1e-3", ".5" or the hexadecimal "0x1.8p-3".
/// Throws InputError, without a place, for anything else, and quotes it: "1/0", "nan", "".
PHRAME_API Rational parse_rational(std::string_view text);

/// The exact dyadic value of a double. Throws DomainError for NaN and infinities.
PHRAME_API Rational exact_rational(double x);

/// "3/7", "-2".
PHRAME_API std::string to_string(const Rational& x);

/// `text` for a message of one line: cut to `limit` bytes, with '?' for control characters.
PHRAME_API std::string abbreviated(std::string_view text, std::size_t limit = 40);

/// √x ≥ 0 where it is rational; no value where it is not, or x < 0.
PHRAME_API std::optional<Rational> square_root(const Rational& x);

}  // namespace phrame
