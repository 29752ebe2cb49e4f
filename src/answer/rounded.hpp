#pragma once
#include <string>

#include "phrame/answer/boundary_end.hpp"
#include "phrame/answer/error_size.hpp"
#include "phrame/ph/along/path_totals.hpp"
#include "phrame/ph/curve/rational_curve.hpp"

namespace phrame::inline v0 {

/// The number, correctly rounded by round_to_decimal(). Where that is Undecided, the message begins
/// with the name of the number.
Decimal rounded(const Real& x, const std::string& name, long digits);

/// The same; what is not in closed form as the number that may be 0.
Decimal rounded(const PathTotal& total, const std::string& name, long digits);

/// @{ The same for a number that may be 0. Where it cannot be told from 0 by a precision for
/// `digits`, it is 0 with a radius that bounds it. `shown_digits` ≤ `digits` are shown.
Decimal rounded_or_zero(const Real& x, const std::string& name, long digits, long shown_digits);
Decimal rounded_or_zero(const Real& x, const std::string& name, long digits);
/// @}

/// The size of a number ≥ 0.
ErrorSize error_size(const Real& number, const std::string& name, long digits);

/// Where a curve has the parameter t, and the path another one.
BoundaryEnd boundary_end(const RationalCurve& curve, const Real& t, const Real& of_path,
                         long digits);
/// A number of which no more than an enclosure is known: to that many digits, or to the most to
/// which both ends of the enclosure are rounded alike; "0" where it contains 0; one digit of its
/// middle where the ends agree in none. The radius bounds how far the number is from what is shown.
Decimal rounded_as_known(const RealBall& x, long digits = 10);
/// To the digits asked for; where no enclosure is narrow, as of a cut that is undecided, as above.
Decimal rounded_as_known(const Real& x, const std::string& name, long digits);

}  // namespace phrame
