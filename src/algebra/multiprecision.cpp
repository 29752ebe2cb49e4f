#include "phrame/algebra/multiprecision.hpp"

#include <fmt/format.h>

#include "phrame/algebra/error.hpp"

namespace phrame::inline v0 {

namespace mp = boost::multiprecision;

mp::mpz_int to_boost(const Integer& x) {
  mp::mpz_int result;
  fmpz_get_mpz(result.backend().data(), x.raw());
  return result;
}

mp::mpq_rational to_boost(const Rational& x) {
  mp::mpq_rational result;
  fmpq_get_mpq(result.backend().data(), x.raw());
  return result;
}

Integer from_boost(const mp::mpz_int& x) {
  Integer result;
  fmpz_set_mpz(result.raw(), x.backend().data());
  return result;
}

Rational from_boost(const mp::mpq_rational& x) {
  Rational result;
  fmpq_set_mpq(result.raw(), x.backend().data());
  return result;
}

mp::mpfr_float round_to_mpfr(const Real& x, long bits, PrecisionLimit limit) {
  if (bits < MPFR_PREC_MIN)
    throw DomainError(
        fmt::format("round_to_mpfr: {} bits are asked for, at least 1 is needed", bits));
  mp::mpfr_float result;
  mpfr_set_prec(result.backend().data(), bits);
  round_to_mpfr(result.backend().data(), x, limit);
  return result;
}

}  // namespace phrame
