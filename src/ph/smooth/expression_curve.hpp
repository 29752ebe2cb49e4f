#pragma once
#include <optional>
#include <string>

#include "phrame/ph/curve/quaternion.hpp"
#include "phrame/ph/smooth/formula_evaluation.hpp"

namespace phrame {

/// A curve r(s) by three formulas, s from a to b, with the parameter t ∈ [0, 1], s = a + (b − a)t.
/// It is defined, analytic and regular, r′ ≠ 0, on the whole path: proved when it is made.
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

  /// s at t.
  RealBall parameter(const RealBall& t, long bits) const;
  /// All steps of the components, each once, and which of them are the components.
  const FormulaProgram& program() const { return program_; }
  /// The steps that are the components.
  const Vector<std::size_t>& components() const { return components_; }

  /// The Taylor series of r around t in z, where the parameter is t + scale·z.
  Vector<BallPolynomial> series(const RealBall& t, const Rational& scale, long length,
                                long bits) const;
  /// The same around every point of a disc; not finite where any step is not seen to be analytic
  /// there.
  Vector<ComplexSeries> series(const ComplexBall& t, const Rational& scale, long length,
                               long bits) const;

 private:
  Vector<Formula> position_;
  Formula from_;
  Formula to_;
  std::string variable_;
  FormulaProgram program_;
  Vector<std::size_t> components_{};
};

/// A point or a direction at a parameter of an expression curve, as steps of a program that several
/// may share: where two steps are the same, so are the numbers.
using ExactVector = Vector<std::size_t>;
/// @{ r and dr/ds·sign(b − a), along dr/dt, at a rational t, put into the program.
ExactVector exact_point(const ExpressionCurve& curve, const Rational& t, FormulaProgram& program);
ExactVector exact_direction(const ExpressionCurve& curve, const Rational& t,
                            FormulaProgram& program);
/// @}

/// Are the two vectors equal? By their form, and where that is not the same by balls of up to so
/// many bits; no value where they are equal to all these bits.
std::optional<bool> are_equal(const FormulaProgram& program, const ExactVector& a,
                              const ExactVector& b, long most_bits = 1024);
/// Are they positive multiples of each other? Likewise. Neither is 0.
std::optional<bool> have_same_direction(const FormulaProgram& program, const ExactVector& a,
                                        const ExactVector& b, long most_bits = 1024);

}  // namespace phrame
