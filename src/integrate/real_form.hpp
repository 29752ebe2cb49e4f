#pragma once
#include "phrame/algebra/surd.hpp"
#include "phrame/integrate/antiderivative.hpp"

namespace phrame {

/// An antiderivative in real functions, continuous wherever its derivative is:
///   polynomial + rational + Σ factor·log|of| + Σ factor·arctan(of) + Σ over the roots of others.
/// Residues in ℚ, ℚ(i) and quadratic fields become logarithms and arctangents of polynomials; the
/// others stay sums over the poles z, over which
///   Σ_{z real} c·log|t − z| + Σ_{Im z > 0} (Re c·log((t − x)² + y²) − 2 Im c·arctan((t − x)/y)),
/// c = residue(z), z = x + iy [Farouki 2003, end of §4].
struct RealForm {
  struct Logarithm {
    Surd factor;
    SurdPolynomial of;
    bool positive = false;  ///< of(t) > 0 on the whole real line: |…| is not needed
    friend bool operator==(const Logarithm&, const Logarithm&) = default;
  };
  struct Arctangent {
    Surd factor;
    SurdPolynomial of;
    friend bool operator==(const Arctangent&, const Arctangent&) = default;
  };
  Polynomial polynomial;
  RationalFunction rational;  ///< proper
  std::vector<Logarithm> logarithms;
  std::vector<Arctangent> arctangents;
  std::vector<LogSum> others;  ///< is_over_poles() of irreducible polynomials
};

/// The real form of F, checked: it has the derivative of F. F may be in any form.
RealForm real_form(const Antiderivative& F);

/// Exactly. Precondition: logarithms with √d come in conjugate pairs, and an arctangent of √d times
/// a rational polynomial has a factor in √d·ℚ, as in a result of real_form().
RationalFunction differentiate(const RealForm& form);

}  // namespace phrame
