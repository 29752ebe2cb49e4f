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

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/ph/construct/exact_end.hpp"
#include "phrame/ph/construct/preimage_grid.hpp"
#include "phrame/ph/construct/scale.hpp"

namespace phrame {
namespace {

/// Data of about the size 1.
struct ScaledData {
  HermiteSpline data;
  Rational root;            ///< that A is to be multiplied by
  Rational step_scale;      ///< that steps of the parameter are to be divided by
  Vector<Rational> scales;  ///< of points, derivatives, accelerations
};

ScaledData scaled(const HermiteSpline& data) {
  Rational longest_chord;
  Rational longest_step;
  for (std::size_t k = 0; k < data.segments(); ++k) {
    longest_chord = std::max(longest_chord, largest(data.points[k + 1] - data.points[k]));
    longest_step = std::max(longest_step, data.step(k));
  }
  const Rational step_scale = scale_for_doubles(longest_step);
  if (longest_chord == 0) longest_chord = size_of_derivatives(data) * longest_step;
  const Rational scale = scale_for_doubles(longest_chord);
  ScaledData result{data,
                    *square_root(Rational(step_scale / scale)),
                    step_scale,
                    {scale, scale / step_scale, scale / (step_scale * step_scale)}};
  for (auto& p : result.data.points) p = result.scales[0] * p;
  for (auto& d : result.data.derivatives) d = result.scales[1] * d;
  for (auto& a : result.data.accelerations) a = result.scales[2] * a;
  for (Rational& t : result.data.parameters) t *= step_scale;
  return result;
}

/// A and uA′/4 with respect to the parameter, u the unit of its steps.
struct JointValue {
  RationalQuaternion a;
  RationalQuaternion slope;
};

/// (v A i) for a vector v.
RationalQuaternion times_i(const Vector<Rational>& v, const RationalQuaternion& a) {
  return RationalQuaternion{0, v[0], v[1], v[2]} * a * RationalQuaternion{0, 1, 0, 0};
}

std::vector<JointValue> joint_values(const HermiteSpline& data, const Rational& unit,
                                     const PreimageGrid& grid, long p) {
  std::vector<JointValue> result;
  Quaternion<BigFloat> last;
  for (std::size_t k = 0; k <= data.segments(); ++k) {
    Quaternion<BigFloat> a = preimage(grid.vector(data.derivatives[k]));
    if (k > 0) a = turned(a, turn_to(last, a));
    last = a;
    if (data.is_closed && k == data.segments()) {  // the first, by a short turn, near to this one
      const Quaternion<BigFloat> first = grid.quaternion(result.front().a);
      const ComplexOf<BigFloat> h = hermitian_product(first, a);
      const GaussianInteger z = short_direction(direction_of(h, BigFloat(0.0)));
      const Integer size = sqrt(norm(z));
      const ComplexOf<Rational> turn{Rational(z.re, size), Rational(z.im, size)};
      result.push_back({turned(result.front().a, turn), turned(result.front().slope, turn)});
      break;
    }
    const RationalQuaternion q = exact(grid.rounded(a), grid.step());
    const Rational size = norm(q);
    if (size == 0) return {};
    result.push_back({q, rounded_to_places(
                             Rational(-unit / (8 * size)) * times_i(data.accelerations[k], q), p)});
  }
  return result;
}

struct QuarticSegment {
  QuarticPreimage a;
  Rational h;
  Vector<Rational> start;
};

/// A spline with one rounding.
struct QuarticAttempt {
  std::vector<QuarticSegment> segments;
  Deviation squared;  ///< upper bounds of the greatest ones
};

/// How many bits A₁ and A₃ may have before the point, for great accelerations.
long bits_before_point(const HermiteSpline& data) {
  const Rational size = size_of_accelerations(data);
  return size > 1 ? binary_exponent(size) : 0;
}

std::optional<QuarticAttempt> attempt(const HermiteSpline& data, const Deviation& tolerance,
                                      long p) {
  constexpr long guard_bits = 96;
  const PreimageGrid grid(p, p + 2 * bits_before_point(data) + guard_bits);
  const ParameterSteps steps = parameter_steps(data);
  const std::vector<JointValue> joints = joint_values(data, steps.unit, grid, p);
  if (joints.empty()) return std::nullopt;
  QuarticAttempt result;
  Deviation& squared = result.squared;
  for (std::size_t k = 0; k < joints.size(); ++k) {
    const auto& [a, slope] = joints[k];
    squared.derivatives =
        std::max(squared.derivatives,
                 squared_above(rotated_i(a) - data.derivatives[k], tolerance.derivatives));
    squared.accelerations =
        std::max(squared.accelerations,
                 squared_above(
                     Rational(8 / steps.unit) * symmetric_product(a, slope) - data.accelerations[k],
                     tolerance.accelerations));
  }
  Vector<Rational> at = data.points.front();
  for (std::size_t k = 0; k < data.segments(); ++k) {
    const Rational h = data.step(k);
    const Rational count = steps.counts[k];
    QuarticPreimage a{joints[k].a,
                      joints[k].a + count * joints[k].slope,
                      {},
                      joints[k + 1].a - count * joints[k + 1].slope,
                      joints[k + 1].a};
    const auto [shift, rest] = complete_square(a);
    const Vector<Rational> c =
        Rational(35, 2) * (Rational(1 / h) * (data.points[k + 1] - at) - rest);
    const RationalQuaternion mean = shift + Rational(1, 2) * (a[1] + a[3]);
    const Quaternion<BigFloat> x = preimage(grid.vector(c));
    const Quaternion<BigFloat> turned_x = turned(x, turn_to(grid.quaternion(mean), x));
    a[2] = rounded_to_places(exact(grid.rounded(turned_x), grid.step()) - shift, p);
    result.segments.push_back({a, h, at});
    at = at + h * integral(a);
    squared.points =
        std::max(squared.points, squared_above(at - data.points[k + 1], tolerance.points));
  }
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

/// In the units of the data. With PointRule::exact each segment is two that meet its ends; else
/// only the last one of a closed spline is.
Construction unscaled(const QuarticAttempt& found, const ScaledData& units,
                      const HermiteSpline& data, PointRule rule, long p) {
  std::vector<Curve> curves;
  std::vector<Rational> parameters{data.parameters.front()};
  const auto add = [&](const QuarticSegment& segment) {
    std::vector<RationalQuaternion> b;
    for (const RationalQuaternion& coefficient : segment.a) b.push_back(units.root * coefficient);
    const Rational h = segment.h / units.step_scale;
    curves.emplace_back(from_bernstein(b), Polynomial{h},
                        Rational(1 / units.scales[0]) * segment.start);
    parameters.push_back(parameters.back() + h);
  };
  const bool is_exact = rule == PointRule::exact;
  for (std::size_t k = 0; k < data.segments(); ++k) {
    const QuarticSegment& segment = found.segments[k];
    if (!is_exact && !(data.is_closed && k + 1 == data.segments())) {
      add(segment);
      continue;
    }
    const Vector<Rational>& start = is_exact ? units.data.points[k] : segment.start;
    const Rational& h = segment.h;
    const auto [first, second] = of_segment(k, [&] {
      return exact_halves(segment.a, Rational(1 / h) * (units.data.points[k + 1] - start), p);
    });
    add({first, h / 2, start});
    add({second, h / 2, start + Rational(h / 2) * integral(first)});
  }
  return {joined(curves), std::move(parameters), {}, p - binary_exponent(units.root), {}};
}

}  // namespace

Construction c2_hermite_spline(const HermiteSpline& data, const Deviation& tolerance,
                               PointRule rule) {
  constexpr int most_passes = 40;
  if (data.accelerations.empty())
    throw DomainError(
        "C2 Hermite data are points, derivatives and accelerations; the last are missing");
  for (std::size_t k = 0; k < data.derivatives.size(); ++k)
    if (largest(data.derivatives[k]) == 0)
      throw DomainError(
          fmt::format("the derivative at point {} is 0: no acceleration can be had there", k + 1));
  const ScaledData units = scaled(data);
  const Deviation wanted{units.scales[0] * tolerance.points,
                         units.scales[1] * tolerance.derivatives,
                         units.scales[2] * tolerance.accelerations};
  long p = first_places(units.data, wanted);
  for (int pass = 0; pass < most_passes; ++pass, p += 8) {
    const auto found = attempt(units.data, wanted, p);
    if (!found) continue;
    const Deviation deviation{square_root_above(found->squared.points) / units.scales[0],
                              square_root_above(found->squared.derivatives) / units.scales[1],
                              square_root_above(found->squared.accelerations) / units.scales[2]};
    if (!is_within(deviation, tolerance)) continue;
    Construction spline = unscaled(*found, units, data, rule, p);
    spline.deviation = deviation;
    if (rule == PointRule::exact) spline.deviation.points = 0;
    return spline;
  }
  throw Undecided("the C2 spline of degree 9: the data are too sensitive to its coefficients");
}

}  // namespace phrame
