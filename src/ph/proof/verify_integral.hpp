#pragma once
#include "phrame/export.hpp"
#include "phrame/ph/curve/path.hpp"
#include "phrame/ph/proof/integral_certificate.hpp"

namespace phrame::inline v0 {

/// Decides every statement by the laws of docs/certificate.md, with fractions, and what follows
/// from the pieces also by another way: by Taylor series of the rate of a RationalCurve or an
/// ExpressionCurve, in balls, on parts of their own.
PHRAME_API std::vector<Statement> verify(const IntegralCertificate& certificate);

/// The path of the segments; else in words why there is none.
PHRAME_API std::variant<Path, std::string> path_of(const IntegralCertificate& certificate);

}  // namespace phrame
