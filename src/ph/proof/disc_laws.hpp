#pragma once
#include "phrame/algebra/ball.hpp"
#include "phrame/ph/proof/certificate.hpp"

namespace phrame::inline v0 {

// What the discs of a certificate prove by the laws of docs/certificate.md, if they are right.

/// Does a disc show a residue of θ′ that is not in iℤ, the root's disc meeting none of another sum?
bool shows_residue_outside_multiples_of_i(const std::vector<CertifiedLogs>& logs, long bits);

/// θ_ERF(t) without its rational part.
struct LogsByDiscs {
  RealBall at_centers;  ///< computed from the centers of the discs
  RealBall off;         ///< no true value differs from that by more
};
/// With `precision` bits. Precondition: the discs of the roots do not meet the real axis.
LogsByDiscs logs_by_discs(const Certificate& c, const Rational& t, long precision);

}  // namespace phrame
