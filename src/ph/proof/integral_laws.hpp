#pragma once
#include "phrame/integrate/taylor_integral.hpp"
#include "phrame/ph/proof/integral_certificate.hpp"

namespace phrame::inline v0 {

// The laws of docs/certificate.md about integrals, exactly: what a true certificate obeys.

/// No less and no more than the integral is.
struct IntegralBounds {
  Rational lower = 0;
  Rational upper = 0;
  IntegralBounds& operator+=(const IntegralBounds& b) {
    return lower += b.lower, upper += b.upper, *this;
  }
};

/// W²r′ = X′W − XW′ = f·H. Of a curve by formulas f is 1 or −1, and e₁ = f·r′/|r′|.
struct DirectedCurve {
  Polynomial multiplier;         ///< f, positive for small t > 0 until it is turned over
  Vector<Polynomial> direction;  ///< H, of integers without a common factor
  Real turn = Rational(0);       ///< by which the angle to the frame of v grows where it begins
  IntegralBounds turn_of_models = {};  ///< the same beside formulas
};
/// Precondition: r is not a single point.
DirectedCurve directed_curve(const CertifiedSegment& segment);

/// Between segments k − 1 and k. Beside formulas the name says how near to each other the ends are
/// told to be.
std::string name_of_joint(const IntegralCertificate& c, std::size_t k);
/// Why the segment does not go on from the one before, with its frame; empty where it does. Turns
/// it over where H goes on as −H, at a corner where f has changed its sign, and finds the turn of a
/// corner.
std::string objection_to_joint(const IntegralCertificate& c, std::size_t k,
                               const DirectedCurve& before, DirectedCurve& after);

/// What is integrated, N/(D√S); a text says why there is none. Precondition: segment k is no curve
/// by formulas.
std::variant<RootQuotient, std::string> integrand(const IntegralCertificate& c, std::size_t k,
                                                  const DirectedCurve& curve);

/// Why the angle along the first segment is not proved to be 0 at t in (0, 1], by its symmetry; or
/// "". There are so many claims in all, which share what may be spent on it.
std::string objection_to_symmetry(const IntegralCertificate& c, const DirectedCurve& curve,
                                  const Rational& t, const Antisymmetry& symmetry,
                                  std::size_t claims);

/// What one piece proves.
class PieceProof {
 public:
  /// Precondition: start < piece.to. The sign of f matters to lengths, where N/(D√S) is the rate
  /// but for that.
  PieceProof(const RootQuotient& f, const IntegralPiece& piece, const Rational& start);
  /// The same of a segment of c by formulas.
  PieceProof(const IntegralCertificate& c, const FormulaSegment& segment,
             const DirectedCurve& curve, const ModelPiece& piece, const Rational& start);
  /// Of |N/(D√S)|, N having the sign of this f.
  PieceProof& of_size(const Polynomial& multiplier);

  /// Why nothing is proved, or "".
  const std::string& objection() const { return objection_; }
  /// Is the piece of a curve by formulas shorter than they may be?
  bool is_too_short() const { return is_too_short_; }
  /// By how much the rate is off, at most.
  const Rational& error() const { return error_; }
  /// Has the f of of_size() both signs, as far as is seen?
  bool has_both_signs() const { return sign_ == 0; }
  /// Of the integral from the start to t.
  IntegralBounds bounds(const Rational& t) const;

 private:
  Rational start_;
  Rational middle_;
  Rational half_;
  Polynomial integral_;  ///< of the rate, by z
  Rational size_;        ///< the rate is no greater
  Rational error_;       ///< and off by no more
  long bits_;            ///< bounds are rounded to this many
  int sign_ = 1;
  bool is_too_short_ = false;
  std::string objection_;
};

/// p as a function of z.
Polynomial on_piece(const Polynomial& p, const Rational& from, const Rational& to);
/// Σ |coefficients|, so that |p(z)| is no greater for |z| ≤ 1.
Rational sum_of_sizes(const Polynomial& p);

}  // namespace phrame
