// With A and A′ at the points, A′ with respect to the parameter, r′ = S(A, A) and r″ = 2S(A, A′).
// S(A, X) = v has the solutions X = −(v A i)/|A|² + τ A i; so, with τ = 0, A′ = −(a A i)/(2|A|²)
// for the acceleration a. A and uA′/4, where the steps of the parameter are h_k = n_k·u, are
// rounded to multiples of 2^−p, once for both neighbours, and the spline is C². The acceleration of
// such an A could be met exactly, by a fraction over |A|². But that is another denominator at each
// joint, and the points of the curve, which are sums, would get ever longer numbers; so it is met
// within the tolerance, as all is.
//
// On a segment A₀, A₁ = A₀ + n·uA₀′/4, A₃ = A₄ − n·uA₄′/4, A₄ are known then. With X = A₂ + shift
// the rest is (2/35)·X i X* = (p_{k+1} − r_k)/h − rest: each segment aims at its end from where it
// does start, so that deviations do not add up. X is turned such that A₂ is next to the mean of A₁,
// A₃.
#include "phrame/ph/construct/c2_hermite.hpp"

#include <algorithm>
#include <optional>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/ph/construct/exact_end.hpp"
#include "phrame/ph/construct/preimage_grid.hpp"
#include "phrame/ph/construct/spline_builder.hpp"

namespace phrame::inline v0 {
namespace {

/// A and uA′/4 with respect to the parameter, u the unit of its steps.
struct JointValue {
  RationalQuaternion a;
  RationalQuaternion slope;
};

/// (v A i) for a vector v.
RationalQuaternion times_i(const Vector<Rational>& v, const RationalQuaternion& a) {
  return RationalQuaternion{0, v[0], v[1], v[2]} * a * RationalQuaternion{0, 1, 0, 0};
}

/// With multiples of 2^−p, which need so many bits; none where a derivative is nothing beside them.
std::vector<JointValue> joint_values(const HermiteSpline& data, const Rational& unit, long p,
                                     long bits) {
  std::vector<JointValue> result;
  FloatQuaternion last;
  for (std::size_t k = 0; k <= data.segments(); ++k) {
    FloatQuaternion a = preimage(big_floats(data.derivatives[k], bits));
    if (k > 0) a = turned(a, turn_to(last, a));
    last = a;
    if (data.is_closed && k == data.segments()) {  // the first, by a short turn, near to this one
      const FloatQuaternion first = big_floats(result.front().a, bits);
      const ComplexOf<BigFloat> h = hermitian_product(first, a);
      const GaussianInteger z = short_direction(direction_of(h, BigFloat(0.0)));
      const Integer size = sqrt(norm(z));
      const ComplexOf<Rational> turn{Rational(z.re, size), Rational(z.im, size)};
      result.push_back({turned(result.front().a, turn), turned(result.front().slope, turn)});
      break;
    }
    const RationalQuaternion q = rounded_to_places(a, p);
    if (norm(q) == 0) return {};
    const Rational factor = -unit / (8 * norm(q));
    result.push_back({q, rounded_to_places(factor * times_i(data.accelerations[k], q), p)});
  }
  return result;
}

/// How many bits A₁ and A₃ may have before the point, for great accelerations.
long bits_before_point(const HermiteSpline& data) {
  const Rational size = size_of_accelerations(data);
  return size > 1 ? binary_exponent(size) : 0;
}

/// A₂ for an end at c from the start, with what is known of the others.
RationalQuaternion middle_of(const QuarticPreimage& a, const Vector<Rational>& c, long p,
                             long bits) {
  const auto [shift, rest] = complete_square(a);
  const RationalQuaternion mean = shift + Rational(1, 2) * (a[1] + a[3]);
  const FloatQuaternion x = preimage(big_floats(Rational(35, 2) * (c - rest), bits));
  const FloatQuaternion turned_x = turned(x, turn_to(big_floats(mean, bits), x));
  return rounded_to_places(rounded_to_places(turned_x, p) - shift, p);
}

/// With one rounding, of scaled data and so measured; no value where a derivative is nothing
/// beside it.
std::optional<PreimageSpline> attempt(const HermiteSpline& data, const Deviation& tolerance,
                                      long p) {
  constexpr long guard_bits = 96;
  const long bits = p + 2 * bits_before_point(data) + guard_bits;
  const auto [counts, unit] = parameter_steps(data);
  const std::vector<JointValue> joints = joint_values(data, unit, p, bits);
  if (joints.empty()) return std::nullopt;
  DeviationMeter meter(tolerance);
  for (std::size_t k = 0; k < joints.size(); ++k) {
    const auto& [a, slope] = joints[k];
    meter.derivative(rotated_i(a) - data.derivatives[k]);
    meter.acceleration(8 / unit * symmetric_product(a, slope) - data.accelerations[k]);
  }
  PreimageSpline result;
  Vector<Rational> at = data.points.front();
  for (std::size_t k = 0; k < data.segments(); ++k) {
    const Rational h = data.step(k);
    const Rational count = counts[k];
    const auto& [a0, slope0] = joints[k];
    const auto& [a4, slope4] = joints[k + 1];
    QuarticPreimage a{a0, a0 + count * slope0, {}, a4 - count * slope4, a4};
    a[2] = middle_of(a, 1 / h * (data.points[k + 1] - at), p, bits);
    result.segments.push_back({{a.begin(), a.end()}, h, at});
    at = at + h * integral(a);
    meter.point(at - data.points[k + 1]);
  }
  result.deviation = meter.deviation();
  return result;
}

/// As many places as the deviations that are wanted of scaled data need.
long first_places(const HermiteSpline& data, const Deviation& wanted) {
  long p = 20;
  for (const Rational& x : {wanted.points, wanted.derivatives, wanted.accelerations})
    if (x != 0) p = std::max(p, 4 - binary_exponent(x) + bits_before_point(data));
  if (wanted.accelerations != 0)
    p = std::max(p,
                 6 - binary_exponent(Rational(wanted.accelerations * parameter_steps(data).unit)));
  return p;
}

/// In the units of the data.
PreimageSpline unscaled(PreimageSpline spline, const ScaledSpline& units, long p) {
  const auto& [of_points, of_derivatives, of_accelerations] = units.scales;
  for (auto& [a, h, start] : spline.segments) {
    h /= units.step_scale;
    start = 1 / of_points * start;
  }
  spline.root = units.root;
  spline.bits = p - binary_exponent(units.root);
  spline.deviation.points /= of_points;
  spline.deviation.derivatives /= of_derivatives;
  spline.deviation.accelerations /= of_accelerations;
  return spline;
}

}  // namespace

Construction c2_hermite_spline(const HermiteSpline& data, const Deviation& tolerance,
                               PointRule rule) {
  constexpr int most_passes = 40;
  if (data.accelerations.empty())
    throw DomainError(
        "C2 Hermite data are points, derivatives and accelerations; the last are missing");
  require_directions(data, "no acceleration can be had there");
  const ScaledSpline units = scaled(data);
  const Deviation wanted{units.scales[0] * tolerance.points,
                         units.scales[1] * tolerance.derivatives,
                         units.scales[2] * tolerance.accelerations};
  const auto with_places = [&](long p) -> std::optional<Construction> {
    auto found = attempt(units.data, wanted, p);
    if (!found) return std::nullopt;
    const PreimageSpline spline = unscaled(*std::move(found), units, p);
    if (!is_within(spline.deviation, tolerance)) return std::nullopt;
    const auto halves = [p](const BernsteinPreimage& a, const Vector<Rational>& integral) {
      return listed(exact_halves(QuarticPreimage{a[0], a[1], a[2], a[3], a[4]}, integral, p));
    };
    return construction_of(spline, {halves, data.segments() - 1}, data, rule);
  };
  if (auto found =
          first_within(tolerance, first_places(units.data, wanted), most_passes, with_places))
    return *std::move(found);
  throw Undecided("the C2 spline of degree 9: the data are too sensitive to its coefficients");
}

}  // namespace phrame
