#include "phrame/ph/smooth/compiled_smooth.hpp"

#include <cmath>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/ph/curve/vector.hpp"
#include "phrame/ph/frame/angle_piece.hpp"
#include "phrame/ph/frame/rotation_piece.hpp"
#include "phrame/ph/smooth/rational_rates.hpp"
#include "phrame/ph/smooth/smooth_frame.hpp"

namespace phrame {
namespace {

std::vector<RationalCurve> rational_curves(const SmoothPath& path) {
  std::vector<RationalCurve> curves;
  for (const SmoothSegment& segment : path.segments()) {
    const auto* curve = std::get_if<RationalCurve>(&segment);
    if (curve == nullptr)
      throw DomainError("compiled: curves by formulas are not compiled, only rational ones");
    curves.push_back(*curve);
  }
  return curves;
}

SmoothParameter at_double(const SmoothPath& path, double t) {
  return locate(path, exact_rational(t));
}

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

/// M of the equation, times x.
std::array<RealBall, 4> turned_by(const std::array<RealBall, 3>& w,
                                  const std::array<RealBall, 4>& x, long bits) {
  const auto sum = [&](std::size_t i, int sign_i, std::size_t j, int sign_j, std::size_t k,
                       int sign_k) {
    RealBall value;
    const std::array<std::pair<std::size_t, int>, 3> terms{
        std::pair{i, sign_i}, {j, sign_j}, {k, sign_k}};
    for (std::size_t n = 0; n < 3; ++n) {
      const RealBall term = multiply(w[n], x[terms[n].first], bits);
      value = terms[n].second > 0 ? add(value, term, bits) : subtract(value, term, bits);
    }
    return value;
  };
  return {sum(1, -1, 2, -1, 3, -1), sum(0, 1, 3, 1, 2, -1), sum(3, -1, 0, 1, 1, 1),
          sum(2, 1, 1, -1, 0, 1)};
}

/// By the recurrence that the equation gives, from B at y = 0.
QuaternionSeries series_from(const std::array<RealBall, 4>& at_center,
                             const RotationEquation& equation, const PolynomialPiece& piece,
                             const BallPolynomial& sigma, long length) {
  constexpr long bits = frame_bits + 32;
  const std::array<BallPolynomial, 3> rate{per_y(equation.a, piece, frame_bits),
                                           per_y(equation.b, piece, frame_bits),
                                           per_y(equation.c, piece, frame_bits)};
  std::vector<std::array<RealBall, 4>> b{at_center};
  for (long n = 0; n + 1 < length; ++n) {
    // (n + 1)·σ₀·Bₙ₊₁ = Σ Mⱼ·Bₙ₋ⱼ − Σ (n + 1 − i)·σᵢ·Bₙ₊₁₋ᵢ, i ≥ 1.
    std::array<RealBall, 4> next{};
    for (long j = 0; j <= n; ++j) {
      const auto turn =
          turned_by({rate[0].coefficient(j), rate[1].coefficient(j), rate[2].coefficient(j)},
                    b[static_cast<std::size_t>(n - j)], bits);
      const RealBall weight = multiply(RealBall(n - j, bits), sigma.coefficient(j + 1), bits);
      for (std::size_t k = 0; k < 4; ++k) {
        next[k] = add(next[k], turn[k], bits);
        next[k] =
            subtract(next[k], multiply(weight, b[static_cast<std::size_t>(n - j)][k], bits), bits);
      }
    }
    const RealBall over = multiply(RealBall(n + 1, bits), sigma.coefficient(0), bits);
    for (RealBall& x : next) x = divide(x, over, bits);
    b.push_back(next);
  }
  QuaternionSeries series;
  for (std::size_t k = 0; k < 4; ++k) {
    std::vector<RealBall> coefficients;
    for (const auto& of_y : b) coefficients.push_back(of_y[k]);
    series[k] = BallPolynomial(coefficients);
  }
  return series;
}

/// What is 0 all along: of e₁, and in a plane with its normal for v.
CompiledFrames::Zeros known_zeros(const SmoothAngle& angle, const Real& start) {
  CompiledFrames::Zeros zeros;
  for (auto& of_vector : zeros) of_vector.fill(true);
  const bool is_up = angle.is_zero() && start.exact() == Rational(0);
  const Vector<Rational>& v = angle.up();
  const Vector<Polynomial> up{Polynomial{v[0]}, Polynomial{v[1]}, Polynomial{v[2]}};
  for (const RationalCurve& curve : rational_curves(angle.path())) {
    const Vector<Polynomial>& H = curve.direction();
    const Vector<Polynomial> second = cross(up, H);
    const Vector<Polynomial> third = cross(H, second);
    for (std::size_t k = 0; k < 3; ++k) {
      zeros[0][k] = zeros[0][k] && H[k].is_zero();
      zeros[1][k] = zeros[1][k] && is_up && second[k].is_zero();
      zeros[2][k] = zeros[2][k] && is_up && third[k].is_zero();
    }
  }
  return zeros;
}

}  // namespace

PiecewisePolynomial compiled_angle(const SmoothAngle& angle, const Real& start,
                                   const DoubleShape& shape) {
  const SmoothPath& path = angle.path();
  std::vector<RootQuotient> rates;
  for (const RationalCurve& curve : rational_curves(path))
    rates.push_back(TaylorIntegral(angle.reference() == SmoothReference::up
                                       ? up_frame_turning(curve, angle.up())
                                       : frenet_turning(curve))
                        .integrand());
  const auto theta = [&](double t, long bits) {
    return add(angle.value(at_double(path, t)).enclose(bits), start.enclose(bits), bits);
  };
  const auto make = [&](double low, double high) {
    const double joint = std::floor(low);
    return angle_piece(low, high, joint, rates[static_cast<std::size_t>(joint)], theta, shape);
  };
  return PiecewisePolynomial::on_units(rates.size(), shape, make);
}

PiecewisePolynomial compiled_rotation(const SmoothAngle& angle, const Real& start,
                                      const DoubleShape& shape) {
  const SmoothPath& path = angle.path();
  std::vector<RotationEquation> equations;
  for (const RationalCurve& curve : rational_curves(path)) equations.push_back(rotation_of(curve));
  const auto make = [&](double low, double high) {
    const double joint = std::floor(low);
    const RotationEquation& equation = equations[static_cast<std::size_t>(joint)];
    const auto taylor = [&](const PolynomialPiece& piece, const BallPolynomial& sigma,
                            long length) {
      const Frame<Real> frame =
          rotation_minimizing_frame(angle, at_double(path, piece.center), start);
      return series_from(quaternion_of(frame, frame_bits + 32), equation, piece, sigma, length);
    };
    return rotation_piece(low, high, joint, equation, taylor, shape);
  };
  return PiecewisePolynomial::on_units(equations.size(), shape, make);
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
