#pragma once
#include "phrame/export.hpp"
#include "phrame/ph/proof/certificate.hpp"

namespace phrame::inline v0 {

/// Decides every statement of the certificate, starting from its curve, by another way than it was
/// found: each disc by the interval Newton method, angles and turns by certified quadrature of θ′
/// (of more than 300 digits by an antiderivative that is found anew), decisions by classifying the
/// curve again. Beside that the laws of docs/certificate.md must hold, so that nothing is proved
/// here that tools/check_certificate.py does not prove. What is false is never proved.
PHRAME_API std::vector<Statement> verify(const Certificate& certificate);

}  // namespace phrame
