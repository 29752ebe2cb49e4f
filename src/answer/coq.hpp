#pragma once
#include "phrame/algebra/rounding.hpp"
#include "phrame/ph/curve/curve.hpp"

namespace phrame {

/// What is a proof assistant to prove of a value of the angle, and how?
struct CoqQuery {
  Rational t = 1;    ///< > 0, where the angle is asked for
  long digits = 20;  ///< of the value; one more where it is rational, and a tie to these
};

/// |θ_ERF(t) − theta| ≤ half_unit: what "correctly rounded" says.
struct CoqAnswer {
  Curve curve;         ///< as asked
  Rational t;          ///< likewise
  Decimal theta;       ///< correctly rounded
  Rational half_unit;  ///< half of one in the place of its last digit
  /// Of CoqInterval's tactic `integral`, by the distance of the poles from [0, t].
  struct Effort {
    /// @{ What that tactic takes by this name.
    long precision;
    long degree;
    long fuel;
    /// @}
  } effort;  ///< what the proof takes
};

/// Throws DomainError for t ≤ 0 and where A has a zero in [0, t].
CoqAnswer answer(const Curve& curve, const CoqQuery& query);

}  // namespace phrame
