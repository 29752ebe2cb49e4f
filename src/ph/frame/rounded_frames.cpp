#include "phrame/ph/frame/rounded_frames.hpp"

#include "phrame/algebra/ball_powers.hpp"
#include "phrame/algebra/ring_ball.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/ph/frame/compiled_rotation.hpp"
#include "phrame/ph/frame/rotation_piece.hpp"

namespace phrame {

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
