#include "phrame/ph/frame/compiled_length.hpp"

#include <algorithm>
#include <cmath>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/rounded_values.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/integrate/lowest_root_quotient.hpp"
#include "phrame/ph/along/rational_rates.hpp"
#include "phrame/ph/curve/invariants.hpp"
#include "phrame/ph/curve/special_points.hpp"
#include "phrame/ph/frame/integral_piece.hpp"

// Let p be the polynomial of a piece, |p − s| ≤ e on it, and |p(y) − S| ≤ E − e for the length S
// asked for at some y, p′ there about g. If p′ ≥ 2g/3 within δ = 2E/g of y, then
//   s(y + δ) ≥ p(y) + 4E/3 − e ≥ S + E/3 > S > s(y − δ),
// and as s increases, the y with s(y) = S is within δ of y, if all of that is in the piece.

namespace phrame::inline v0 {
namespace {

/// N of s′ = N/(D√S), with the sign that it has next to 0.
PieceRate with_positive(RootQuotient rate, const Polynomial& of_sign) {
  if (!odd(real_roots(of_sign, open_interval(0, 1))).empty())
    throw Undecided("compiled length: the arc length is no polynomial where a curve turns back");
  long denominator = 2;
  while (of_sign(Rational(1, denominator)) == 0) ++denominator;
  if (of_sign(Rational(1, denominator)) < 0) rate.numerator = -rate.numerator;
  return rate;
}

PieceRate length_rate_of(const Segment& segment) {
  if (const Curve* curve = ph_curve(segment); curve != nullptr && curve->is_polynomial())
    return with_positive({curve->multiplier() * sigma(curve->preimage())}, curve->multiplier());
  if (const RationalCurve* curve = rational_curve(segment))
    return with_positive(in_lowest_terms(length_rate(*curve)), curve->multiplier());
  return length_rate();
}

PiecewisePolynomial compiled_length(const Path& path) {
  const DoubleShape shape = compensated_shape(1);
  const PathLength length(path);
  const auto s = [&](double t, long bits) {
    return length.enclose(locate(path, exact_rational(t)), bits);
  };
  std::optional<std::pair<std::size_t, PieceRate>> last;
  const auto make = [&](double low, double high) {
    const auto k = static_cast<std::size_t>(std::floor(low));
    const Segment& segment = path.segments()[k];
    if (!last || last->first != k) last.emplace(k, length_rate_of(segment));
    return well_rounded(integral_piece(k, segment, last->second, low, high, s, shape), shape);
  };
  return PiecewisePolynomial::on_units(path.segments().size(), shape, make);
}

}  // namespace

CompiledLength::CompiledLength(const Path& path) : polynomials_(compiled_length(path)) {
  const RoundingToNearest mode;
  for (const double t : polynomials_.ends())
    at_ends_.push_back(near_values<1>(polynomials_, {{t, 0}, 0}).value().values[0].high);
}

std::vector<std::size_t> CompiledLength::rounded(const NearNumbers& t, std::span<double> s) const {
  return rounding_to_nearest([&] { return rounded_values(polynomials_, t, s); });
}

std::optional<NearNumber> CompiledLength::parameter(const NearNumber& s) const {
  return rounding_to_nearest([&]() -> std::optional<NearNumber> {
    const auto after = std::upper_bound(at_ends_.begin() + 1, at_ends_.end() - 1, s.value.high);
    const auto number = static_cast<std::size_t>(after - at_ends_.begin()) - 1;
    const PolynomialPiece& piece = polynomials_.pieces()[number];
    const DoubleShape& shape = polynomials_.shape();
    const double* coefficients = piece.coefficients.data();
    const double low = piece.y(polynomials_.ends()[number]);
    const double high = piece.y(polynomials_.ends()[number + 1]);

    const double share =
        (s.value.high - at_ends_[number]) / (at_ends_[number + 1] - at_ends_[number]);
    double y = std::clamp(low + (high - low) * share, low, high);
    double below = low;  // y of a smaller s
    double above = high;
    DoubleDouble rest;  // what is left of s
    double slope = 0;
    double step = 0;
    constexpr int most_steps = 40;
    for (int k = 0;; ++k) {
      rest = s.value - evaluate_compensated<1>(coefficients, shape, y)[0];
      slope = evaluate_slope<1>(coefficients, shape, y)[0];
      step = (rest.high + rest.low) / slope;
      if (k == most_steps || !(std::abs(step) > 0x1p-48)) break;
      (rest.high > 0 ? below : above) = y;
      y += step;
      if (!(below <= y && y <= above)) y = below + (above - below) / 2;
    }
    // p(y + step), to the first order, is s.
    const double most = std::abs(step);
    const double rounding = (std::abs(s.value.high) + std::abs(rest.high)) * 0x1p-100;
    const double off =
        piece.error + piece.error_per_y + s.error + rounding + std::abs(rest.high) * 0x1p-49 +
        piece.steepness * most * (2 * slope_error + most) + underflow_error * (1 + piece.steepness);
    const double delta = 2 * off * (1 + 0x1p-40) / slope;
    const double reach = most + delta;
    const bool is_steep =
        slope > 0 && piece.steepness * (2 * slope_error + reach) * (1 + 0x1p-40) <= slope / 3;
    if (!is_steep || !(low <= y - 2 * reach && y + 2 * reach <= high)) return std::nullopt;
    const double over_scale = 1 / piece.scale;
    const DoubleDouble at = two_sum(piece.center, y * over_scale);
    const double low_part = at.low + step * over_scale;
    const double error =
        delta * over_scale + (std::abs(low_part) + std::abs(at.high) * 0x1p-53) * 0x1p-51;
    return NearNumber{two_sum(at.high, low_part), error};
  });
}

}  // namespace phrame
