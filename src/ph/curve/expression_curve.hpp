#pragma once
#include <array>
#include <memory>
#include <optional>
#include <string>

#include "phrame/algebra/shared.hpp"
#include "phrame/ph/curve/formula_evaluation.hpp"
#include "phrame/ph/curve/quaternion.hpp"

namespace phrame {

class KnownIntegrals;

/// A curve r(s) by three formulas, s from a to b, with the parameter t ∈ [0, 1], s = a + (b − a)t.
/// It is defined, analytic and regular, r′ ≠ 0, on the whole path: proved when it is made. H is r′,
/// and e₁ the unit tangent, unless it is turned over.
class ExpressionCurve {
 public:
  /// Throws DomainError where an end is no constant or is undefined, the two ends are equal, a
  /// formula is undefined, as by a pole, at a place that is named, or the curve has a cusp there or
  /// is a point; Undecided where that is not told within parts of 2^−40 of the path.
  ExpressionCurve(Vector<Formula> position, Formula from, Formula to, std::string variable = "s");

  const Vector<Formula>& position() const { return position_; }  ///< r
  const Formula& from() const { return from_; }                  ///< a
  const Formula& to() const { return to_; }                      ///< b
  const std::string& variable() const { return variable_; }      ///< what s is called
  int orientation() const { return orientation_; }  ///< 1, or −1 where e₁ = −r′/|r′|

  /// The same curve with −H for H, whose e₁ is reversed.
  ExpressionCurve turned_over() const;
  /// dⁿr/dsⁿ, n ≤ 3; found once for all copies.
  const Vector<Formula>& derivative(std::size_t order) const;

  /// s at t.
  RealBall parameter(const RealBall& t, long bits) const;
  /// All steps of the components, each once, and which of them are the components.
  const FormulaProgram& program() const { return program_; }
  /// The steps that are the components.
  const Vector<std::size_t>& components() const { return components_; }

  /// What was found of integrals along it, for all copies.
  KnownIntegrals& known_integrals() const { return *known_integrals_; }

  /// The Taylor series of r around t in z, where the parameter is t + scale·z.
  Vector<BallPolynomial> series(const RealBall& t, const Rational& scale, long length,
                                long bits) const;
  /// The same around every point of a disc; not finite where any step is not seen to be analytic
  /// there.
  Vector<ComplexSeries> series(const ComplexBall& t, const Rational& scale, long length,
                               long bits) const;

  /// The same formulas, ends and orientation.
  friend bool operator==(const ExpressionCurve& a, const ExpressionCurve& b);

 private:
  Vector<Formula> position_;
  Formula from_;
  Formula to_;
  std::string variable_;
  FormulaProgram program_;
  Vector<std::size_t> components_{};
  int orientation_ = 1;
  std::array<Lazy<Vector<Formula>>, 3> derivatives_;  ///< r′, r″, r‴ by s
  std::shared_ptr<KnownIntegrals> known_integrals_;
};

/// A point or a direction at a parameter of an expression curve, as steps of a program that several
/// may share: where two steps are the same, so are the numbers.
using ExactVector = Vector<std::size_t>;
/// @{ dⁿr/dsⁿ for n ≤ 3, r, and dr/ds or its opposite, along H, at a rational t, put into the
/// program.
ExactVector exact_derivative(const ExpressionCurve& curve, std::size_t order, const Rational& t,
                             FormulaProgram& program);
ExactVector exact_point(const ExpressionCurve& curve, const Rational& t, FormulaProgram& program);
ExactVector exact_direction(const ExpressionCurve& curve, const Rational& t,
                            FormulaProgram& program);
/// @}
/// 1 where s grows with t, −1 where it falls.
int direction_of_parameter(const ExpressionCurve& curve);

/// Are the two vectors equal? Decided where they have the same form or are rational, else by balls
/// of up to so many bits; no value where they are equal to all these bits.
std::optional<bool> are_equal(const FormulaProgram& program, const ExactVector& a,
                              const ExactVector& b, long most_bits = 1024);
/// Are they positive multiples of each other? Likewise. Neither is 0.
std::optional<bool> have_same_direction(const FormulaProgram& program, const ExactVector& a,
                                        const ExactVector& b, long most_bits = 1024);

}  // namespace phrame
