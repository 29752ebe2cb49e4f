#include "phrame/ph/frame/compiled_rotation.hpp"

#include <cmath>

#include "phrame/algebra/ball_series.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/ph/curve/invariants.hpp"
#include "phrame/ph/curve/vector.hpp"
#include "phrame/ph/frame/formula_piece.hpp"
#include "phrame/ph/frame/path_frame.hpp"
#include "phrame/ph/frame/rotation_piece.hpp"
#include "phrame/ph/frame/rotation_series.hpp"

namespace phrame::inline v0 {
namespace {

// B = A/√σ·e^{iφ} with φ′ = −k/d, so that
//   dB′ = (d/σ)V·B − k·B·i = M·B,  V = b₁i + b₂j + b₃k the vector part of A′A*,
// a = (d/σ)b₁ − k,  b = (d/σ)b₂,  c = (d/σ)b₃,  d = (d/σ)b₁ + k. Of the rotation-minimizing frame
// k/d is h/σ.

/// What B of a curve is determined by: A without its real factor, σ, k and M; rotation.sigma is d.
struct FrameEquation {
  QuaternionPolynomial preimage;
  Polynomial sigma;
  Polynomial k;
  RotationEquation rotation;
  GaussianPolynomial bend = {{1}, {}};  ///< g of Frenet's frame, without real factors

  /// Of the rotation-minimizing frame.
  explicit FrameEquation(const Curve& curve)
      : FrameEquation(curve, Polynomial{1},
                      [](const QuaternionPolynomial& a) { return twist_numerator(a); }) {}

  FrameEquation(const Curve& curve, Reference reference) : FrameEquation(of(curve, reference)) {}

 private:
  /// k of A, or 0.
  using Turning = std::function<Polynomial(const QuaternionPolynomial& preimage)>;

  FrameEquation(const Curve& curve, const Polynomial& over_sigma, const Turning& turning)
      : preimage(without_real_content(curve.preimage())), sigma(phrame::sigma(preimage)) {
    if (turning) k = turning(preimage);
    const auto& [u, v, p, q] = preimage;
    const QuaternionPolynomial rate = QuaternionPolynomial{differentiate(u), differentiate(v),
                                                           differentiate(p), differentiate(q)} *
                                      QuaternionPolynomial{u, -v, -p, -q};
    const Polynomial first = over_sigma * rate.v;
    rotation = {over_sigma * sigma, first - k, over_sigma * rate.p, over_sigma * rate.q, first + k};
  }

  static FrameEquation of(const Curve& curve, Reference reference) {
    if (reference == Reference::up)
      throw DomainError("compiled frames: that of a vector v is not among them");
    return reference == Reference::frenet ? of_frenet(curve)
                                          : FrameEquation(curve, Polynomial{1}, {});
  }

  static FrameEquation of_frenet(const Curve& curve) {
    const GaussianPolynomial g = regular_bend(without_real_content(curve.preimage()));
    FrameEquation equation(curve, norm(g), [&](const QuaternionPolynomial& a) {
      return Rational(1, 2) * phrame::sigma(a) * (differentiate(g) * conjugate(g)).im;
    });
    equation.bend = g;
    return equation;
  }
};

/// The angle 2φ at a double, with a radius of about 2^−bits.
using TwicePhi = std::function<RealBall(double t, long bits)>;

/// B with φ(0) = phi_at_center, up to y^{length−1}, where d is that on the piece.
QuaternionSeries taylor_of(const FrameEquation& equation, const PolynomialPiece& piece,
                           const BallPolynomial& d, const RealBall& phi_at_center, long length) {
  const auto times = [&](const BallPolynomial& f, const BallPolynomial& g) {
    return multiply_series(f, g, length, frame_bits);
  };
  const BallPolynomial minus_phi_rate =
      divide_series(per_y(equation.k, piece, frame_bits), d, length - 1, frame_bits);
  const BallPolynomial phi =
      with_constant(-antiderivative(minus_phi_rate, frame_bits), phi_at_center);
  const BallPolynomial sigma = equation.sigma == equation.rotation.sigma
                                   ? d
                                   : on_piece(equation.sigma, piece, frame_bits, true);
  const BallPolynomial over_root = inverse_sqrt_series(sigma, length, frame_bits);  // 1/√σ
  const auto unit = cos_sin_series(phi, length, frame_bits);
  const BallPolynomial cos = times(unit.cos, over_root);
  const BallPolynomial sin = times(unit.sin, over_root);

  // (x + yi)·e^{iφ}/√σ and (x + yi)·j·e^{iφ}/√σ = (x + yi)·e^{−iφ}/√σ·j.
  const auto turned = [&](const Polynomial& re, const Polynomial& im, const BallPolynomial& sine) {
    const BallPolynomial x = on_piece(re, piece, frame_bits);
    const BallPolynomial y = on_piece(im, piece, frame_bits);
    return std::pair{subtract(times(x, cos), times(y, sine), frame_bits),
                     add(times(x, sine), times(y, cos), frame_bits)};
  };
  const auto [u, v] = turned(equation.preimage.u, equation.preimage.v, sin);
  const auto [p, q] = turned(equation.preimage.p, equation.preimage.q, -sin);
  return {u, v, p, q};
}

/// B on [low, high] for a curve with the parameter t − origin.
std::optional<PolynomialPiece> rotation_piece_of(double low, double high, double origin,
                                                 const FrameEquation& equation,
                                                 const TwicePhi& twice_phi,
                                                 const DoubleShape& shape) {
  const auto taylor = [&](const PolynomialPiece& piece, const BallPolynomial& d,
                          const RotationRates&, long length) {
    return taylor_of(equation, piece, d,
                     times_power_of_two(twice_phi(piece.center, frame_bits), -1), length);
  };
  return rotation_piece(low, high, origin, equation.rotation, taylor, shape);
}

/// θ + start, from balls around θ.
TwicePhi from_start(const TwicePhi& theta, const StartAngle& start) {
  // Absolutely, φ is to be known to about 2^−bits.
  const long more = binary_exponent(abs(start.value.enclose(64).upper()) + 2);
  return [theta, start = start.value, more](double t, long bits) {
    return add(theta(t, bits), start.enclose(bits + more), bits + more);
  };
}

/// σB′ = (H × H′)/2·B.
RotationEquation rotation_of(const RationalCurve& curve) {
  const Vector<Polynomial> rate = Polynomial{Rational(1, 2)} * binormal(curve);
  return {dot(curve.direction(), curve.direction()), rate[0], rate[1], rate[2], rate[0]};
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

/// θ + start, where it is measured from the Euler–Rodrigues frame.
TwicePhi rotation_theta(const PathAngle& angle, const StartAngle& start) {
  return from_start(
      [angle](double t, long bits) {
        return angle.enclose(locate(angle.path(), exact_rational(t)), bits);
      },
      start);
}

/// The pieces of B along the segments of a path.
class PathRotation {
 public:
  PathRotation(const PathAngle& angle, const StartAngle& start, const DoubleShape& shape)
      : angle_(angle), start_(start), theta_(rotation_theta(angle, start)), shape_(shape) {}

  std::optional<PolynomialPiece> piece(std::size_t k, double low, double high) {
    const auto joint = static_cast<double>(k);
    const Segment& segment = angle_.path().segments()[k];
    if (angle_.reference() == Reference::euler_rodrigues) {
      if (!erf_ || erf_->first != k) erf_.emplace(k, FrameEquation(*ph_curve(segment)));
      return rotation_piece_of(low, high, joint, erf_->second, theta_, shape_);
    }
    if (const RationalCurve* curve = rational_curve(segment)) {
      if (!general_ || general_->first != k) general_.emplace(k, rotation_of(*curve));
      return general_piece(general_->second, low, high, joint);
    }
    return formula_rotation_piece(low, high, joint, std::get<ExpressionCurve>(segment), at_center(),
                                  shape_);
  }

 private:
  /// B there.
  std::function<std::array<RealBall, 4>(double t, long bits)> at_center() const {
    return [this](double t, long bits) {
      const Place at = locate(angle_.path(), exact_rational(t));
      return quaternion_of(rotation_minimizing_frame(angle_, at, start_), bits);
    };
  }

  std::optional<PolynomialPiece> general_piece(const RotationEquation& equation, double low,
                                               double high, double joint) const {
    const auto taylor = [&](const PolynomialPiece& piece, const BallPolynomial& sigma,
                            const RotationRates& M, long length) {
      return rotation_series(at_center()(piece.center, frame_bits), {M[0], M[1], M[2]}, sigma,
                             length, frame_bits);
    };
    return rotation_piece(low, high, joint, equation, taylor, shape_);
  }

  PathAngle angle_;
  StartAngle start_;
  TwicePhi theta_;
  DoubleShape shape_;
  // What was made for the last segment.
  std::optional<std::pair<std::size_t, FrameEquation>> erf_;
  std::optional<std::pair<std::size_t, RotationEquation>> general_;
};

}  // namespace

PiecewisePolynomial compiled_rotation(const Curve& curve, const RmfAngle& angle,
                                      const FrameAngle& start_angle, double from, double to,
                                      const DoubleShape& shape) {
  const FrameEquation equation(curve);
  const TwicePhi theta = from_start(
      [&](double t, long bits) { return angle.enclose(exact_rational(t), bits); }, start_angle);
  return {from, to, shape, [&](double low, double high) {
            return rotation_piece_of(low, high, 0, equation, theta, shape);
          }};
}

PiecewisePolynomial compiled_rotation(const PathAngle& angle, const StartAngle& start_angle,
                                      const DoubleShape& shape) {
  PathRotation rotation(angle, start_angle, shape);
  const auto make = [&](double low, double high) {
    return rotation.piece(static_cast<std::size_t>(std::floor(low)), low, high);
  };
  return PiecewisePolynomial::on_units(angle.path().segments().size(), shape, make);
}

PiecewisePolynomial compiled_rotation(const PathAngle& angle, std::size_t segment,
                                      const StartAngle& start_angle, const DoubleShape& shape) {
  PathRotation rotation(angle, start_angle, shape);
  const auto joint = static_cast<double>(segment);
  return {joint, joint + 1, shape,
          [&](double low, double high) { return rotation.piece(segment, low, high); }};
}

PiecewisePolynomial compiled_rotation(const Curve& curve, Reference reference, double from,
                                      double to, double origin, const DoubleShape& shape) {
  const FrameEquation equation(curve, reference);
  const TwicePhi minus_arg_bend = [&](double t, long bits) {
    const Rational at = exact_rational(t) - exact_rational(origin);
    return subtract({}, argument(equation.bend.re(at), equation.bend.im(at), bits), bits);
  };
  return {from, to, shape, [&](double low, double high) {
            return rotation_piece_of(low, high, origin, equation, minus_arg_bend, shape);
          }};
}

}  // namespace phrame
