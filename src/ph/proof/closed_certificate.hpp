#pragma once
#include <string>
#include <variant>
#include <vector>

#include "phrame/ph/proof/path_certificate.hpp"

namespace phrame::inline v0 {

/// A number and what it may be off.
struct ClaimedSum {
  Rational value = 0;
  Rational radius = 0;
};

/// The claims, correctly rounded to `digits` significant digits. Throws DomainError where the path
/// is not closed with a continuous tangent, Undecided where no projection of a few tells the
/// crossings.
ClosedClaims closed_claims(const PhPath& path, const ClosedQuery& query, long digits);

/// Sets the turns of the holonomy by the sum of the angles at the end. Does that prove the claims?
bool complete(ClosedClaims& claims, const std::vector<Curve>& segments, const ClaimedSum& theta);

/// Decides the statements, by the laws of docs/certificate.md and by the integrals and crossings
/// that are found anew. Are the segments joined, and without corners? `theta` is the sum at the
/// end, or why that is not proved.
std::vector<Statement> verify(const ClosedClaims& claims, const std::vector<Curve>& segments,
                              bool is_joined, bool is_smooth,
                              const std::variant<ClaimedSum, std::string>& theta);

}  // namespace phrame
