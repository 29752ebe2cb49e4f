#include "phrame/ph/construct/length_spline.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "phrame/algebra/as_written.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/ph/along/arc_length.hpp"
#include "phrame/ph/construct/energy.hpp"
#include "phrame/ph/construct/preimage_grid.hpp"
#include "phrame/ph/construct/quintic_family.hpp"
#include "phrame/ph/construct/quintic_spline.hpp"
#include "phrame/ph/construct/spline_builder.hpp"
#include "phrame/ph/curve/scale.hpp"

// With r′(0) = w·u₀ and r′(1) = w·u₁, |u| = 1, it is B i B* = c = 120Δp + w·v,
// v = 10·S(U₀, U₂) − 15(u₀ + u₁), and 120L = |c| + w·e, e = 30 − 10·U₀·U₂ > 0, where U₀, U₂ are the
// preimages of u₀ and u₁ with the angle Δ. So w solves
//   f(w) = (120L − w·e)² − |120Δp + w·v|² = 0,  0 < w ≤ 120L/e.
// f(0) = 120²(L² − |Δp|²) > 0 and f(120L/e) ≤ 0, and f is quadratic: there is one such w, for every
// Δ. With f = aw² + bw + c it is 2c/(−b + √(b² − 4ac)), the lesser root for a > 0 and the positive
// one for a < 0, without cancellation, as b < 0 where a ≥ 0.
//
// A segment r′ = h·A i A* with h = w has |A|² = 1 at its ends: it is one of the C¹ spline with
// steps h and derivatives u, which quintic_spline() makes.

namespace phrame::inline v0 {
namespace {

/// The quadratic equation for w, with numbers of any kind.
template <class T>
struct SpeedEquation {
  T a;
  T b;
  T c;
};

template <class T>
SpeedEquation<T> speed_equation(const Vector<T>& step, const T& length, const Quaternion<T>& u0,
                                const Quaternion<T>& u2) {
  const Vector<T> v =
      T(10.0) * symmetric_product(u0, u2) - T(15.0) * (rotated_i(u0) + rotated_i(u2));
  const T e = T(30.0) - T(10.0) * hermitian_product(u0, u2).re;
  return {e * e - dot(v, v), T(-240.0) * (length * e + dot(step, v)),
          T(14400.0) * (length * length - dot(step, step))};
}

template <class T>
T speed_of(const SpeedEquation<T>& f) {
  using std::sqrt;
  const T discriminant = f.b * f.b - T(4.0) * f.a * f.c;
  return T(2.0) * f.c / (sqrt(discriminant < T(0.0) ? T(0.0) : discriminant) - f.b);
}

/// Segment k, with preimages of its tangents that are turned to one another by the least rotation.
struct Ends {
  FloatQuaternion u0;
  FloatQuaternion u2;
};
Ends ends_of(const HermiteSpline& data, std::size_t k, long bits) {
  const FloatQuaternion u0 = unit_preimage(data.derivatives[k], bits);
  const FloatQuaternion u2 = unit_preimage(data.derivatives[k + 1], bits);
  return {u0, turned(u2, turn_to(u0, u2))};
}

/// The Δ of the least energy for φ = 0, in units of the length.
FreeAngles angles_of(const HermiteSpline& data, std::size_t k, const Rational& length) {
  constexpr long bits = 128;
  const Ends ends = ends_of(data, k, bits);
  const Quaternion<double> u0 = in_doubles(ends.u0);
  const Quaternion<double> u2 = in_doubles(ends.u2);
  Vector<double> step;
  for (std::size_t j = 0; j < 3; ++j)
    step[j] = static_cast<double>(Rational((data.points[k + 1][j] - data.points[k][j]) / length));
  const auto energy = [&](double delta) {
    const ComplexOf<double> turn{std::cos(delta), std::sin(delta)};
    const double w = speed_of(speed_equation(step, 1.0, u0, turned(u2, turn)));
    const QuinticFamily family({(1 / w) * step, rotated_i(u0), rotated_i(u2)});
    return approximate_energy(family.member(delta, 0)) / w;
  };
  const double best = minimising_angle(energy);
  return {energy(0) <= energy(best) ? Angle() : rounded_angle(best), Angle()};
}

/// Its speed at the ends.
Rational speed_at_ends(const HermiteSpline& data, std::size_t k, const Rational& length,
                       const Angle& delta, long bits) {
  const Ends ends = ends_of(data, k, bits);
  const Vector<Rational> step = (1 / length) * (data.points[k + 1] - data.points[k]);
  const BigFloat w = speed_of(speed_equation(big_floats(step, bits), BigFloat(1, bits), ends.u0,
                                             turned(ends.u2, phase_of(delta, bits))));
  return length * rounded_to_places(w, bits);
}

/// The tangent at point k.
Vector<Rational> unit_tangent(const HermiteSpline& data, std::size_t k, long bits) {
  const Vector<BigFloat> u = rotated_i(unit_preimage(data.derivatives[k], bits));
  return {rounded_to_places(u[0], bits), rounded_to_places(u[1], bits),
          rounded_to_places(u[2], bits)};
}

}  // namespace

std::vector<Rational> segment_lengths(const HermiteSpline& data,
                                      const std::vector<Rational>& given) {
  const std::size_t n = data.segments();
  if (given.size() == n) return given;
  if (given.size() != 1)
    throw DomainError(
        fmt::format("{} lengths for {} segments: one is wanted for each, or that of "
                    "the whole",
                    given.size(), n));
  std::vector<Rational> chords;
  Rational sum;
  for (std::size_t k = 0; k < n; ++k) {
    chords.push_back(rounded_length(data.points[k + 1] - data.points[k], 40));
    sum += chords.back();
  }
  for (Rational& x : chords) x *= given.front() / sum;
  return chords;
}

Construction length_spline(const HermiteSpline& data, const std::vector<Rational>& lengths,
                           const Deviation& tolerance) {
  require_directions(data);
  std::vector<FreeAngles> angles;
  for (std::size_t k = 0; k < data.segments(); ++k) {
    const Vector<Rational> step = data.points[k + 1] - data.points[k];
    if (lengths[k] <= 0 || lengths[k] * lengths[k] <= dot(step, step))
      throw DomainError(
          fmt::format("segment {}: the length {} is not greater than the distance of its points",
                      k + 1, as_written(lengths[k])));
    angles.push_back(angles_of(data, k, lengths[k]));
  }
  // The angle between tangents is less than twice the distance of unit vectors.
  Deviation aimed{tolerance.points, tolerance.derivatives / 2};
  constexpr int most_passes = 20;
  for (int pass = 0; pass < most_passes; ++pass, aimed.points /= 256, aimed.derivatives /= 256) {
    const Rational finest =
        std::min(Rational(aimed.points / *std::max_element(lengths.begin(), lengths.end())),
                 aimed.derivatives);
    const long bits = 64 - 2 * binary_exponent(finest);
    HermiteSpline in_steps{data.points, {}, {Rational(0)}, false};
    for (std::size_t k = 0; k < data.points.size(); ++k)
      in_steps.derivatives.push_back(unit_tangent(data, k, bits));
    for (std::size_t k = 0; k < data.segments(); ++k)
      in_steps.parameters.push_back(in_steps.parameters.back() +
                                    speed_at_ends(data, k, lengths[k], angles[k].delta, bits));
    Construction found = quintic_spline(in_steps, angles, aimed);
    DeviationMeter tangents;
    for (std::size_t k = 0; k < lengths.size(); ++k) {
      const Curve& curve = found.path.segments()[k];
      for (const long end : {0, 1})
        tangents.direction(evaluate(rotated_i(curve.preimage()), end),
                           data.derivatives[k + static_cast<std::size_t>(end)]);
      found.deviation.lengths = std::max(
          found.deviation.lengths, Rational(abs(Rational(arc_length(curve)(1) - lengths[k]))));
    }
    found.deviation.derivatives = tangents.deviation().derivatives;
    if (is_within(found.deviation, tolerance)) return found;
  }
  throw Undecided("the quintics of given lengths: these are too sensitive to their coefficients");
}

}  // namespace phrame
