#pragma once
#include "phrame/algebra/surd.hpp"
#include "phrame/export.hpp"
#include "phrame/integrate/antiderivative.hpp"

namespace phrame::inline v0 {

/// An antiderivative in real functions, continuous wherever its derivative is:
///   polynomial + rational + Σ factor·log|of| + Σ factor·√radicand·arctan(√radicand·of)
///   + Σ factor·√radicand·log|(of − √radicand)/(of + √radicand)| + Σ over the roots of others.
/// Numbers are of real quadratic and biquadratic fields; terms with irrational ones come with all
/// their conjugates.
struct RealForm {
  /// factor·log|of|.
  struct Logarithm {
    Surd factor;            ///< not 0
    SurdPolynomial of;      ///< not constant
    bool positive = false;  ///< of(t) > 0 on the whole real line: |…| is not needed
    friend bool operator==(const Logarithm&, const Logarithm&) = default;
  };
  /// factor·√radicand·arctan(√radicand·of).
  struct Arctangent {
    Surd factor;                  ///< not 0
    SurdPolynomial of;            ///< not constant
    Surd radicand = Rational(1);  ///< > 0; where it is not 1, `of` is linear with a slope > 0
    friend bool operator==(const Arctangent&, const Arctangent&) = default;
  };
  /// factor·√radicand·log|(of − √radicand)/(of + √radicand)|.
  struct LogQuotient {
    Surd factor;        ///< not 0
    SurdPolynomial of;  ///< t + constant
    Surd radicand;      ///< > 0
    friend bool operator==(const LogQuotient&, const LogQuotient&) = default;
  };
  Polynomial polynomial;      ///< the polynomial part
  RationalFunction rational;  ///< proper
  /// @{ The terms of each kind.
  std::vector<Logarithm> logarithms;
  std::vector<Arctangent> arctangents;
  /// @}
  std::vector<LogSum> others = {};          ///< is_over_poles() of irreducible polynomials
  std::vector<LogQuotient> quotients = {};  ///< with the square roots of surds
};

/// The real form of F, checked: it has the derivative of F. F may be in any form.
/// A fraction over ℚ whose residues lie in ℚ or a quadratic field becomes logarithms and
/// arctangents of polynomials [Rioboo 1991], and so does one whose four or eight poles are zeros of
/// conjugate quadratic polynomials over a real quadratic or biquadratic field. The others stay sums
/// over the poles z, over which
///   Σ_{z real} c·log|t − z| + Σ_{Im z > 0} (Re c·log((t − x)² + y²) − 2 Im c·arctan((t − x)/y)),
/// c = residue(z), z = x + iy [Farouki 2003, end of §4].
PHRAME_API RealForm real_form(const Antiderivative& F);

/// The form that a book prints.
struct TextbookForm {
  RealForm real;             ///< without others
  std::vector<LogSum> sums;  ///< over roots, as integrate() writes them
};

/// The real form of F as far as it is short, checked likewise. Sums over roots are the fractions
/// that real_form() writes so, those with numbers of more than 40 digits, and those with more than
/// three poles to a residue that are more than one arctangent.
PHRAME_API TextbookForm textbook_form(const Antiderivative& F);

/// The sums of F, written over the poles, not the residues: continuous between the real poles with
/// principal logarithms.
PHRAME_API std::vector<LogSum> sums_over_poles(const TextbookForm& F);

/// Exactly. Precondition: what has a √d comes with its conjugates, as in a result of real_form().
PHRAME_API RationalFunction differentiate(const RealForm& form);

}  // namespace phrame
