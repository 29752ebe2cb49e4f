#pragma once
#include "phrame/export.hpp"
#include "phrame/ph/proof/certificate.hpp"

namespace phrame {

/// Decides every statement of the certificate, starting from its curve, by another way than it was
/// found: each disc by the interval Newton method, angles and turns by certified quadrature of θ′,
/// decisions by classifying the curve again. No claim rests on another statement. What is false is
/// never proved; a true claim is not proved where the quadrature does not get there.
PHRAME_API std::vector<Statement> verify(const Certificate& certificate);

}  // namespace phrame
