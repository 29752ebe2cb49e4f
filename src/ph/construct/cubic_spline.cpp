#include "phrame/ph/construct/cubic_spline.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

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

/// Along a line, for equal tangents t₀; nothing for opposite ones.
std::vector<Cubic> straight(const Quaternion<Float>& u0, const Quaternion<Float>& u1,
                            const Vector<Float>& triple_step, const Float& cosine,
                            const Float& tiny) {
  const Vector<Float> t0 = rotated_i(u0);
  const Float along = dot(triple_step, t0);
  const Vector<Float> off = triple_step - along * t0;
  if (cosine < Float(0.0) || !(Float(0.0) < along) || Float(4096.0) * tiny < dot(off, off))
    return {};
  const auto [re, im] = direction_of(hermitian_product(u0, u1), Float(0.0));
  const Float lambda = sqrt(along / Float(3.0));
  return {{lambda, lambda, {re, -im}, 0}};
}

/// The real roots of ax² + bx + c, each as above/below: of the two that with no cancellation, and
/// the other by their product.
std::vector<std::pair<Float, Float>> roots_of_quadratic(const Float& a, const Float& b,
                                                        const Float& c) {
  const Float discriminant = b * b - Float(4.0) * a * c;
  if (discriminant < Float(0.0)) return {};
  const Float root = sqrt(discriminant);
  const Float q = Float(-0.5) * (b < Float(0.0) ? b - root : b + root);
  std::vector<std::pair<Float, Float>> roots{{q, a}};
  if (discriminant != Float(0.0)) roots.emplace_back(c, q);
  std::erase_if(roots, [](const auto& x) { return x.second == Float(0.0); });
  return roots;
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
  if (determinant < tiny) return straight(u0, u1, triple_step, cosine, tiny);
  const ComplexOf<Float> h = hermitian_product(u0, u1);
  const auto [re, im] = direction_of(h, Float(0.0));
  const ComplexOf<Float> to_minimal{re, -im};
  const Float c = sqrt(h.re * h.re + h.im * h.im);
  const Vector<Float> b =
      symmetric_product(u0, turned(turned(u1, to_minimal), {Float(0.0), Float(1.0)}));
  const Float s0 = dot(triple_step, t0);
  const Float s1 = dot(triple_step, t1);
  const Float m0 = (s0 - cosine * s1) / determinant;
  const Float m1 = (s1 - cosine * s0) / determinant;
  const Float mu = dot(triple_step, b) / dot(b, b);
  const Float delta = m0 - m1;
  const Float cc = Float(4.0) * c * c;
  std::vector<Cubic> found;
  for (const auto& [above, below] : roots_of_quadratic(
           Float(1.0) - cc, Float(2.0) * cc * m0 - delta, -(cc * m0 * m0 + mu * mu))) {
    const Float x = above / below;
    const Float y = x - delta;
    if (!(Float(0.0) < x) || !(Float(0.0) < y)) continue;
    const Float product = sqrt(x * y);
    const ComplexOf<Float> phase{c * Float(2.0) * (m0 - x) / product, mu / product};
    Cubic cubic{sqrt(x), sqrt(y), to_minimal * phase, 0};
    cubic.energy = energy_of(cubic.lambda0 * u0, cubic.lambda1 * turned(u1, cubic.turn));
    found.push_back(cubic);
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const Cubic& x, const Cubic& y) { return x.energy < y.energy; });
  return found;
}

Quaternion<Float> unit_preimage(const Vector<Rational>& d, long bits) {
  const Rational scale = scale_for_doubles(largest(d));
  const Vector<Float> v = big_floats(scale * d, bits);
  return preimage((Float(1.0) / sqrt(dot(v, v))) * v);
}

/// A spline with A rounded to multiples of 2^−bits where it is of size 1, segment by segment.
class CubicChain {
 public:
  CubicChain(const HermiteSpline& data, long solution, PointRule rule, long bits)
      : data_(data),
        solution_(solution),
        rule_(rule),
        bits_(bits),
        // What A i A* is out of a plane that is not rational is to be more than what the end is
        // off.
        places_(rule == PointRule::exact ? bits + 48 : bits),
        precision_(3 * places_ + 96),
        tiny_(power_of_two(-2 * bits), precision_),
        scale_(scale_for_doubles(size_of_points(data))),
        u_(direction(0)),
        turn_{Float(1.0), Float(0.0)},
        q_(rounded_to_places(u_, places_)),
        r_(data.points.front()),
        squared_sine_(squared_sine(rotated_i(q_), data.derivatives[0])) {}

  /// The next segment; false where it does not meet its point exactly.
  bool add();

  Construction construction() const;

 private:
  /// A unit preimage of the derivative at a point.
  Quaternion<Float> direction(std::size_t k) const;
  /// The solution that is asked for.
  Cubic chosen(const Quaternion<Float>& u1) const;

  const HermiteSpline& data_;
  long solution_;
  PointRule rule_;
  long bits_;
  long places_;
  long precision_;
  Float tiny_;
  Rational scale_;
  // At the end of the last segment.
  Quaternion<Float> u_;
  ComplexOf<Float> turn_;
  RationalQuaternion q_;  ///< u turned, rounded
  Vector<Rational> r_;
  // The greatest deviations.
  Rational squared_distance_;
  Rational squared_sine_;
  std::vector<Curve> curves_;
};

Quaternion<Float> CubicChain::direction(std::size_t k) const {
  Quaternion<Float> u = unit_preimage(data_.derivatives[k], precision_);
  if (rule_ == PointRule::near) return u;
  u = big_floats(rounded_to_places(u, bits_), precision_);
  return Float(1.0) / sqrt(norm(u)) * u;
}

Cubic CubicChain::chosen(const Quaternion<Float>& u1) const {
  const std::size_t k = curves_.size();
  const Vector<Float> triple_step =
      big_floats(Rational(3 * scale_) * (data_.points[k + 1] - r_), precision_);
  const std::vector<Cubic> found = cubics(u_, u1, triple_step, tiny_);
  if (static_cast<long>(found.size()) < solution_)
    throw DomainError(fmt::format("segment {}: there is {} PH cubic with these ends and tangents",
                                  k + 1, found.empty() ? "no" : "only one"));
  return found[static_cast<std::size_t>(solution_ - 1)];
}

bool CubicChain::add() {
  const std::size_t next = curves_.size() + 1;
  const Quaternion<Float> u1 = direction(next);
  const Cubic cubic = chosen(u1);
  const ComplexOf<Float> turn = cubic.turn * turn_;
  const RationalQuaternion q1 = rounded_to_places(turned(u1, turn), places_);
  const Rational root_of_scale = *square_root(scale_);
  const auto in_units = [&](const Float& lambda) {
    return Rational(rounded_to_places(lambda, places_) / root_of_scale);
  };
  const RationalQuaternion a0 = in_units(cubic.lambda0) * q_;
  const RationalQuaternion a1 = in_units(cubic.lambda1) * q1;
  const QuaternionPolynomial a = from_bernstein({a0, a1});
  if (rule_ == PointRule::exact) {
    const auto f = slight_multiplier(a, {1}, data_.points[next] - r_, MultiplierFreedom::all);
    if (!f) return false;
    curves_.emplace_back(a, from_bernstein(*f), r_);
    r_ = data_.points[next];
  } else {
    curves_.emplace_back(a, Polynomial{1}, r_);
    r_ = r_ + Rational(1, 3) * (rotated_i(a0) + symmetric_product(a0, a1) + rotated_i(a1));
  }
  const Vector<Rational> off = r_ - data_.points[next];
  squared_distance_ = std::max(squared_distance_, dot(off, off));
  squared_sine_ = std::max(squared_sine_, squared_sine(rotated_i(q1), data_.derivatives[next]));
  u_ = u1;
  turn_ = turn;
  q_ = q1;
  return true;
}

/// An acute angle is less than twice its sine.
Construction CubicChain::construction() const {
  std::vector<Rational> parameters;
  for (std::size_t k = 0; k <= curves_.size(); ++k) parameters.emplace_back(k);
  return {joined(curves_),
          std::move(parameters),
          {},
          bits_,
          {square_root_above(squared_distance_), 2 * square_root_above(squared_sine_)}};
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
    CubicChain chain(data, solution, rule, bits);
    not_met = 0;
    for (std::size_t k = 1; k <= data.segments() && not_met == 0; ++k)
      if (!chain.add()) not_met = k;
    if (not_met != 0) continue;
    Construction found = chain.construction();
    if (is_within(found.deviation, tolerance)) return found;
  }
  if (not_met != 0) throw Undecided(fmt::format("segment {}: {}", not_met, no_slight_multiplier));
  throw Undecided("the PH cubics: the points are too sensitive to their coefficients");
}

}  // namespace phrame
