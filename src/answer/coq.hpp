#pragma once
#include <array>

#include "phrame/algebra/rounding.hpp"
#include "phrame/ph/curve/curve.hpp"
#include "phrame/ph/frame/frame_start.hpp"

namespace phrame::inline v0 {

/// Asks for a proof that Coq checks: of the rotation-minimizing frame and a value of its angle.
struct CoqQuery {
  Rational t = 1;  ///< > 0, where the angle is asked for
  /// Of the value; one digit more where the value is rational and these digits are a tie.
  long digits = 20;
  Reference reference = Reference::euler_rodrigues;  ///< or Frenet's: what θ is measured from
  FrameStart start = Angle();                        ///< θ(0), or where f₂ is at t = 0
};

/// |θ(t) − theta| ≤ half_unit, which "correctly rounded" says, and what a proof of it and of the
/// frame takes.
struct CoqAnswer {
  Curve curve;          ///< as asked
  Reference reference;  ///< likewise
  Rational t;           ///< likewise
  FrameAngle start;     ///< θ(0)
  Decimal theta;        ///< correctly rounded
  Rational half_unit;   ///< half a unit of the last digit of theta
  /// An open interval around [0, t] with no zero of A, of W and, for the Frenet frame, of g.
  /// Without it there is none at all.
  struct Domain {
    Rational lower;  ///< < 0
    Rational upper;  ///< > t
  };
  std::optional<Domain> domain;
  /// Cofactors with c·u + … = 1 of the components of A; none where they have a common factor.
  std::optional<std::array<Polynomial, 4>> cofactors;
  /// The same of the real and the imaginary part of g; none to the Euler–Rodrigues frame.
  std::optional<std::array<Polynomial, 2>> bend_cofactors;
  /// Numerator and denominator of a fraction are those of `lowest` times `common`.
  struct Fraction {
    RationalFunction lowest;
    Polynomial common;
  };
  Fraction rate;                      ///< −2h/σ
  std::optional<Fraction> bend_rate;  ///< Im(g′/g), over |g|², to the Frenet frame
  /// Arguments of the tactic `integral` of CoqInterval, chosen by the digits and by how near the
  /// poles are to [0, t].
  struct Effort {
    /// @{ The argument that the tactic knows by this name.
    long precision;
    long degree;
    long fuel;
    /// @}
  } effort;  ///< what the proof takes
};

/// Throws DomainError for t ≤ 0, for Reference::up, where A or W has a zero in [0, t], and for the
/// Frenet frame where g has one, an inflection; and as start_angle().
CoqAnswer answer(const Curve& curve, const CoqQuery& query);

}  // namespace phrame
