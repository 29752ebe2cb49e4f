#pragma once
#include <boost/multiprecision/gmp.hpp>
#include <boost/multiprecision/mpfr.hpp>

#include "phrame/algebra/rounding.hpp"
#include "phrame/export.hpp"

// Our numbers as those of Boost.Multiprecision, for programs that compute with these. Nothing of
// phrame includes this header: Boost's take seconds to compile.
namespace phrame::inline v0 {

/// @{ The same number.
PHRAME_API boost::multiprecision::mpz_int to_boost(const Integer& x);
PHRAME_API boost::multiprecision::mpq_rational to_boost(const Rational& x);
PHRAME_API Integer from_boost(const boost::multiprecision::mpz_int& x);
PHRAME_API Rational from_boost(const boost::multiprecision::mpq_rational& x);
/// @}

/// Correctly rounded to a significand of `bits` bits. Throws DomainError for bits < 1, otherwise
/// what round_to_mpfr of rounding.hpp throws.
PHRAME_API boost::multiprecision::mpfr_float round_to_mpfr(const Real& x, long bits,
                                                           PrecisionLimit limit = {});

}  // namespace phrame
