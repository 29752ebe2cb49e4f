#pragma once
#include <mpfr.h>

#include <optional>
#include <string>

#include "phrame/algebra/error_free.hpp"
#include "phrame/algebra/real.hpp"
#include "phrame/export.hpp"

namespace phrame::inline v0 {

/// Where Ziv's loop gives up: at factor · (the bits of the result + those the number was made
/// from) + offset bits of precision; never, where the number is known to be irrational.
struct PrecisionLimit {
  long factor = 16;    ///< of the bits of result and number together
  long offset = 8192;  ///< what is added
};

// Correct rounding, to nearest with ties to even, by Ziv's strategy: the precision rises until
// both ends of the ball round to the same result. A number known exactly is rounded exactly. A
// number given by enclosures only must not lie on a boundary between two results: one that is known
// to be irrational never does, so that the loop ends; for others, should they, the limit is reached
// and Undecided is thrown. It grows with the bits that the number was made from, because it may be
// chosen as near to a boundary, 0 included, as these allow. Ziv, Fast evaluation of elementary
// mathematical functions with correctly rounded last bit, ACM TOMS 17 (1991).

/// The nearest double. 0 is no boundary here: a ball within 2^−1075 of it rounds to 0, the positive
/// one.
PHRAME_API double round_to_double(const Real& x, PrecisionLimit limit = {});

/// The double that all numbers of the ball round to, where there is one.
PHRAME_API std::optional<double> common_double(const RealBall& x);

/// x as the nearest double and what is left of it, off by about 2^−106·|x|; the error is infinite
/// where x is beyond the range of doubles. Fractions of integers of up to 53 bits take some
/// nanoseconds.
PHRAME_API NearNumber near_number(const Rational& x);

/// To the precision of the initialised `target`. (multiprecision.hpp has this for Boost's
/// mpfr_float.)
PHRAME_API void round_to_mpfr(mpfr_t target, const Real& x, PrecisionLimit limit = {});

/// A number with so many significant decimal digits, correctly rounded.
struct Decimal {
  std::string value;  ///< "0.28585", "1.5e-12": exactly the significant digits asked for; "0" for 0
  std::string radius;  ///< an upper bound of |value − number|, two digits; "0" where they are equal
};
/// Its value.
PHRAME_API std::ostream& operator<<(std::ostream& out, const Decimal& x);
/// With `digits` ≥ 1 significant decimal digits. Throws DomainError for digits < 1.
PHRAME_API Decimal round_to_decimal(const Real& x, long digits, PrecisionLimit limit = {});

/// @{ 2ᵏ and 10ᵏ.
PHRAME_API Rational power_of_two(long k);
PHRAME_API Rational power_of_ten(long k);
/// @}
/// log₂ x, off by less than 1, for x > 0.
PHRAME_API long binary_exponent(const Rational& x);
/// The e with 10ᵉ ≤ x < 10ᵉ⁺¹, x > 0.
PHRAME_API long decimal_exponent(const Rational& x);

/// @{ A bound of x ≥ 0 with so many digits, "1.3e-51", rounded up or down; "0" for 0. With
/// more than two digits "0.0131" where that is short.
PHRAME_API std::string upper_bound_text(const Rational& x, long digits = 2);
PHRAME_API std::string lower_bound_text(const Rational& x, long digits = 2);
/// @}

}  // namespace phrame
