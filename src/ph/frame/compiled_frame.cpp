#include "phrame/ph/frame/compiled_frame.hpp"

#include <cmath>

#include "phrame/algebra/ball_powers.hpp"
#include "phrame/algebra/ball_series.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/algebra/progress.hpp"
#include "phrame/algebra/ring_ball.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/ph/curve/invariants.hpp"
#include "phrame/ph/curve/shape.hpp"
#include "phrame/ph/curve/vector.hpp"
#include "phrame/ph/frame/rational_frame.hpp"
#include "phrame/ph/frame/rotation_piece.hpp"

namespace phrame {
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

  FrameEquation(const Curve& curve, Reference reference)
      : FrameEquation(reference == Reference::frenet ? of_frenet(curve)
                                                     : FrameEquation(curve, Polynomial{1}, {})) {}

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
  const auto taylor = [&](const PolynomialPiece& piece, const BallPolynomial& d, long length) {
    return taylor_of(equation, piece, d,
                     times_power_of_two(twice_phi(piece.center, frame_bits), -1), length);
  };
  return rotation_piece(low, high, origin, equation.rotation, taylor, shape);
}

/// θ + start, from balls around θ.
TwicePhi from_start(const TwicePhi& theta, const FrameAngle& start) {
  // Absolutely, φ is to be known to about 2^−bits.
  const Rational size_of_start = abs(start.radians) + 4 * abs(start.half_turns) + 2;
  const long more = binary_exponent(size_of_start);
  return [theta, start = to_real(start), more](double t, long bits) {
    return add(theta(t, bits), start.enclose(bits + more), bits + more);
  };
}

TwicePhi theta_of(const PathAngle& angle, const FrameAngle& start) {
  return from_start(
      [angle](double t, long bits) {
        return angle.enclose(locate(angle.path(), exact_rational(t)), bits);
      },
      start);
}

// f₂ of a rotation-minimizing frame has a component that is 0 everywhere on plane curves only: of
// f₂·k = 0 the derivative is f₂′·k = 0, where f₂′ is along e₁, so that either e₁·k = 0 or f₂ is
// constant, the normal of a plane. There the frames are rational, of a degree ≤ 2·degree(B), so
// that one that is 0 at so many t and one more is 0.

/// Which components of the frames at(frames, t) are 0 for all t: decided exactly.
template <class At>
std::array<std::array<bool, 3>, 3> frame_zeros(const Curve& curve, const At& at) {
  const QuaternionPolynomial a = without_real_content(curve.preimage());
  const Vector<Polynomial> tangent = rotated_i(a);
  std::array<std::array<bool, 3>, 3> zeros{};
  for (std::size_t k = 0; k < 3; ++k) zeros[0][k] = tangent[k].is_zero();
  if (!plane_normal(a)) return zeros;
  const auto rational = rational_frame(a);
  const auto* found = std::get_if<RationalFrame>(&rational);
  if (found == nullptr) return zeros;
  zeros[1].fill(true);
  zeros[2].fill(true);
  const Frames frames(curve);
  const long points = 2 * degree(found->preimage) + 1;
  for (long n = 0; n < points; ++n) {
    const Frame<Real> frame = at(frames, Rational(n, points));
    for (std::size_t k = 0; k < 3; ++k) {
      zeros[1][k] = zeros[1][k] && frame.e2[k].exact() == Rational(0);
      zeros[2][k] = zeros[2][k] && frame.e3[k].exact() == Rational(0);
    }
  }
  return zeros;
}

/// The same of the Euler–Rodrigues frame or of Frenet's.
std::array<std::array<bool, 3>, 3> frame_zeros(const Curve& curve, Reference reference) {
  const QuaternionPolynomial a = without_real_content(curve.preimage());
  const GaussianPolynomial g =
      reference == Reference::frenet ? regular_bend(a) : GaussianPolynomial{{1}, {}};
  const Vector<Polynomial> j = rotated_j(a);
  const Vector<Polynomial> k = rotated_k(a);
  const std::array multiples{rotated_i(a), g.re * j - g.im * k, g.im * j + g.re * k};
  std::array<std::array<bool, 3>, 3> zeros{};
  for (std::size_t n = 0; n < 3; ++n)
    for (std::size_t i = 0; i < 3; ++i) zeros[n][i] = multiples[n][i].is_zero();
  return zeros;
}

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

PiecewisePolynomial compiled_rotation(const PathAngle& angle, const FrameAngle& start_angle,
                                      const DoubleShape& shape) {
  const std::vector<FrameEquation> equations(angle.path().segments().begin(),
                                             angle.path().segments().end());
  const TwicePhi theta = theta_of(angle, start_angle);
  const auto make = [&](double low, double high) {
    const double joint = std::floor(low);
    const FrameEquation& equation = equations[static_cast<std::size_t>(joint)];
    return rotation_piece_of(low, high, joint, equation, theta, shape);
  };
  return PiecewisePolynomial::on_units(equations.size(), shape, make);
}

PiecewisePolynomial compiled_rotation(const PathAngle& angle, std::size_t segment,
                                      const FrameAngle& start_angle, const DoubleShape& shape) {
  const FrameEquation equation(angle.path().segments()[segment]);
  const TwicePhi theta = theta_of(angle, start_angle);
  const auto joint = static_cast<double>(segment);
  return {joint, joint + 1, shape, [&](double low, double high) {
            return rotation_piece_of(low, high, joint, equation, theta, shape);
          }};
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

double frame_error(double error) { return sum_up(2 * error, 2 * error * error); }

CompiledFrames::CompiledFrames(const Curve& curve, const RmfAngle& angle, double from, double to,
                               const FrameAngle& start_angle)
    : CompiledFrames(compiled_rotation(curve, angle, start_angle, from, to, compensated_shape(4)),
                     zeros(curve, angle, start_angle)) {}

CompiledFrames::CompiledFrames(const PathAngle& angle, const FrameAngle& start_angle)
    : CompiledFrames(compiled_rotation(angle, start_angle, compensated_shape(4)),
                     zeros(angle, start_angle)) {}

CompiledFrames::CompiledFrames(const PathAngle& angle, std::size_t segment,
                               const FrameAngle& start_angle)
    : CompiledFrames(compiled_rotation(angle, segment, start_angle, compensated_shape(4)),
                     zeros(angle, segment, start_angle)) {}

CompiledFrames::CompiledFrames(const Curve& curve, Reference reference, double from, double to,
                               double origin)
    : CompiledFrames(compiled_rotation(curve, reference, from, to, origin, compensated_shape(4)),
                     frame_zeros(curve, reference)) {}

CompiledFrames::CompiledFrames(PiecewisePolynomial polynomials, const Zeros& zeros)
    : polynomials_(std::move(polynomials)), zeros_(zeros) {
  // Far more than the operations on pairs of doubles are off by, and than rounding leaves.
  for (const PolynomialPiece& piece : polynomials_.pieces())
    if (!(frame_error(piece.error) <= 0x1p-60))
      throw Undecided("compiled frames: the polynomials are not exact enough");
}

CompiledFrames::Zeros CompiledFrames::zeros(const Curve& curve, const RmfAngle& angle,
                                            const FrameAngle& start_angle) {
  return frame_zeros(curve, [&](const Frames& frames, const Rational& t) {
    return frames.rotation_minimizing(angle, t, start_angle);
  });
}

CompiledFrames::Zeros CompiledFrames::zeros(const PathAngle& angle, std::size_t segment,
                                            const FrameAngle& start) {
  return frame_zeros(angle.path().segments()[segment],
                     [&](const Frames& frames, const Rational& t) {
                       const PathParameter at{segment, t};
                       return turned(
                           frames.euler_rodrigues(t), angle.direction(at),
                           [&](const FrameAngle& from) { return angle.value(at, from); }, start);
                     });
}

CompiledFrames::Zeros CompiledFrames::zeros(const PathAngle& angle, const FrameAngle& start) {
  Zeros all;
  for (auto& of_vector : all) of_vector.fill(true);
  const std::size_t segments = angle.path().segments().size();
  Stage stage("segments", segments);
  for (std::size_t k = 0; k < segments; ++k, stage.advance()) {
    const Zeros of_segment = zeros(angle, k, start);
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) all[i][j] = all[i][j] && of_segment[i][j];
  }
  return all;
}

CompiledFrames::Rotation CompiledFrames::rotation(double t) const {
  polynomials_.require_inside(t, "compiled frames");
  return rounding_to_nearest([&] {
    const PolynomialPiece& piece = polynomials_.at(t);
    const auto [u, v, p, q] =
        evaluate_compensated<4>(piece.coefficients.data(), polynomials_.shape(), piece.y(t));
    return Rotation{{u, v, p, q}, piece.error};
  });
}

Frame<double> CompiledFrames::operator()(double t) const {
  return rounding_to_nearest([&]() -> Frame<double> {
    const auto b = rotation(t).b;
    const auto rounded = [](const Vector<DoubleDouble>& x) {
      return Vector<double>{x[0].high + x[0].low, x[1].high + x[1].low, x[2].high + x[2].low};
    };
    return {rounded(rotated_i(b)), rounded(rotated_j(b)), rounded(rotated_k(b))};
  });
}

std::optional<Frame<double>> CompiledFrames::rounded(double t) const {
  return rounding_to_nearest([&] { return near_frame(rotation(t)); });
}

std::optional<Frame<double>> CompiledFrames::near_frame(const Rotation& at) const {
  const auto& [b, off] = at;
  // Of a component, at most four products and three sums of them, which are off by about 2^−102.
  const double error = frame_error(off) + 0x1p-94;
  bool is_certain = true;
  const auto rounded = [&](const Vector<DoubleDouble>& x, const std::array<bool, 3>& is_zero) {
    Vector<double> v{};
    for (std::size_t k = 0; k < 3; ++k) {
      if (is_zero[k]) continue;
      const auto common = common_double(x[k], error);
      is_certain = is_certain && common;
      v[k] = common.value_or(0);
    }
    return v;
  };
  const Frame<double> frame{rounded(rotated_i(b), zeros_[0]), rounded(rotated_j(b), zeros_[1]),
                            rounded(rotated_k(b), zeros_[2])};
  if (!is_certain) return std::nullopt;
  return frame;
}

RoundedFrames::RoundedFrames(const Curve& curve, const RmfAngle& angle, double from, double to,
                             const FrameAngle& start_angle)
    : polynomials_(compiled_rotation(curve, angle, start_angle, from, to, compensated_shape(4))),
      exact_(curve),
      angle_(angle),
      start_angle_(start_angle) {}

/// No value where no piece is at t.
std::optional<Frame<RealBall>> RoundedFrames::enclose(const Rational& t) {
  const double near = round_to_double(t);
  if (!(polynomials_.from() <= near && near <= polynomials_.to())) return std::nullopt;
  const PolynomialPiece& piece = polynomials_.at(near);
  const Rational y = (t - exact_rational(piece.center)) * exact_rational(piece.scale);
  if (abs(y) > 1) return std::nullopt;
  const auto number = static_cast<std::size_t>(&piece - polynomials_.pieces().data());
  if (last_ != number)
    for (std::size_t k = 0; k < 4; ++k)
      of_last_[k] =
          exact_polynomial(piece.coefficients, polynomials_.shape(), static_cast<long>(k));
  last_ = number;

  const BallPowers powers(RealBall(y, frame_bits), polynomials_.shape().degree + 1, frame_bits);
  using Ball = RingBall<frame_bits>;
  const auto component = [&](std::size_t k) {
    return Ball{widened(powers.value_of(of_last_[k]), piece.error)};
  };
  const Quaternion<Ball> b{component(0), component(1), component(2), component(3)};
  const auto balls = [](const Vector<Ball>& v) { return Vector<RealBall>{v[0].x, v[1].x, v[2].x}; };
  return Frame<RealBall>{balls(rotated_i(b)), balls(rotated_j(b)), balls(rotated_k(b))};
}

Frame<double> RoundedFrames::at(const Rational& t) {
  const auto enclosed = enclose(t);
  std::optional<Frame<Real>> exact;  // made for the first component that needs it
  const auto rounded = [&](Vector<RealBall> Frame<RealBall>::*near,
                           Vector<Real> Frame<Real>::*far) {
    Vector<double> v{};
    for (std::size_t k = 0; k < 3; ++k) {
      const auto common = enclosed ? common_double(((*enclosed).*near)[k]) : std::nullopt;
      if (!common && !exact) exact = exact_.rotation_minimizing(angle_, t, start_angle_);
      v[k] = common ? *common : round_to_double(((*exact).*far)[k]);
    }
    return v;
  };
  return {rounded(&Frame<RealBall>::e1, &Frame<Real>::e1),
          rounded(&Frame<RealBall>::e2, &Frame<Real>::e2),
          rounded(&Frame<RealBall>::e3, &Frame<Real>::e3)};
}

}  // namespace phrame
