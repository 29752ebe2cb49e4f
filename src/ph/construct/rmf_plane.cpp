#include "phrame/ph/construct/rmf_plane.hpp"

#include <algorithm>
#include <array>

#include "phrame/algebra/rounding.hpp"
#include "phrame/ph/construct/energy.hpp"
#include "phrame/ph/construct/preimage_grid.hpp"
#include "phrame/ph/curve/scale.hpp"

// In the plane of the displacement and of Q i Q*, seen from Q, r′ is the square of the complex
// w = u + i|ν|s, and the plane quintics have w₀ = λ₀, w₂ = ±λ₁ and, with B = 3w₀ + 4w₁ + 3w₂ as in
// space, B² = 120·displacement − 15(w₀² + w₂²) + 10w₀w₂. It is wanted to be short of digits, so ν
// is rounded, and then u₁ and s₁.

namespace phrame::inline v0 {
namespace {

using PlaneNumber = ComplexOf<BigFloat>;

BigFloat size_of(const PlaneNumber& z) { return sqrt(norm(z)); }

/// One of the two square roots, without cancellation.
PlaneNumber square_root_of(const PlaneNumber& z) {
  const BigFloat half(0.5);
  const BigFloat zero(0.0);
  const BigFloat size = size_of(z);
  if (size == zero) return {zero, zero};
  if (!(z.re < zero)) {
    const BigFloat re = sqrt(half * (size + z.re));
    return {re, half * z.im / re};
  }
  const BigFloat im = sqrt(half * (size - z.re));
  return {half * z.im / im, im};
}

/// Seen from Q: the v with Q v Q* = displacement.
Vector<Rational> seen_from(const RationalQuaternion& q, const Vector<Rational>& displacement) {
  return 1 / (norm(q) * norm(q)) * turned_back(displacement, q);
}

/// ν, of j and k, and of how many places s is to be.
struct PlaneNormal {
  RationalQuaternion nu;
  long places;
};

/// The vector from 0 to d is across by y = 2us·ν_k, z = −2us·ν_j.
PlaneNormal plane_normal(const Vector<Rational>& d, const RationalQuaternion& q, long places,
                         long bits, PointRule rule) {
  const Rational across = std::max(abs(d[1]), abs(d[2]));
  if (across == 0) return {{0, 0, 0, 1}, places};
  if (rule == PointRule::exact) {
    const Rational squared_size = norm(q) * norm(q);  // without the denominator of d
    const Rational factor = squared_size * scale_for_doubles(across * squared_size);
    const long more = binary_exponent(1 + largest(d)) - binary_exponent(across);
    return {{0, 0, -factor * d[2], factor * d[1]}, places + std::max(0L, more)};
  }
  const Rational scale = scale_for_doubles(across);
  const BigFloat y(scale * d[1], bits);
  const BigFloat z(scale * d[2], bits);
  const BigFloat size = sqrt(y * y + z * z);
  return {{0, 0, rounded_to_places(-z / size, places), rounded_to_places(y / size, places)},
          places};
}

}  // namespace

ExactFit plane_between(const ParallelEnds& ends, const Vector<Rational>& displacement, long places,
                       PointRule rule) {
  constexpr long guard = 96;
  const Vector<Rational> d = seen_from(ends.q, displacement);
  const long bits = std::max(0L, places + binary_exponent(1 + largest(d))) + guard;
  const auto number = [bits](const Rational& x) { return BigFloat(x, bits); };
  const auto [nu, places_across] = plane_normal(d, ends.q, places, bits, rule);
  const BigFloat size_of_nu = sqrt(number(norm(nu)));
  const BigFloat along = number(d[0]);
  const BigFloat aside = (number(nu.q * d[1] - nu.p * d[2])) / size_of_nu;
  const Rational& first = ends.at_start;
  std::optional<ExactFit> best;
  double least = 0;
  for (const long sign : {1, -1}) {
    const Rational last = sign * ends.at_end;
    const Rational known = 10 * first * last - 15 * (first * first + last * last);
    const PlaneNumber root =
        square_root_of({BigFloat(120.0) * along + number(known), BigFloat(120.0) * aside});
    for (const double side : {1.0, -1.0}) {
      const BigFloat quarter(0.25 * side);
      const BigFloat u = quarter * root.re - number(Rational(3, 4) * (first + last));
      const BigFloat s = quarter * root.im;
      const std::array<Quaternion<double>, 3> a{{{static_cast<double>(first), 0, 0, 0},
                                                 {u.to_double(), 0, 0, s.to_double()},
                                                 {static_cast<double>(last), 0, 0, 0}}};
      const double energy = approximate_energy(a);
      if (best && !(energy < least)) continue;
      least = energy;
      const Rational across = rounded_to_places(s / size_of_nu, places_across);
      const RationalQuaternion middle{rounded_to_places(u, places), 0, across * nu.p,
                                      across * nu.q};
      best = ExactFit{{first * ends.q, ends.q * middle, last * ends.q}, {1}};
    }
    if (last == 0) break;
  }
  return *best;
}

std::optional<ExactFit> line_between(const ParallelEnds& ends, const Vector<Rational>& displacement,
                                     long places) {
  const Rational f0 = ends.at_start * ends.at_start;
  const Rational f2 = ends.at_end * ends.at_end;
  const Rational f1 = rounded_to_places(3 * seen_from(ends.q, displacement)[0] - f0 - f2, places);
  // f₀(1 − t)² + 2f₁(1 − t)t + f₂t² > 0 between 0 and 1.
  const bool is_positive = f1 > 0 || (f1 == 0 && f0 + f2 > 0) || f1 * f1 < f0 * f2;
  if (!is_positive) return std::nullopt;
  return ExactFit{{ends.q}, {f0, f1, f2}};
}

}  // namespace phrame
