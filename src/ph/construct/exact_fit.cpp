#include "phrame/ph/construct/exact_fit.hpp"

#include <algorithm>

#include "phrame/algebra/rounding.hpp"
#include "phrame/ph/construct/preimage.hpp"
#include "phrame/ph/curve/scale.hpp"

namespace phrame::inline v0 {
namespace {

/// What the curve of a fit lacks to the points, and the greatest square of it.
struct Lack {
  std::vector<Vector<Rational>> of_points;  ///< after the first
  Rational greatest_square;                 ///< the first included
};

Lack lack(const ExactFit& fit, const Vector<Rational>& start, const BezierPoints& points) {
  const BezierPoints reached = control_points_in_degree(curve_of(fit, start), points.size() - 1);
  Lack result;
  for (std::size_t k = 0; k < points.size(); ++k) {
    Vector<Rational> d = points[k] - reached[k];
    result.greatest_square = std::max(result.greatest_square, dot(d, d));
    if (k > 0) result.of_points.push_back(std::move(d));
  }
  return result;
}

/// fit + 2ᵏ·change, of A, and the same of f with its own k.
ExactFit added(ExactFit fit, const PreimageFit& change, long k, long k_of_multiplier) {
  for (std::size_t i = 0; i < fit.preimage.size(); ++i) {
    const RationalQuaternion by = power_of_two(k) * exact_quaternion(change.preimage[i]);
    fit.preimage[i] = fit.preimage[i] + by;
  }
  for (std::size_t i = 0; i < fit.multiplier.size(); ++i)
    fit.multiplier[i] += power_of_two(k_of_multiplier) * exact_rational(change.multiplier[i]);
  return fit;
}

}  // namespace

Curve curve_of(const ExactFit& fit, const Vector<Rational>& start) {
  return Curve(from_bernstein(fit.preimage), from_bernstein(fit.multiplier), start);
}

bool is_point(const ExactFit& fit) {
  return std::ranges::all_of(fit.preimage, [](const auto& a) { return norm(a) == 0; }) ||
         std::ranges::all_of(fit.multiplier, [](const auto& f) { return f == 0; });
}

BezierPoints control_points_in_degree(const Curve& curve, std::size_t degree) {
  BezierPoints result(degree + 1);
  const Vector<Polynomial> r = position(curve);
  for (std::size_t c = 0; c < 3; ++c) {
    const auto b = to_bernstein(r[c], static_cast<long>(degree));
    for (std::size_t k = 0; k <= degree; ++k) result[k][c] = b[k];
  }
  return result;
}

BezierPoints bezier_points(const Vector<Polynomial>& hodograph, const Vector<Rational>& start) {
  const long n = std::max({hodograph[0].degree(), hodograph[1].degree(), hodograph[2].degree()});
  BezierPoints result(static_cast<std::size_t>(n + 2), start);
  for (std::size_t c = 0; c < 3; ++c) {
    const auto derivatives = to_bernstein(hodograph[c], n);
    for (std::size_t k = 0; k < derivatives.size(); ++k)
      result[k + 1][c] = result[k][c] + derivatives[k] / Rational(n + 1);
  }
  return result;
}

std::vector<Vector<Rational>> bezier_derivatives(const BezierPoints& points) {
  const Rational n(static_cast<long>(points.size()) - 1);
  std::vector<Vector<Rational>> result;
  for (std::size_t k = 1; k < points.size(); ++k) {
    const auto d = points[k] - points[k - 1];
    result.push_back(n * d);
  }
  return result;
}

long scale_of(const BezierPoints& points) {
  Rational size = 0;
  for (const auto& p : points) size = std::max(size, largest(p - points[0]));
  return binary_exponent(size) >> 1;
}

std::vector<Vector<double>> scaled_down(const std::vector<Vector<Rational>>& vectors, long scale) {
  const Rational factor = power_of_two(-2 * scale);
  std::vector<Vector<double>> result;
  for (const auto& v : vectors) result.push_back(scaled_to_doubles(factor, v));
  return result;
}

ExactFit exact_fit(const PreimageFit& fit, long scale) {
  ExactFit result;
  for (const auto& a : fit.preimage)
    result.preimage.push_back(power_of_two(scale) * exact_quaternion(a));
  for (const double f : fit.multiplier) result.multiplier.push_back(exact_rational(f));
  return result;
}

Rational squared_distance(const ExactFit& fit, const Vector<Rational>& start,
                          const BezierPoints& points) {
  return lack(fit, start, points).greatest_square;
}

MeasuredFit refined(const ExactFit& from, const FitStep& step, FreePart part, long scale,
                    const Vector<Rational>& start, const BezierPoints& points) {
  constexpr long least_bits = 64;
  constexpr int most_passes = 24;
  MeasuredFit best{from, 0, least_bits};
  Lack now = lack(from, start, points);
  best.squared_distance = now.greatest_square;
  for (int pass = 0; pass < most_passes && now.greatest_square != 0; ++pass) {
    // Of the points divided by 4ᵉ, the remainder is 2ᵏ⁻²ᵉ·(about 1).
    const long k = binary_exponent(now.greatest_square) / 2;
    const PreimageFit change = step(scaled_down(now.of_points, k >> 1));
    const long exponent = 2 * (k >> 1) - 2 * scale;
    const long bits = std::max(least_bits, 40 - exponent);
    ExactFit next = rounded(added(best.fit, change, exponent + scale, exponent), scale, bits, part);
    if (is_point(next)) break;
    now = lack(next, start, points);
    if (now.greatest_square >= best.squared_distance) break;
    const bool is_done = now.greatest_square > Rational(9, 10) * best.squared_distance;
    best = {std::move(next), now.greatest_square, bits};
    if (is_done) break;
  }
  return best;
}

ExactFit rounded(ExactFit fit, long scale, long bits, FreePart part) {
  const std::size_t ends = part == FreePart::inner ? 1 : 0;
  for (std::size_t k = ends; k + ends < fit.preimage.size(); ++k)
    fit.preimage[k] = rounded_to_places(fit.preimage[k], bits - scale);
  if (fit.multiplier.size() > 1)
    for (Rational& f : fit.multiplier) f = rounded_to_places(f, bits);
  return fit;
}

}  // namespace phrame
