#include "phrame/ph/frame/rotation_piece.hpp"

#include <cmath>

#include "phrame/algebra/rounding.hpp"
#include "phrame/ph/frame/piece_guess.hpp"

namespace phrame::inline v0 {
namespace {

/// f·x + g·y + h·z.
BallPolynomial products(const BallPolynomial& f, const BallPolynomial& x, const BallPolynomial& g,
                        const BallPolynomial& y, const BallPolynomial& h, const BallPolynomial& z) {
  const BallPolynomial sum =
      add(multiply(f, x, frame_bits), multiply(g, y, frame_bits), frame_bits);
  return add(sum, multiply(h, z, frame_bits), frame_bits);
}

/// ∫₀^y |σX′ − M·X| ≤ |y|·that, with a, b, c, d of M.
RealBall residual_bound(const BallPolynomial& sigma, const RotationRates& M,
                        const QuaternionSeries& x) {
  const auto& [a, b, c, d] = M;
  const BallPolynomial minus_b = -b;
  const BallPolynomial minus_c = -c;
  const auto& [u, v, p, q] = x;
  const QuaternionSeries moved{products(-a, v, minus_b, p, minus_c, q),  // −av − bp − cq
                               products(a, u, minus_c, p, b, q),         //  au − cp + bq
                               products(b, u, c, v, -d, q),              //  bu + cv − dq
                               products(c, u, minus_b, v, d, p)};        //  cu − bv + dp
  RealBall sum;
  for (std::size_t k = 0; k < 4; ++k) {
    const BallPolynomial rate = multiply(sigma, differentiate(x[k], frame_bits), frame_bits);
    sum = add(sum, integral_bound(subtract(rate, moved[k], frame_bits), frame_bits), frame_bits);
  }
  return sum;
}

}  // namespace

std::optional<PolynomialPiece> rounded_rotation_piece(
    PolynomialPiece piece, const QuaternionSeries& series,
    const std::function<RealBall(const QuaternionSeries& exact)>& remainder_of,
    const DoubleShape& shape) {
  piece.coefficients = round_coefficients({series.begin(), series.end()}, shape);
  QuaternionSeries exact;
  RealBall size, at_zero;
  double squares = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    exact[k] = exact_polynomial(piece.coefficients, shape, static_cast<long>(k));
    size = add(size, variation(exact[k], frame_bits), frame_bits);
    const RealBall off = subtract(exact[k].coefficient(0), series[k].coefficient(0), frame_bits);
    at_zero = add(at_zero, absolute(off), frame_bits);
    squares += std::pow(rounding_error(piece.coefficients, shape, static_cast<long>(k)), 2);
  }
  const RealBall remainder = remainder_of(exact);
  // |B| = 1: to be more exact than the second part makes no difference.
  const double scale = upper_double(size) + 1.0 / 64;
  if (!(upper_double(remainder) <= shape.goal * scale)) return std::nullopt;
  const double off = upper_double(add(at_zero, remainder, frame_bits));
  const double rounding = std::sqrt(squares) * (1 + 0x1p-48);        // not rounded down
  piece.error = sum_up(sum_up(rounding, off), 8 * underflow_error);  // |B| = 1
  return piece;
}

std::optional<PolynomialPiece> rotation_piece(double low, double high, double origin,
                                              const RotationEquation& equation,
                                              const RotationTaylor& taylor,
                                              const DoubleShape& shape) {
  const auto piece = empty_piece(low, high, origin);
  if (!piece) return std::nullopt;
  const BallPolynomial sigma = on_piece(equation.sigma, *piece, frame_bits, true);
  const RealBall least_sigma = least(sigma, frame_bits);
  if (sign(least_sigma) <= 0) return std::nullopt;
  const RotationRates M{
      per_y(equation.a, *piece, frame_bits), per_y(equation.b, *piece, frame_bits),
      per_y(equation.c, *piece, frame_bits), per_y(equation.d, *piece, frame_bits)};
  if (seems_too_long(sigma, M, shape)) return std::nullopt;
  const auto remainder_of = [&](const QuaternionSeries& exact) {
    return divide(residual_bound(sigma, M, exact), least_sigma, frame_bits);
  };
  return rounded_rotation_piece(*piece, taylor(*piece, sigma, M, shape.degree + 1), remainder_of,
                                shape);
}

}  // namespace phrame
