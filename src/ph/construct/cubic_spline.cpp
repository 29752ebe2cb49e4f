#include "phrame/ph/construct/cubic_spline.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/ph/construct/energy.hpp"
#include "phrame/ph/construct/preimage_grid.hpp"
#include "phrame/ph/construct/spline_builder.hpp"

// With preimages U₀, U₁ of the unit tangents u₀, u₁ such that c = H(U₀, U₁) > 0, the cubic with
// A = (λ₀U₀, λ₁U₁e^{iφ}) goes along 3Δp = λ₀²u₀ + λ₁²u₁ + λ₀λ₁((u₀ + u₁) cos φ/(2c) + b sin φ),
// b = S(U₀, U₁i) ⟂ u₀, u₁. For 3Δp = m₀u₀ + m₁u₁ + μb and δ = m₀ − m₁ it follows that X = λ₀² has
//   (1 − 4c²)X² + (8c²m₀ − δ)X − 4c²m₀² − μ² = 0, X > max(0, δ),
//   λ₁² = X − δ, λ₀λ₁ cos φ = 2c(m₀ − X), λ₀λ₁ sin φ = μ.
// Each such X is a solution. For u₁ = u₀ there is a line or nothing, for u₁ = −u₀ this says
// nothing. What is less than the rounding of a line is one; else the equation decides, for which
// |u₀ × u₁| is computed without cancellation. Rounded are U₀, U₁e^{iφ}, once for both neighbours of
// a joint, and the λ.

namespace phrame::inline v0 {
namespace {

struct Cubic {
  BigFloat lambda0;
  BigFloat lambda1;
  ComplexOf<BigFloat> turn;  ///< of the preimage at the end
  double energy;
};

double energy_of(const FloatQuaternion& a0, const FloatQuaternion& a1) {
  const std::array a{in_doubles(a0), in_doubles(a1)};
  return approximate_energy(a);
}

/// Along a line, for equal tangents t₀; nothing for opposite ones.
std::vector<Cubic> straight(const FloatQuaternion& u0, const FloatQuaternion& u1,
                            const Vector<BigFloat>& triple_step, const BigFloat& cosine,
                            const BigFloat& tiny) {
  const Vector<BigFloat> t0 = rotated_i(u0);
  const BigFloat along = dot(triple_step, t0);
  const Vector<BigFloat> off = triple_step - along * t0;
  if (cosine < BigFloat(0.0) || !(BigFloat(0.0) < along) || BigFloat(4096.0) * tiny < dot(off, off))
    return {};
  const Phase to_minimal = conjugate(direction_of(hermitian_product(u0, u1), BigFloat(0.0)));
  const BigFloat lambda = sqrt(along / BigFloat(3.0));
  return {{lambda, lambda, to_minimal, 0}};
}

/// The real roots of ax² + bx + c, each as above/below: of the two that with no cancellation, and
/// the other by their product.
std::vector<std::pair<BigFloat, BigFloat>> roots_of_quadratic(const BigFloat& a, const BigFloat& b,
                                                              const BigFloat& c) {
  const BigFloat discriminant = b * b - BigFloat(4.0) * a * c;
  if (discriminant < BigFloat(0.0)) return {};
  const BigFloat root = sqrt(discriminant);
  const BigFloat q = BigFloat(-0.5) * (b < BigFloat(0.0) ? b - root : b + root);
  std::vector<std::pair<BigFloat, BigFloat>> roots{{q, a}};
  if (discriminant != BigFloat(0.0)) roots.emplace_back(c, q);
  std::erase_if(roots, [](const auto& x) { return x.second == BigFloat(0.0); });
  return roots;
}

/// The solutions with these preimages of unit tangents, by energy. Lengths are of about 1;
/// angles whose squares are below `tiny`, and ways aside with 4096 times that, count as 0.
std::vector<Cubic> cubics(const FloatQuaternion& u0, const FloatQuaternion& u1,
                          const Vector<BigFloat>& triple_step, const BigFloat& tiny) {
  const Vector<BigFloat> t0 = rotated_i(u0);
  const Vector<BigFloat> t1 = rotated_i(u1);
  const BigFloat cosine = dot(t0, t1);
  const Vector<BigFloat> normal = cross(t0, t1);
  const BigFloat determinant = dot(normal, normal);
  if (determinant < tiny) return straight(u0, u1, triple_step, cosine, tiny);
  const ComplexOf<BigFloat> h = hermitian_product(u0, u1);
  const Phase to_minimal = conjugate(direction_of(h, BigFloat(0.0)));
  const BigFloat c = sqrt(norm(h));
  const Vector<BigFloat> b =
      symmetric_product(u0, turned(turned(u1, to_minimal), {BigFloat(0.0), BigFloat(1.0)}));
  const BigFloat s0 = dot(triple_step, t0);
  const BigFloat s1 = dot(triple_step, t1);
  const BigFloat m0 = (s0 - cosine * s1) / determinant;
  const BigFloat m1 = (s1 - cosine * s0) / determinant;
  const BigFloat mu = dot(triple_step, b) / dot(b, b);
  const BigFloat delta = m0 - m1;
  const BigFloat cc = BigFloat(4.0) * c * c;
  std::vector<Cubic> found;
  for (const auto& [above, below] : roots_of_quadratic(
           BigFloat(1.0) - cc, BigFloat(2.0) * cc * m0 - delta, -(cc * m0 * m0 + mu * mu))) {
    const BigFloat x = above / below;
    const BigFloat y = x - delta;
    if (!(BigFloat(0.0) < x) || !(BigFloat(0.0) < y)) continue;
    const BigFloat product = sqrt(x * y);
    const ComplexOf<BigFloat> phase{c * BigFloat(2.0) * (m0 - x) / product, mu / product};
    Cubic cubic{sqrt(x), sqrt(y), to_minimal * phase, 0};
    cubic.energy = energy_of(cubic.lambda0 * u0, cubic.lambda1 * turned(u1, cubic.turn));
    found.push_back(cubic);
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const Cubic& x, const Cubic& y) { return x.energy < y.energy; });
  return found;
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
        scale_(scale_for_doubles(size_of_points(data))) {}

  std::optional<Construction> run(SplineBuilder& builder) const;

 private:
  /// A unit preimage of the derivative at a point.
  FloatQuaternion direction(std::size_t k) const;
  /// The solution that is asked for, of segment k.
  Cubic chosen(std::size_t k, const Vector<Rational>& step, const FloatQuaternion& u0,
               const FloatQuaternion& u1) const;

  const HermiteSpline& data_;
  long solution_;
  PointRule rule_;
  long bits_;
  long places_;
  long precision_;
  Rational scale_;
};

FloatQuaternion CubicChain::direction(std::size_t k) const {
  const FloatQuaternion u = unit_preimage(data_.derivatives[k], precision_);
  if (rule_ == PointRule::near) return u;
  const FloatQuaternion rounded = big_floats(rounded_to_places(u, bits_), precision_);
  return BigFloat(1.0) / sqrt(norm(rounded)) * rounded;
}

Cubic CubicChain::chosen(std::size_t k, const Vector<Rational>& step, const FloatQuaternion& u0,
                         const FloatQuaternion& u1) const {
  const BigFloat tiny(power_of_two(-2 * bits_), precision_);
  const std::vector<Cubic> found = cubics(u0, u1, big_floats(3 * scale_ * step, precision_), tiny);
  if (static_cast<long>(found.size()) < solution_)
    throw DomainError(fmt::format("segment {}: there is {} PH cubic with these ends and tangents",
                                  k + 1, found.empty() ? "no" : "only one"));
  return found[static_cast<std::size_t>(solution_ - 1)];
}

std::optional<Construction> CubicChain::run(SplineBuilder& builder) const {
  const Rational root_of_scale = *square_root(scale_);
  const auto in_units = [&](const BigFloat& lambda) {
    return rounded_to_places(lambda, places_) / root_of_scale;
  };
  FloatQuaternion u = direction(0);
  ComplexOf<BigFloat> turn{BigFloat(1.0), BigFloat(0.0)};
  RationalQuaternion q = rounded_to_places(u, places_);
  builder.meter().direction(rotated_i(q), data_.derivatives[0]);
  for (std::size_t k = 0; k < data_.segments(); ++k) {
    const FloatQuaternion u1 = direction(k + 1);
    const Cubic cubic = chosen(k, builder.wanted(), u, u1);
    turn = cubic.turn * turn;
    const RationalQuaternion q1 = rounded_to_places(turned(u1, turn), places_);
    if (!builder.add({in_units(cubic.lambda0) * q, in_units(cubic.lambda1) * q1}, {1},
                     MultiplierFreedom::all))
      return std::nullopt;
    builder.meter().direction(rotated_i(q1), data_.derivatives[k + 1]);
    u = u1;
    q = q1;
  }
  return builder.finished(whole_parameters(data_), bits_);
}

}  // namespace

Construction cubic_spline(const HermiteSpline& data, long solution, const Deviation& tolerance,
                          PointRule rule) {
  constexpr int most_passes = 20;
  require_directions(data);
  const Rational finest =
      std::min(tolerance.derivatives, tolerance.points * scale_for_doubles(size_of_points(data)));
  return first_built(
      data, rule, tolerance, std::max(20L, 4 - binary_exponent(finest)), most_passes,
      [&](SplineBuilder& builder, long bits) {
        return CubicChain(data, solution, rule, bits).run(builder);
      },
      "the PH cubics: the points are too sensitive to their coefficients");
}

}  // namespace phrame
