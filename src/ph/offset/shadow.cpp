// With any s(t) in [0, 1], |X/W − base(s(t))|² < d² for all t proves it, times the squared weights
// a polynomial in t. s(t) is the cubic through the feet of perpendiculars from four points: where s
// is off by ε, the distance is so by ε².
#include "phrame/ph/offset/shadow.hpp"

#include <algorithm>
#include <array>
#include <optional>

#include "phrame/algebra/ball_polynomial.hpp"
#include "phrame/ph/curve/scale.hpp"
#include "phrame/ph/curve/vector.hpp"

namespace phrame::inline v0 {
namespace {

constexpr long foot_bits = 256;
constexpr long foot_places = 128;

/// Where near s the base is nearest to the point, by Newton's method; a guess.
std::optional<Rational> foot(const Vector<Polynomial>& base, const Vector<Rational>& at,
                             Rational s) {
  constexpr int steps = 6;
  const Polynomial& w = base[2];
  const auto rate_of = [&](const Polynomial& x) {
    return w.is_constant() ? differentiate(x) : differentiate(x) * w - x * differentiate(w);
  };
  const std::array<Polynomial, 2> rates{rate_of(base[0]), rate_of(base[1])};
  for (int k = 0; k < steps; ++k) {
    // f = (X − at·W)·(X′W − XW′), W³ times (base − at)·base′, and f′.
    RealBall f;
    RealBall slope;
    const RealBall here(s, foot_bits);
    for (std::size_t j = 0; j < 2; ++j) {
      const Polynomial& rate = rates[j];
      const Polynomial way = base[j] - at[j] * w;
      const RealBall gap = evaluate(way, here, foot_bits);
      const RealBall first = evaluate(rate, here, foot_bits);
      f = add_product(f, gap, first, foot_bits);
      slope = add_product(slope, evaluate(differentiate(way), here, foot_bits), first, foot_bits);
      slope = add_product(slope, gap, evaluate(differentiate(rate), here, foot_bits), foot_bits);
    }
    const RealBall next = subtract(here, divide(f, slope, foot_bits), foot_bits);
    if (!next.is_finite()) return std::nullopt;
    s = rounded_to_places(next.midpoint(), foot_places);
    if (s < -1 || s > 2) return std::nullopt;
  }
  return s;
}

/// The cubic through these values at 0, 1/3, 2/3, 1.
Polynomial cubic_through(const std::array<Rational, 4>& values) {
  Polynomial sum;
  for (std::size_t k = 0; k < 4; ++k) {
    Polynomial basis{1};
    for (std::size_t j = 0; j < 4; ++j) {
      if (j == k) continue;
      const Rational gap = Rational(static_cast<long>(k)) - Rational(static_cast<long>(j));
      basis *= Polynomial{-Rational(static_cast<long>(j)) / gap, 3 / gap};
    }
    sum += values[k] * basis;
  }
  return sum;
}

std::vector<RealBall> bernstein(const Polynomial& p) {
  constexpr long bits = 256;
  return to_bernstein(BallPolynomial(p, bits), std::max(p.degree(), 0L), bits);
}

bool is_positive(const Polynomial& p) {
  return std::ranges::all_of(bernstein(p), [](const RealBall& c) { return sign(c) > 0; });
}

}  // namespace

bool is_nearer_along(const RationalCurve& curve, const Rational& lower, const Rational& upper,
                     const Vector<Polynomial>& base, const Rational& beside, const Rational& d) {
  const Rational width = upper - lower;
  Rational s = beside;
  std::array<Rational, 4> feet;
  const bool is_point = base[0].is_constant() && base[1].is_constant() && base[2].is_constant();
  for (std::size_t k = 0; k < 4 && !is_point; ++k) {
    const Vector<Rational> at = point(curve, lower + width * Rational(static_cast<long>(k), 3));
    const auto found = foot(base, at, s);
    if (!found) return false;
    feet[k] = s = *found;
    const Vector<Rational> gap = at - Rational(1 / base[2](s)) * evaluate(base, s);
    if (gap[0] * gap[0] + gap[1] * gap[1] >= d * d) return false;
  }
  const Polynomial along = cubic_through(feet);
  if (!is_point && !(is_positive(along) && is_positive(Polynomial{1} - along))) return false;
  const Polynomial t{lower, width};
  const Polynomial weight = compose(curve.weight(), t);
  const Polynomial of_base = compose(base[2], along);
  Polynomial room = d * d * pow(weight * of_base, 2);
  for (std::size_t k = 0; k < 2; ++k) {
    const Polynomial gap =
        of_base * compose(curve.numerator()[k], t) - weight * compose(base[k], along);
    room -= gap * gap;
  }
  return is_positive(room);
}

}  // namespace phrame
