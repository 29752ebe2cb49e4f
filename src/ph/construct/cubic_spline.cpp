#include "phrame/ph/construct/cubic_spline.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/ph/construct/energy.hpp"
#include "phrame/ph/construct/multiplier.hpp"
#include "phrame/ph/construct/preimage_grid.hpp"
#include "phrame/ph/construct/scale.hpp"

// With preimages U₀, U₁ of the unit tangents u₀, u₁ such that c = H(U₀, U₁) > 0, the cubic with
// A = (λ₀U₀, λ₁U₁e^{iφ}) goes along 3Δp = λ₀²u₀ + λ₁²u₁ + λ₀λ₁((u₀ + u₁) cos φ/(2c) + b sin φ),
// b = S(U₀, U₁i) ⟂ u₀, u₁. For 3Δp = m₀u₀ + m₁u₁ + μb and δ = m₀ − m₁ it follows that X = λ₀² has
//   (1 − 4c²)X² + (8c²m₀ − δ)X − 4c²m₀² − μ² = 0, X > max(0, δ),
//   λ₁² = X − δ, λ₀λ₁ cos φ = 2c(m₀ − X), λ₀λ₁ sin φ = μ.
// Each such X is a solution. For u₁ = u₀ there is a line or nothing, for u₁ = −u₀ this says
// nothing. What is less than the rounding of a line is one; else the equation decides, for which
// |u₀ × u₁| is computed without cancellation. Rounded are U₀, U₁e^{iφ}, once for both neighbours of
// a joint, and the λ.

namespace phrame {
namespace {

using Float = BigFloat;

struct Cubic {
  Float lambda0;
  Float lambda1;
  ComplexOf<Float> turn;  ///< of the preimage at the end
  double energy;
};

double energy_of(const Quaternion<Float>& a0, const Quaternion<Float>& a1) {
  const std::array a{in_doubles(a0), in_doubles(a1)};
  return approximate_energy(a);
}

/// The solutions with these preimages of unit tangents, by energy. Lengths are of about 1;
/// angles whose squares are below `tiny`, and ways aside with 4096 times that, count as 0.
std::vector<Cubic> cubics(const Quaternion<Float>& u0, const Quaternion<Float>& u1,
                          const Vector<Float>& triple_step, const Float& tiny) {
  const Vector<Float> t0 = rotated_i(u0);
  const Vector<Float> t1 = rotated_i(u1);
  const Float cosine = dot(t0, t1);
  const Vector<Float> normal = cross(t0, t1);
  const Float determinant = dot(normal, normal);
  const Float s0 = dot(triple_step, t0);
  const Float s1 = dot(triple_step, t1);
  if (determinant < tiny) {  // a line, or nothing
    const Vector<Float> off = triple_step - s0 * t0;
    if (cosine < Float(0.0) || !(Float(0.0) < s0) || Float(4096.0) * tiny < dot(off, off))
      return {};
    const auto [re, im] = direction_of(hermitian_product(u0, u1), Float(0.0));
    const Float lambda = sqrt(s0 / Float(3.0));
    return {{lambda, lambda, {re, -im}, 0}};
  }
  const ComplexOf<Float> h = hermitian_product(u0, u1);
  const auto [re, im] = direction_of(h, Float(0.0));
  const ComplexOf<Float> to_minimal{re, -im};
  const Float c = sqrt(h.re * h.re + h.im * h.im);
  const Vector<Float> b =
      symmetric_product(u0, turned(turned(u1, to_minimal), {Float(0.0), Float(1.0)}));
  const Float m0 = (s0 - cosine * s1) / determinant;
  const Float m1 = (s1 - cosine * s0) / determinant;
  const Float mu = dot(triple_step, b) / dot(b, b);
  const Float delta = m0 - m1;
  const Float cc = Float(4.0) * c * c;
  const Float square = Float(1.0) - cc;
  const Float linear = Float(2.0) * cc * m0 - delta;
  const Float constant = -(cc * m0 * m0 + mu * mu);
  const Float discriminant = linear * linear - Float(4.0) * square * constant;
  if (discriminant < Float(0.0)) return {};
  // Of the two roots that with no cancellation, and the other by their product.
  const Float root = sqrt(discriminant);
  const Float q = Float(-0.5) * (linear < Float(0.0) ? linear - root : linear + root);
  std::vector<Cubic> found;
  const auto consider = [&](const Float& above, const Float& below) {
    if (below == Float(0.0)) return;
    const Float x = above / below;
    const Float y = x - delta;
    if (!(Float(0.0) < x) || !(Float(0.0) < y)) return;
    const Float product = sqrt(x * y);
    const ComplexOf<Float> phase{c * Float(2.0) * (m0 - x) / product, mu / product};
    Cubic cubic{sqrt(x), sqrt(y), to_minimal * phase, 0};
    cubic.energy = energy_of(cubic.lambda0 * u0, cubic.lambda1 * turned(u1, cubic.turn));
    found.push_back(cubic);
  };
  consider(q, square);
  if (discriminant != Float(0.0)) consider(constant, q);
  std::stable_sort(found.begin(), found.end(),
                   [](const Cubic& x, const Cubic& y) { return x.energy < y.energy; });
  return found;
}

Quaternion<Float> unit_preimage(const Vector<Rational>& d, long bits) {
  const Rational scale = scale_for_doubles(largest(d));
  const Vector<Float> v = big_floats(scale * d, bits);
  return preimage((Float(1.0) / sqrt(dot(v, v))) * v);
}

/// A spline with A rounded to multiples of 2^−bits where it is of size 1; no value where the
/// deviations are too great, or where segment `not_met` does not meet its point exactly. An acute
/// angle is less than twice its sine.
std::optional<Construction> attempt(const HermiteSpline& data, long solution,
                                    const Deviation& tolerance, PointRule rule, long bits,
                                    std::size_t& not_met) {
  // What A i A* is out of a plane that is not rational is to be more than what the end is off.
  const long places = rule == PointRule::exact ? bits + 48 : bits;
  const long precision = 3 * places + 96;
  const Float tiny(power_of_two(-2 * bits), precision);
  const Rational scale = scale_for_doubles(size_of_points(data));
  const Rational root_of_scale = *square_root(scale);
  const auto direction = [&](std::size_t k) {
    Quaternion<Float> u = unit_preimage(data.derivatives[k], precision);
    if (rule == PointRule::near) return u;
    u = big_floats(rounded_to_places(u, bits), precision);
    return Float(1.0) / sqrt(norm(u)) * u;
  };
  Quaternion<Float> u0 = direction(0);
  ComplexOf<Float> turn{Float(1.0), Float(0.0)};
  RationalQuaternion q0 = rounded_to_places(u0, places);
  Vector<Rational> r = data.points.front();
  Rational points;
  Rational sines = squared_sine(rotated_i(q0), data.derivatives[0]);
  std::vector<Curve> curves;
  for (std::size_t k = 0; k < data.segments(); ++k) {
    const Quaternion<Float> u1 = direction(k + 1);
    const Vector<Float> triple_step =
        big_floats(Rational(3 * scale) * (data.points[k + 1] - r), precision);
    const std::vector<Cubic> found = cubics(u0, u1, triple_step, tiny);
    if (static_cast<long>(found.size()) < solution)
      throw DomainError(fmt::format("segment {}: there is {} PH cubic with these ends and tangents",
                                    k + 1, found.empty() ? "no" : "only one"));
    const Cubic& cubic = found[static_cast<std::size_t>(solution - 1)];
    const ComplexOf<Float> next_turn = cubic.turn * turn;
    const RationalQuaternion q1 = rounded_to_places(turned(u1, next_turn), places);
    const RationalQuaternion a0 =
        Rational(rounded_to_places(cubic.lambda0, places) / root_of_scale) * q0;
    const RationalQuaternion a1 =
        Rational(rounded_to_places(cubic.lambda1, places) / root_of_scale) * q1;
    const QuaternionPolynomial a = from_bernstein({a0, a1});
    if (rule == PointRule::exact) {
      const auto f = slight_multiplier(a, {1}, data.points[k + 1] - r, MultiplierFreedom::all);
      if (!f) {
        not_met = k + 1;
        return std::nullopt;
      }
      curves.emplace_back(a, from_bernstein(*f), r);
      r = data.points[k + 1];
    } else {
      curves.emplace_back(a, Polynomial{1}, r);
      r = r + Rational(1, 3) * (rotated_i(a0) + symmetric_product(a0, a1) + rotated_i(a1));
    }
    const Vector<Rational> off = r - data.points[k + 1];
    points = std::max(points, dot(off, off));
    sines = std::max(sines, squared_sine(rotated_i(q1), data.derivatives[k + 1]));
    u0 = u1;
    turn = next_turn;
    q0 = q1;
  }
  const Deviation deviation{square_root_above(points), 2 * square_root_above(sines)};
  if (!is_within(deviation, tolerance)) return std::nullopt;
  std::vector<Rational> parameters;
  for (std::size_t k = 0; k <= data.segments(); ++k) parameters.emplace_back(k);
  return Construction{joined(curves), std::move(parameters), {}, bits, deviation};
}

}  // namespace

Construction cubic_spline(const HermiteSpline& data, long solution, const Deviation& tolerance,
                          PointRule rule) {
  constexpr long most_passes = 20;
  require_directions(data);
  const Rational finest = std::min(
      tolerance.derivatives, Rational(tolerance.points * scale_for_doubles(size_of_points(data))));
  long bits = std::max(20L, 4 - binary_exponent(finest));
  std::size_t not_met = 0;  // its number
  for (long pass = 0; pass < most_passes; ++pass, bits += 8) {
    not_met = 0;
    if (auto found = attempt(data, solution, tolerance, rule, bits, not_met))
      return *std::move(found);
  }
  if (not_met != 0) throw Undecided(fmt::format("segment {}: {}", not_met, no_slight_multiplier));
  throw Undecided("the PH cubics: the points are too sensitive to their coefficients");
}

}  // namespace phrame
