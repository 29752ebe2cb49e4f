#pragma once
#include "phrame/export.hpp"
#include "phrame/ph/proof/certificate.hpp"

namespace phrame::inline v0 {

/// The certificate of θ(t), correctly rounded to `digits` ≥ 1 significant digits, at each t, and of
/// what `classify` says of the curve, polynomial or rational. The same on every machine. Throws
/// DomainError for the Frenet frame of a straight line, for Reference::up, for a t outside [0, 1]
/// of a rational curve, and Undecided as the angle's rounding does.
PHRAME_API Certificate certify(const Curve& curve, Reference reference,
                               const std::vector<Rational>& at, long digits);

}  // namespace phrame
