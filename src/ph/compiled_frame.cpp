#include "phrame/ph/compiled_frame.hpp"

#include <fmt/format.h>

#include <cmath>

#include "phrame/algebra/error.hpp"

namespace phrame {
namespace {

constexpr long bits = 128;  // of what is known of a piece

using Components = std::array<BallPolynomial, 4>;  // u, v, p, q

/// a + b for a, b ≥ 0, not rounded down.
double sum_up(double a, double b) { return (a + b) * (1 + 0x1p-51); }

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
  /// ∫₀^y |σQ′ − M·Q| ≤ |y|·that.
  RealBall residual_bound(const Components& q) const;

 private:
  /// A polynomial that belongs to a derivative by t, for one by y.
  BallPolynomial per_y(const Polynomial& p) const {
    BallPolynomial q = on_piece(p, piece_, bits);
    arb_poly_scalar_mul_2exp_si(q.raw(), q.raw(), -std::ilogb(piece_.scale));
    return q;
  }

  const Rotation& rotation_;
  const PolynomialPiece& piece_;
  BallPolynomial sigma_;
};

Components RotationOnPiece::taylor(const RealBall& phi_at_center, long length) const {
  BallPolynomial phi, cos, sin, size;
  const BallPolynomial h = per_y(rotation_.h);
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
  const BallPolynomial a = per_y(rotation_.a);
  const BallPolynomial b = per_y(rotation_.b);
  const BallPolynomial c = per_y(rotation_.c);
  const BallPolynomial d = per_y(rotation_.d);
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

}  // namespace

PiecewisePolynomial compiled_rotation(const Curve& curve, RmfAngle& angle,
                                      const Rational& start_angle, double from, double to,
                                      const DoubleShape& shape) {
  const Rotation rotation(curve);
  const auto make = [&](double low, double high) -> std::optional<PolynomialPiece> {
    auto piece = empty_piece(low, high);
    if (!piece) return std::nullopt;
    const RotationOnPiece on_this(rotation, *piece);
    const RealBall least_sigma = least(on_this.sigma(), bits);
    if (sign(least_sigma) <= 0) return std::nullopt;

    RealBall phi =
        add(angle.enclose(exact_rational(piece->center), bits), RealBall(start_angle, bits), bits);
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
    if (upper_double(remainder) > shape.goal * upper_double(size)) return std::nullopt;
    const double off = upper_double(add(at_zero, remainder, bits));
    const double rounding = std::sqrt(squares) * (1 + 0x1p-48);         // not rounded down
    piece->error = sum_up(sum_up(rounding, off), 8 * underflow_error);  // |B| = 1
    return piece;
  };
  return {from, to, shape, make};
}

double frame_error(double error) { return sum_up(2 * error, 2 * error * error); }

CompiledFrames::CompiledFrames(const Curve& curve, RmfAngle& angle, double from, double to,
                               const Rational& start_angle)
    : polynomials_(compiled_rotation(curve, angle, start_angle, from, to, compensated_shape(4))) {
  // Far more than the operations on pairs of doubles are off by, and than rounding leaves.
  for (const PolynomialPiece& piece : polynomials_.pieces())
    if (frame_error(piece.error) > 0x1p-60)
      throw Undecided("compiled frames: the polynomials are not exact enough");
}

Frame<double> CompiledFrames::operator()(double t) const {
  if (!(polynomials_.from() <= t && t <= polynomials_.to()))
    throw DomainError(fmt::format("compiled frames: t = {} is outside [{}, {}]", t,
                                  polynomials_.from(), polynomials_.to()));
  const PolynomialPiece& piece = polynomials_.at(t);
  const auto [u, v, p, q] = evaluate_compensated<4>(piece.coefficients.data(), polynomials_.shape(),
                                                    (t - piece.center) * piece.scale);
  const Quaternion<DoubleDouble> b{u, v, p, q};
  const auto rounded = [](const Vector<DoubleDouble>& x) {
    return Vector<double>{x[0].high + x[0].low, x[1].high + x[1].low, x[2].high + x[2].low};
  };
  return {rounded(rotated_i(b)), rounded(rotated_j(b)), rounded(rotated_k(b))};
}

}  // namespace phrame
