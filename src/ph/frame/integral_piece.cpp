#include "phrame/ph/frame/integral_piece.hpp"

#include <cmath>

#include "phrame/ph/frame/formula_piece.hpp"

namespace phrame::inline v0 {

std::optional<PolynomialPiece> integral_piece(
    std::size_t k, const Segment& segment, const PieceRate& rate, double low, double high,
    const std::function<RealBall(double center, long bits)>& integral, const DoubleShape& shape) {
  const auto joint = static_cast<double>(k);
  if (const auto* quotient = std::get_if<RootQuotient>(&rate))
    return angle_piece(low, high, joint, *quotient, integral, shape);
  return formula_angle_piece(low, high, joint, std::get<ExpressionCurve>(segment),
                             std::get<CurveIntegrand>(rate), integral, shape);
}

std::optional<PolynomialPiece> well_rounded(std::optional<PolynomialPiece> piece,
                                            const DoubleShape& shape) {
  if (!piece) return std::nullopt;
  const std::vector<double>& c = piece->coefficients;
  double size = std::abs(c[static_cast<std::size_t>(shape.position(0))]) / 64;
  for (long k = 1; k <= shape.degree; ++k)
    size += std::abs(c[static_cast<std::size_t>(shape.position(k))]);
  if (piece->error + piece->error_per_y > 0x1p-72 * size + 0x1p-1000) return std::nullopt;
  return piece;
}

}  // namespace phrame
