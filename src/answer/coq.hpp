#pragma once
#include "phrame/algebra/rounding.hpp"
#include "phrame/ph/curve/curve.hpp"

namespace phrame::inline v0 {

/// Asks for a proof of a value of the angle that Coq checks.
struct CoqQuery {
  Rational t = 1;  ///< > 0, where the angle is asked for
  /// Of the value; one digit more where the value is rational and these digits are a tie.
  long digits = 20;
};

/// |θ_ERF(t) − theta| ≤ half_unit: what "correctly rounded" says.
struct CoqAnswer {
  Curve curve;         ///< as asked
  Rational t;          ///< likewise
  Decimal theta;       ///< correctly rounded
  Rational half_unit;  ///< half a unit of the last digit of theta
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

/// Throws DomainError for t ≤ 0 and where A has a zero in [0, t].
CoqAnswer answer(const Curve& curve, const CoqQuery& query);

}  // namespace phrame
