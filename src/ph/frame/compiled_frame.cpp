#include "phrame/ph/frame/compiled_frame.hpp"

#include <cmath>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/rounding.hpp"

namespace phrame {
namespace {

constexpr long bits = 128;  // of what is known of a piece

using Components = std::array<BallPolynomial, 4>;  // u, v, p, q

/// B = A/√σ·e^{iφ}, φ′ = −h/σ, and σB′ = M·B, where M·B = V·B − h·B·i is
///   (−av − bp − cq, au − cp + bq, bu + cv − dq, cu − bv + dp).
struct Rotation {
  QuaternionPolynomial preimage;
  Polynomial sigma, h, a, b, c, d;

  explicit Rotation(const Curve& curve)
      : preimage(without_real_content(curve.preimage())),
        sigma(phrame::sigma(preimage)),
        h(twist_numerator(preimage)) {
    const auto& [u, v, p, q] = preimage;
    const QuaternionPolynomial rate = QuaternionPolynomial{differentiate(u), differentiate(v),
                                                           differentiate(p), differentiate(q)} *
                                      QuaternionPolynomial{u, -v, -p, -q};
    a = rate.v - h;
    b = rate.p;
    c = rate.q;
    d = rate.v + h;
  }
};

/// The same as polynomials in the y of a piece.
class RotationOnPiece {
 public:
  RotationOnPiece(const Rotation& rotation, const PolynomialPiece& piece)
      : rotation_(rotation), piece_(piece), sigma_(on_piece(rotation.sigma, piece, bits, true)) {}

  const BallPolynomial& sigma() const { return sigma_; }
  Components taylor(const RealBall& phi_at_center, long length) const;
  /// ∫₀^y |σX′ − M·X| ≤ |y|·that.
  RealBall residual_bound(const Components& x) const;

 private:
  const Rotation& rotation_;
  const PolynomialPiece& piece_;
  BallPolynomial sigma_;
};

Components RotationOnPiece::taylor(const RealBall& phi_at_center, long length) const {
  BallPolynomial phi, cos, sin, size;
  const BallPolynomial h = per_y(rotation_.h, piece_, bits);
  arb_poly_div_series(phi.raw(), h.raw(), sigma_.raw(), length - 1, bits);
  arb_poly_integral(phi.raw(), phi.raw(), bits);
  arb_poly_neg(phi.raw(), phi.raw());
  arb_poly_set_coeff_arb(phi.raw(), 0, phi_at_center.raw());
  arb_poly_sin_cos_series(sin.raw(), cos.raw(), phi.raw(), length, bits);
  arb_poly_rsqrt_series(size.raw(), sigma_.raw(), length, bits);
  arb_poly_mullow(sin.raw(), sin.raw(), size.raw(), length, bits);
  arb_poly_mullow(cos.raw(), cos.raw(), size.raw(), length, bits);

  // (x + yi)·e^{iφ} and (x + yi)·j·e^{iφ} = (x + yi)·e^{−iφ}·j.
  const auto turned = [&](const Polynomial& re, const Polynomial& im, const BallPolynomial& sine) {
    const BallPolynomial x = on_piece(re, piece_, bits);
    const BallPolynomial y = on_piece(im, piece_, bits);
    const auto times = [&](const BallPolynomial& p, const BallPolynomial& q) {
      BallPolynomial product;
      arb_poly_mullow(product.raw(), p.raw(), q.raw(), length, bits);
      return product;
    };
    return std::pair{subtract(times(x, cos), times(y, sine), bits),
                     add(times(x, sine), times(y, cos), bits)};
  };
  BallPolynomial minus_sin;
  arb_poly_neg(minus_sin.raw(), sin.raw());
  const auto [u, v] = turned(rotation_.preimage.u, rotation_.preimage.v, sin);
  const auto [p, q] = turned(rotation_.preimage.p, rotation_.preimage.q, minus_sin);
  return {u, v, p, q};
}

RealBall RotationOnPiece::residual_bound(const Components& x) const {
  const auto& [u, v, p, q] = x;
  const BallPolynomial a = per_y(rotation_.a, piece_, bits);
  const BallPolynomial b = per_y(rotation_.b, piece_, bits);
  const BallPolynomial c = per_y(rotation_.c, piece_, bits);
  const BallPolynomial d = per_y(rotation_.d, piece_, bits);
  const auto times = [](const BallPolynomial& f, const BallPolynomial& g) {
    return multiply(f, g, bits);
  };
  const auto minus = [](const BallPolynomial& f, const BallPolynomial& g) {
    return subtract(f, g, bits);
  };
  const Components moved{minus(minus(minus({}, times(a, v)), times(b, p)), times(c, q)),
                         minus(minus(times(a, u), times(c, p)), minus({}, times(b, q))),
                         minus(minus(times(b, u), minus({}, times(c, v))), times(d, q)),
                         minus(minus(times(c, u), times(b, v)), minus({}, times(d, p)))};
  RealBall sum;
  for (std::size_t k = 0; k < 4; ++k)
    sum = add(sum, integral_bound(minus(times(sigma_, differentiate(x[k], bits)), moved[k]), bits),
              bits);
  return sum;
}

/// B on [low, high] for a curve with the parameter t − origin, from balls around θ(center).
std::optional<PolynomialPiece> rotation_piece(
    double low, double high, double origin, const Rotation& rotation,
    const std::function<RealBall(double center, long bits)>& theta, const Angle& start_angle,
    const DoubleShape& shape) {
  auto piece = empty_piece(low, high, origin);
  if (!piece) return std::nullopt;
  const RotationOnPiece on_this(rotation, *piece);
  const RealBall least_sigma = least(on_this.sigma(), bits);
  if (sign(least_sigma) <= 0) return std::nullopt;

  // Absolutely, φ is to be known to about 2^−bits.
  const Rational size_of_start = abs(start_angle.radians) + 4 * abs(start_angle.half_turns);
  const long phi_bits = bits + (size_of_start > 1 ? binary_exponent(size_of_start) : 0);
  RealBall phi = add(theta(piece->center, bits), to_real(start_angle).enclose(phi_bits), phi_bits);
  arb_mul_2exp_si(phi.raw(), phi.raw(), -1);
  const Components taylor = on_this.taylor(phi, shape.degree + 1);
  piece->coefficients = round_coefficients({taylor.begin(), taylor.end()}, shape);

  Components exact;
  RealBall size, at_zero;
  double squares = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    exact[k] = exact_polynomial(piece->coefficients, shape, static_cast<long>(k));
    size = add(size, variation(exact[k], bits), bits);
    const RealBall off = subtract(exact[k].coefficient(0), taylor[k].coefficient(0), bits);
    at_zero = add(at_zero, absolute(off), bits);
    squares += std::pow(rounding_error(piece->coefficients, shape, static_cast<long>(k)), 2);
  }
  const RealBall remainder = divide(on_this.residual_bound(exact), least_sigma, bits);
  // |B| = 1: to be more exact than the second part makes no difference.
  const double scale = upper_double(size) + 1.0 / 64;
  if (!(upper_double(remainder) <= shape.goal * scale)) return std::nullopt;
  const double off = upper_double(add(at_zero, remainder, bits));
  const double rounding = std::sqrt(squares) * (1 + 0x1p-48);         // not rounded down
  piece->error = sum_up(sum_up(rounding, off), 8 * underflow_error);  // |B| = 1
  return piece;
}

}  // namespace

PiecewisePolynomial compiled_rotation(const Curve& curve, const RmfAngle& angle,
                                      const Angle& start_angle, double from, double to,
                                      const DoubleShape& shape) {
  const Rotation rotation(curve);
  const auto theta = [&](double t, long more) { return angle.enclose(exact_rational(t), more); };
  return {from, to, shape, [&](double low, double high) {
            return rotation_piece(low, high, 0, rotation, theta, start_angle, shape);
          }};
}

PiecewisePolynomial compiled_rotation(const SplineAngle& angle, const Angle& start_angle,
                                      const DoubleShape& shape) {
  const std::vector<Rotation> rotations(angle.spline().segments().begin(),
                                        angle.spline().segments().end());
  const auto theta = [&](double t, long more) {
    return angle.enclose(locate(angle.spline(), exact_rational(t)), more);
  };
  const auto make = [&](double low, double high) {
    const double joint = std::floor(low);
    const Rotation& rotation = rotations[static_cast<std::size_t>(joint)];
    return rotation_piece(low, high, joint, rotation, theta, start_angle, shape);
  };
  return PiecewisePolynomial::on_units(rotations.size(), shape, make);
}

double frame_error(double error) { return sum_up(2 * error, 2 * error * error); }

CompiledFrames::CompiledFrames(const Curve& curve, const RmfAngle& angle, double from, double to,
                               const Angle& start_angle)
    : CompiledFrames(compiled_rotation(curve, angle, start_angle, from, to, compensated_shape(4))) {
}

CompiledFrames::CompiledFrames(const SplineAngle& angle, const Angle& start_angle)
    : CompiledFrames(compiled_rotation(angle, start_angle, compensated_shape(4))) {}

CompiledFrames::CompiledFrames(PiecewisePolynomial polynomials)
    : polynomials_(std::move(polynomials)) {
  // Far more than the operations on pairs of doubles are off by, and than rounding leaves.
  for (const PolynomialPiece& piece : polynomials_.pieces())
    if (!(frame_error(piece.error) <= 0x1p-60))
      throw Undecided("compiled frames: the polynomials are not exact enough");
}

Frame<double> CompiledFrames::operator()(double t) const {
  polynomials_.require_inside(t, "compiled frames");
  const PolynomialPiece& piece = polynomials_.at(t);
  const auto [u, v, p, q] =
      evaluate_compensated<4>(piece.coefficients.data(), polynomials_.shape(), piece.y(t));
  const Quaternion<DoubleDouble> b{u, v, p, q};
  const auto rounded = [](const Vector<DoubleDouble>& x) {
    return Vector<double>{x[0].high + x[0].low, x[1].high + x[1].low, x[2].high + x[2].low};
  };
  return {rounded(rotated_i(b)), rounded(rotated_j(b)), rounded(rotated_k(b))};
}

namespace {

/// A ball with the operations of a ring.
struct Ball {
  RealBall x;
  friend Ball operator+(const Ball& a, const Ball& b) { return {add(a.x, b.x, bits)}; }
  friend Ball operator-(const Ball& a, const Ball& b) { return {subtract(a.x, b.x, bits)}; }
  friend Ball operator*(const Ball& a, const Ball& b) { return {multiply(a.x, b.x, bits)}; }
};

}  // namespace

RoundedFrames::RoundedFrames(const Curve& curve, const RmfAngle& angle, double from, double to)
    : polynomials_(compiled_rotation(curve, angle, {}, from, to, compensated_shape(4))),
      exact_(curve),
      angle_(angle) {}

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

  RealBall off;  // 0 ± what the polynomials are off by
  mag_set_d(arb_radref(off.raw()), piece.error);
  BallPolynomial powers;  // y⁰, y¹, … for all four
  const long length = polynomials_.shape().degree + 1;
  arb_poly_fit_length(powers.raw(), length);
  _arb_vec_set_powers(powers.raw()->coeffs, RealBall(y, bits).raw(), length, bits);
  _arb_poly_set_length(powers.raw(), length);
  const auto component = [&](std::size_t k) {
    const arb_poly_struct* p = of_last_[k].raw();
    RealBall value;
    arb_dot(value.raw(), nullptr, 0, p->coeffs, 1, powers.raw()->coeffs, 1, p->length, bits);
    return Ball{add(value, off, bits)};
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
      if (!common && !exact) exact = exact_.rotation_minimizing(angle_, t);
      v[k] = common ? *common : round_to_double(((*exact).*far)[k]);
    }
    return v;
  };
  return {rounded(&Frame<RealBall>::e1, &Frame<Real>::e1),
          rounded(&Frame<RealBall>::e2, &Frame<Real>::e2),
          rounded(&Frame<RealBall>::e3, &Frame<Real>::e3)};
}

}  // namespace phrame
