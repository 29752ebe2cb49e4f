#include "phrame/ph/frame/compiled_point.hpp"

#include <cmath>

#include "phrame/algebra/rounded_values.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/ph/curve/place.hpp"
#include "phrame/ph/frame/formula_piece.hpp"
#include "phrame/ph/frame/integral_piece.hpp"

namespace phrame::inline v0 {
namespace {

/// A component of r = X/W, from its derivative (X′W − XW′)/W².
std::optional<PolynomialPiece> point_piece(double low, double high, double origin,
                                           const Polynomial& x, const Polynomial& weight,
                                           const DoubleShape& shape) {
  const RootQuotient rate{differentiate(x) * weight - x * differentiate(weight), weight * weight};
  const auto at_center = [&](double center, long bits) {
    const Rational t = exact_rational(center) - exact_rational(origin);
    return RealBall(Rational(x(t) / weight(t)), bits);
  };
  return well_rounded(angle_piece(low, high, origin, rate, at_center, shape), shape);
}

std::optional<PolynomialPiece> point_piece(double low, double high, double origin,
                                           const ExpressionCurve& curve, std::size_t component,
                                           const DoubleShape& shape) {
  const auto at_center = [&](double center, long bits) {
    const Rational t = exact_rational(center) - exact_rational(origin);
    return curve.series(RealBall(t, bits + 32), Rational(1), 1, bits + 32)[component].coefficient(
        0);
  };
  return well_rounded(formula_point_piece(low, high, origin, curve, component, at_center, shape),
                      shape);
}

PiecewisePolynomial compiled_component(const Path& path, std::size_t component) {
  const DoubleShape shape = compensated_shape(1);
  const auto make = [&](double low, double high) {
    const double joint = std::floor(low);
    const Segment& segment = path.segments()[static_cast<std::size_t>(joint)];
    if (const RationalCurve* curve = rational_curve(segment))
      return point_piece(low, high, joint, curve->numerator()[component], curve->weight(), shape);
    return point_piece(low, high, joint, std::get<ExpressionCurve>(segment), component, shape);
  };
  return PiecewisePolynomial::on_units(path.segments().size(), shape, make);
}

}  // namespace

CompiledPoints::CompiledPoints(const Path& path) {
  for (std::size_t k = 0; k < 3; ++k) polynomials_.push_back(compiled_component(path, k));
}

CompiledPoints::CompiledPoints(const Curve& curve, double from, double to) {
  const DoubleShape shape = compensated_shape(1);
  for (const Polynomial& x : position(curve))
    polynomials_.emplace_back(from, to, shape, [&](double low, double high) {
      return point_piece(low, high, 0, x, Polynomial{1}, shape);
    });
}

std::optional<Vector<double>> CompiledPoints::rounded(const NearNumber& t) const {
  return rounding_to_nearest([&]() -> std::optional<Vector<double>> {
    Vector<double> r{};
    for (std::size_t k = 0; k < 3; ++k) {
      const auto near = near_values<1>(polynomials_[k], t);
      const auto x = near ? common_double(near->values[0], near->error) : std::nullopt;
      if (!x || !std::isfinite(*x)) return std::nullopt;
      r[k] = *x;
    }
    return r;
  });
}

std::vector<std::size_t> CompiledPoints::rounded(const NearNumbers& t,
                                                 Vector<std::vector<double>>& r) const {
  return rounding_to_nearest([&] {
    std::vector<std::size_t> untold;
    for (std::size_t k = 0; k < 3; ++k) {
      r[k].resize(t.size());
      const auto of_component = rounded_values(polynomials_[k], t, r[k]);
      untold.insert(untold.end(), of_component.begin(), of_component.end());
      for (std::size_t n = 0; n < t.size(); ++n)
        if (!std::isfinite(r[k][n])) untold.push_back(n);
    }
    return untold;
  });
}

}  // namespace phrame
