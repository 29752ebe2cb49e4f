#pragma once
#include "phrame/algebra/rounding.hpp"
#include "phrame/ph/curve/curve.hpp"

namespace phrame {

/// What is a proof assistant to prove of a value of the angle, and how?
struct CoqQuery {
  Rational t = 1;
  long digits = 20;
};

/// |θ_ERF(t) − theta| ≤ unit.
struct CoqAnswer {
  Curve curve;
  Rational t;
  Decimal theta;  ///< correctly rounded
  Rational unit;  ///< one in the place of its last digit
  /// Of CoqInterval's tactic `integral`, by the distance of the poles from [0, t].
  struct Effort {
    long precision;
    long degree;
    long fuel;
  } effort;
};

/// Throws DomainError for t ≤ 0 and where A has a zero in [0, t].
CoqAnswer answer(const Curve& curve, const CoqQuery& query);

}  // namespace phrame
