#include "phrame/algebra/integer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <ostream>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/rational.hpp"
#include "phrame/algebra/result_of.hpp"

namespace phrame::inline v0 {
namespace {

void require_divisor(const Integer& a, const Integer& b) {
  if (b == 0) throw DomainError(fmt::format("division of {} by 0", abbreviated(a.str())));
}

void require_modulus(const Integer& m) {
  if (m < 1) throw DomainError(fmt::format("{} is no modulus", abbreviated(m.str())));
}

}  // namespace

Integer::Integer(const std::string& digits, int base) {
  // FLINT 2.9 goes over blanks, and does not see what comes after a NUL.
  const bool has_others = std::any_of(digits.begin(), digits.end(), [](unsigned char c) {
    return std::isalnum(c) == 0 && c != '-';
  });
  if (has_others || fmpz_set_str(raw(), digits.c_str(), base) != 0)
    throw InputError(fmt::format("\"{}\" is not an integer", abbreviated(digits)));
}

std::string Integer::str(int base) const {
  std::string text(fmpz_sizeinbase(raw(), base) + 2, '\0');
  fmpz_get_str(text.data(), base, raw());
  text.resize(text.find('\0'));
  return text;
}

Integer::operator long() const {
  if (fmpz_fits_si(raw()) == 0)
    throw DomainError(fmt::format("{} is too large for a machine's integer", abbreviated(str())));
  return fmpz_get_si(raw());
}

Integer::operator double() const { return static_cast<double>(Rational(*this)); }

Integer& Integer::operator/=(const Integer& x) {
  require_divisor(*this, x);
  fmpz_tdiv_q(raw(), raw(), x.raw());
  return *this;
}

Integer& Integer::operator%=(const Integer& x) {
  require_divisor(*this, x);
  Integer quotient;
  fmpz_tdiv_qr(quotient.raw(), raw(), raw(), x.raw());
  return *this;
}

std::ostream& operator<<(std::ostream& out, const Integer& x) { return out << x.str(); }

Integer gcd(const Integer& a, const Integer& b) {
  return result_of<Integer>(fmpz_gcd, a.raw(), b.raw());
}

Integer lcm(const Integer& a, const Integer& b) {
  return result_of<Integer>(fmpz_lcm, a.raw(), b.raw());
}

Integer pow(const Integer& base, unsigned long exponent) {
  return result_of<Integer>(fmpz_pow_ui, base.raw(), exponent);
}

Integer sqrt(const Integer& x) {
  if (x < 0) throw DomainError(fmt::format("sqrt: {} is negative", abbreviated(x.str())));
  return result_of<Integer>(fmpz_sqrt, x.raw());
}

Integer floor_quotient(const Integer& a, const Integer& b) {
  require_divisor(a, b);
  return result_of<Integer>(fmpz_fdiv_q, a.raw(), b.raw());
}

Integer modulo(const Integer& x, const Integer& m) {
  require_modulus(m);
  return result_of<Integer>(fmpz_mod, x.raw(), m.raw());
}

std::optional<Integer> inverse_modulo(const Integer& x, const Integer& m) {
  require_modulus(m);
  Integer result;
  if (m == 1) return result;
  if (fmpz_invmod(result.raw(), x.raw(), m.raw()) == 0) return std::nullopt;
  return result;
}

unsigned long euler_phi(unsigned long n) { return n_euler_phi(n); }

}  // namespace phrame
