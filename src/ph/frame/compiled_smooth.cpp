#include "phrame/ph/frame/compiled_smooth.hpp"

#include <cmath>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/ph/along/rational_rates.hpp"
#include "phrame/ph/curve/curve_integrands.hpp"
#include "phrame/ph/curve/direction_span.hpp"
#include "phrame/ph/curve/vector.hpp"
#include "phrame/ph/frame/angle_piece.hpp"
#include "phrame/ph/frame/formula_piece.hpp"
#include "phrame/ph/frame/rotation_piece.hpp"
#include "phrame/ph/frame/rotation_series.hpp"
#include "phrame/ph/frame/smooth_frame.hpp"

namespace phrame {
namespace {

Place at_double(const Path& path, double t) { return locate(path, exact_rational(t)); }

/// σB′ = (H × H′)/2·B.
RotationEquation rotation_of(const RationalCurve& curve) {
  const Vector<Polynomial>& H = curve.direction();
  const Vector<Polynomial> slope{differentiate(H[0]), differentiate(H[1]), differentiate(H[2])};
  const Vector<Polynomial> rate = Polynomial{Rational(1, 2)} * cross(H, slope);
  return {dot(H, H), rate[0], rate[1], rate[2], rate[0]};
}

/// One of the two unit quaternions of the rotation that takes the axes to the frame. The components
/// are R₃₂ − R₂₃ and so on over four times the one that is not small.
std::array<RealBall, 4> quaternion_of(const Frame<Real>& frame, long bits) {
  const std::array<Vector<Real>, 3> columns{frame.e1, frame.e2, frame.e3};
  std::array<std::array<RealBall, 3>, 3> R;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) R[i][j] = columns[j][i].enclose(bits);
  const auto plus = [&](const RealBall& a, const RealBall& b) { return add(a, b, bits); };
  const auto minus = [&](const RealBall& a, const RealBall& b) { return subtract(a, b, bits); };
  const RealBall one(1, bits);
  // Four times their squares: 1 ± R₁₁ ± R₂₂ ± R₃₃.
  const std::array<RealBall, 4> squares{plus(plus(one, R[0][0]), plus(R[1][1], R[2][2])),
                                        minus(plus(one, R[0][0]), plus(R[1][1], R[2][2])),
                                        minus(plus(one, R[1][1]), plus(R[0][0], R[2][2])),
                                        minus(plus(one, R[2][2]), plus(R[0][0], R[1][1]))};
  std::size_t largest = 0;
  for (std::size_t k = 1; k < 4; ++k)
    if (approximate(squares[k]) > approximate(squares[largest])) largest = k;
  // Products of two components, times four.
  const std::array<RealBall, 3> with_u{minus(R[2][1], R[1][2]), minus(R[0][2], R[2][0]),
                                       minus(R[1][0], R[0][1])};
  const auto product = [&](std::size_t i, std::size_t j) {
    if (i == j) return squares[i];
    if (i > j) std::swap(i, j);
    return i == 0 ? with_u[j - 1] : plus(R[i - 1][j - 1], R[j - 1][i - 1]);
  };
  const RealBall twice = sqrt(squares[largest], bits);
  std::array<RealBall, 4> b;
  for (std::size_t k = 0; k < 4; ++k)
    b[k] = times_power_of_two(divide(product(largest, k), twice, bits), -1);
  return b;
}

/// Adds what is not 0 all along of e₁ and, where `is_up`, of the frame of v.
void clear_zeros(CompiledFrames::Zeros& zeros, const std::vector<Vector<Polynomial>>& frame,
                 bool is_up) {
  for (std::size_t j = 0; j < 3; ++j)
    for (std::size_t k = 0; k < 3; ++k)
      zeros[j][k] = zeros[j][k] && (j == 0 || is_up) && frame[j][k].is_zero();
}

Vector<Polynomial> as_polynomials(const Vector<Rational>& v) {
  return {Polynomial{v[0]}, Polynomial{v[1]}, Polynomial{v[2]}};
}

/// Of H: what multiples of the three vectors are.
std::vector<Vector<Polynomial>> frame_of(const Vector<Polynomial>& H, const Vector<Polynomial>& v) {
  const Vector<Polynomial> second = cross(v, H);
  return {H, second, cross(H, second)};
}

/// What is 0 all along: of e₁, and in a plane with its normal for v.
CompiledFrames::Zeros known_zeros(const SmoothAngle& angle, const Real& start) {
  CompiledFrames::Zeros zeros;
  for (auto& of_vector : zeros) of_vector.fill(true);
  const bool is_up = angle.is_zero() && start.exact() == Rational(0);
  const Vector<Polynomial> up = as_polynomials(angle.up());
  for (const Segment& segment : angle.path().segments()) {
    if (const RationalCurve* curve = rational_curve(segment)) {
      clear_zeros(zeros, frame_of(curve->direction(), up), is_up);
      continue;
    }
    for (const Vector<Rational>& direction : direction_span(segment))
      clear_zeros(zeros, frame_of(as_polynomials(direction), up),
                  is_up && dot(angle.up(), direction) == 0);
  }
  return zeros;
}

/// θ′ of a segment, as it is compiled.
using CompiledRate = std::variant<RootQuotient, CurveIntegrand>;

CompiledRate rate_of(const SmoothAngle& angle, const Segment& segment) {
  const bool is_up = angle.reference() == SmoothReference::up;
  if (const RationalCurve* curve = rational_curve(segment))
    return TaylorIntegral(is_up ? up_frame_turning(*curve, angle.up()) : frenet_turning(*curve))
        .integrand();
  const CurveIntegrand rate = is_up ? up_frame_rate(angle.up()) : torsion_rate();
  return orientation(segment) > 0 ? negative(rate) : rate;
}

std::optional<RotationEquation> equation_of(const Segment& segment) {
  const RationalCurve* curve = rational_curve(segment);
  return curve == nullptr ? std::nullopt : std::optional(rotation_of(*curve));
}

}  // namespace

PiecewisePolynomial compiled_angle(const SmoothAngle& angle, const Real& start,
                                   const DoubleShape& shape) {
  const auto& segments = angle.path().segments();
  std::vector<CompiledRate> rates;
  for (const Segment& segment : segments) rates.push_back(rate_of(angle, segment));
  const auto theta = [&](double t, long bits) {
    return add(angle.value(at_double(angle.path(), t)).enclose(bits), start.enclose(bits), bits);
  };
  const auto make = [&](double low, double high) {
    const double joint = std::floor(low);
    const auto k = static_cast<std::size_t>(joint);
    if (const auto* rate = std::get_if<RootQuotient>(&rates[k]))
      return angle_piece(low, high, joint, *rate, theta, shape);
    if (angle.is_zero()) return angle_piece(low, high, joint, RootQuotient{}, theta, shape);
    return formula_angle_piece(low, high, joint, std::get<ExpressionCurve>(segments[k]),
                               std::get<CurveIntegrand>(rates[k]), theta, shape);
  };
  return PiecewisePolynomial::on_units(segments.size(), shape, make);
}

PiecewisePolynomial compiled_rotation(const SmoothAngle& angle, const Real& start,
                                      const DoubleShape& shape) {
  const auto& segments = angle.path().segments();
  std::vector<std::optional<RotationEquation>> equations;
  for (const Segment& segment : segments) equations.push_back(equation_of(segment));
  const auto at_center = [&](double t, long bits) {
    return quaternion_of(rotation_minimizing_frame(angle, at_double(angle.path(), t), start), bits);
  };
  const auto make = [&](double low, double high) {
    const double joint = std::floor(low);
    const auto k = static_cast<std::size_t>(joint);
    if (!equations[k])
      return formula_rotation_piece(low, high, joint, std::get<ExpressionCurve>(segments[k]),
                                    at_center, shape);
    const RotationEquation& equation = *equations[k];
    const auto taylor = [&](const PolynomialPiece& piece, const BallPolynomial& sigma,
                            long length) {
      constexpr long bits = frame_bits + 32;
      const Vector<BallPolynomial> rate{per_y(equation.a, piece, frame_bits),
                                        per_y(equation.b, piece, frame_bits),
                                        per_y(equation.c, piece, frame_bits)};
      return rotation_series(at_center(piece.center, bits), rate, sigma, length, bits);
    };
    return rotation_piece(low, high, joint, equation, taylor, shape);
  };
  return PiecewisePolynomial::on_units(segments.size(), shape, make);
}

CompiledAngle compile_angle(const SmoothAngle& angle, const Real& start) {
  const auto exact = [angle, start](const Rational& t) {
    return angle.value(locate(angle.path(), t)) + start;
  };
  return {exact, compiled_angle(angle, start, compensated_shape(1))};
}

CompiledFrames compile_frames(const SmoothAngle& angle, const Real& start) {
  return {compiled_rotation(angle, start, compensated_shape(4)), known_zeros(angle, start)};
}

}  // namespace phrame
