#pragma once
#include <optional>
#include <variant>

#include "phrame/integrate/absolute_integral.hpp"
#include "phrame/ph/along/expression_integral.hpp"
#include "phrame/ph/curve/path.hpp"

namespace phrame::inline v0 {

/// A polynomial y and its integral from 0.
struct PolynomialIntegral {
  Polynomial integral;  ///< ∫₀ᵗ y
  Polynomial rate;      ///< y
};

/// t ↦ ∫₀ᵗ y dt along a segment of any kind, t in [0, 1], to any number of digits. Copies are cheap
/// and share what was found; any thread may ask.
class SegmentIntegral {
 public:
  /// How it is found: of a polynomial, of N/(D√S), of its size, of an analytic function of
  /// formulas.
  using Form =
      std::variant<PolynomialIntegral, TaylorIntegral, AbsoluteIntegral, ExpressionIntegral>;
  /// The integral found in this way.
  SegmentIntegral(Form form)  // NOLINT(google-explicit-constructor)
      : form_(std::move(form)) {}

  /// Is y seen to be 0 all along?
  bool is_zero() const;
  /// A ball around the integral up to t, which shrinks as bits grow.
  RealBall enclose(const Real& t, long bits) const;
  /// y on a ball of t.
  RealBall rate(const RealBall& t, long bits) const;
  /// The integral up to t, exact where it is seen to be rational.
  Real value(const Real& t) const;
  /// The same as a sum of square roots, where it is seen to be one.
  std::optional<Surd> algebraic_value(const Rational& t) const;

 private:
  Form form_;
};

/// Along the segments by formulas: what is to be found of these on one walk
/// (expression_integral.hpp), as far as it is not 0 by their form.
void find_together(const Path& path, const std::vector<CurveIntegrand>& integrands);

/// Of a path so many are kept at a time, the last ones: each takes some kilobytes.
inline constexpr std::size_t most_kept_integrals = 1024;
/// To so many bits at least the terms of a sum are known: 17 digits of it take hardly more.
inline constexpr long first_bits_of_sums = 88;

/// @{ θ of the rotation-minimizing frame to the frame of v, which is nowhere along the tangent, and
/// to the Frenet frame (rational_rates.hpp). That is continued through the inflections of rational
/// curves and of plane ones; where else a curve by formulas has one, DomainError or Undecided is
/// thrown. Throws DomainError for the Frenet frame of a straight line.
SegmentIntegral up_frame_angle(const Segment& segment, const Vector<Rational>& v);
SegmentIntegral frenet_angle(const Segment& segment);
/// @}
/// The arc length ∫ |r′| dt, a polynomial where that of a PH curve is one.
SegmentIntegral arc_length(const Segment& segment);
/// ∫ κ ds. Of a curve by formulas enclose() throws Undecided where it takes too many parts.
SegmentIntegral bending_angle(const Segment& segment);

}  // namespace phrame
