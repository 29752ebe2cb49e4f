#pragma once
#include <memory>
#include <string>

#include "phrame/algebra/ball.hpp"
#include "phrame/export.hpp"
#include "phrame/ph/curve/formula.hpp"
#include "phrame/ph/curve/quaternion.hpp"

namespace phrame::inline v0 {

class BallPolynomial;
class ComplexSeries;
class FormulaProgram;
class KnownIntegrals;

/// A curve r(s) by three formulas, s from a to b, with the parameter t ∈ [0, 1], s = a + (b − a)t.
/// It is defined, analytic and regular, r′ ≠ 0, on the whole path: proved when it is made. H is r′,
/// and e₁ the unit tangent, unless it is turned over. Copies share what is found; to move one is to
/// copy it.
class PHRAME_API ExpressionCurve {
 public:
  /// Throws DomainError where an end is no constant or is undefined, the two ends are equal, a
  /// formula is undefined, as by a pole, at a place that is named, or the curve has a cusp there or
  /// is a point; Undecided where that is not told within parts of 2^−40 of the path.
  ExpressionCurve(Vector<Formula> position, Formula from, Formula to, std::string variable = "s");
  ExpressionCurve(const ExpressionCurve&) = default;
  ExpressionCurve& operator=(const ExpressionCurve&) = default;
  ~ExpressionCurve() = default;

  const Vector<Formula>& position() const;          ///< r
  const Formula& from() const;                      ///< a
  const Formula& to() const;                        ///< b
  const std::string& variable() const;              ///< what s is called
  int orientation() const { return orientation_; }  ///< 1, or −1 where e₁ = −r′/|r′|

  /// The same curve with −H for H, whose e₁ is reversed.
  ExpressionCurve turned_over() const;
  /// dⁿr/dsⁿ, n ≤ 3; found once for all copies.
  const Vector<Formula>& derivative(std::size_t order) const;

  /// s at t.
  RealBall parameter(const RealBall& t, long bits) const;
  /// All steps of the components, each once, and which of them are the components.
  const FormulaProgram& program() const;
  /// The steps that are the components.
  const Vector<std::size_t>& components() const;

  /// What was found of integrals along it, for all copies.
  KnownIntegrals& known_integrals() const;

  /// The Taylor series of r around t in z, where the parameter is t + scale·z.
  Vector<BallPolynomial> series(const RealBall& t, const Rational& scale, long length,
                                long bits) const;
  /// The same around every point of a disc; not finite where any step is not seen to be analytic
  /// there.
  Vector<ComplexSeries> series(const ComplexBall& t, const Rational& scale, long length,
                               long bits) const;

  /// The same formulas, ends and orientation.
  friend PHRAME_API bool operator==(const ExpressionCurve& a, const ExpressionCurve& b);

 private:
  struct State;

  std::shared_ptr<State> state_;
  int orientation_ = 1;
};

/// 1 where s grows with t, −1 where it falls.
PHRAME_API int direction_of_parameter(const ExpressionCurve& curve);

}  // namespace phrame
