#pragma once
#include <mpfr.h>

#include <optional>
#include <string>

#include "phrame/algebra/real.hpp"
#include "phrame/export.hpp"

namespace phrame::inline v0 {

struct NearNumber;

/// The precision at which Ziv's loop gives up: factor · (bits of the result + bits that the number
/// was made from) + offset. It never gives up on a number that is known to be irrational.
struct PrecisionLimit {
  long factor = 16;    ///< by which the bits of result and number are multiplied
  long offset = 8192;  ///< added to that, in bits
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

/// The double to which all numbers of the ball round; no value where there is none.
PHRAME_API std::optional<double> common_double(const RealBall& x);

/// x as its nearest double plus a second one, with an error of about 2^−106·|x|; the error is
/// infinite where x is beyond the range of doubles. Cost: some nanoseconds for fractions of
/// integers of up to 53 bits.
PHRAME_API NearNumber near_number(const Rational& x);

/// Sets `target`, which is initialised, to x in its precision. (multiprecision.hpp has this for
/// Boost's mpfr_float.)
PHRAME_API void round_to_mpfr(mpfr_t target, const Real& x, PrecisionLimit limit = {});

/// A number that is correctly rounded to some number of significant decimal digits.
struct Decimal {
  std::string value;  ///< "0.28585", "1.5e-12": exactly the significant digits asked for; "0" for 0
  std::string radius;  ///< an upper bound of |value − number|, two digits; "0" where they are equal
};
/// Writes its value.
PHRAME_API std::ostream& operator<<(std::ostream& out, const Decimal& x);
/// x rounded to `digits` significant decimal digits. Throws DomainError for digits < 1.
PHRAME_API Decimal round_to_decimal(const Real& x, long digits, PrecisionLimit limit = {});

/// @{ 2ᵏ and 10ᵏ.
PHRAME_API Rational power_of_two(long k);
PHRAME_API Rational power_of_ten(long k);
/// @}
/// log₂ x, off by less than 1, for x > 0.
PHRAME_API long binary_exponent(const Rational& x);
/// The e with 10ᵉ ≤ x < 10ᵉ⁺¹, x > 0.
PHRAME_API long decimal_exponent(const Rational& x);

/// @{ A bound of x ≥ 0 with that many digits, rounded up or down, such as "1.3e-51"; with more than
/// two digits also "0.0131", where that is short; "0" for 0.
PHRAME_API std::string upper_bound_text(const Rational& x, long digits = 2);
PHRAME_API std::string lower_bound_text(const Rational& x, long digits = 2);
/// @}

}  // namespace phrame
