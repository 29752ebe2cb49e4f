#pragma once
#include "phrame/export.hpp"
#include "phrame/ph/along/path_angle.hpp"
#include "phrame/ph/proof/integral_certificate.hpp"

namespace phrame::inline v0 {

/// The certificate of θ(t), correctly rounded to `digits` ≥ 1 significant digits, at each t, where
/// the angle is to the frame of a vector or to the Frenet frame. The same on every machine. Throws
/// DomainError for the angle to another frame, for a path of several segments one of which is by
/// formulas and for a t that is not on it, Undecided as the angle's rounding does and where
/// singularities are closer to the path than 2^−4096, to a curve by formulas than 2^−30.
PHRAME_API IntegralCertificate certify(const PathAngle& angle, const std::vector<Rational>& at,
                                       long digits);

/// The same of the length from 0 to t.
PHRAME_API IntegralCertificate certify_length(const Path& path, const std::vector<Rational>& at,
                                              long digits);

}  // namespace phrame
