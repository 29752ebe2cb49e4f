// Is V = Π zₖ/z̄ₖ, e to the i times twice Σ arg zₖ, a root of unity? Take the zₖ of one field
// ℚ(√−d) together, so that the fields are different. An automorphism of the field of all roots that
// maps √−dₖ to sₖ√−dₖ maps V to Π (zₖ/z̄ₖ)^sₖ, which is a root of unity if V is. The signs sⱼ and
// sₖ, j ≠ k, of all n automorphisms are different characters of their group, so that Σ sⱼsₖ = 0.
// Hence the product of the images of V, each to the power sⱼ, is (zⱼ/z̄ⱼ)ⁿ: V is a root of unity
// just where each zⱼ/z̄ⱼ is. It is one of ℚ(√−d), so of order 2 but for those of i, 4, and of √−3,
// 6: arg zⱼ is a multiple of π/2, or of π/4, π/6 there, and tan² arg zⱼ = y²d/x² is 0, ∞, or 1, 3,
// 1/3.

#include "phrame/algebra/algebraic_angle.hpp"

#include <algorithm>

#include "phrame/algebra/ball_order.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/algebra/surd.hpp"

namespace phrame::inline v0 {
namespace {

/// The one in (−1, 1] that differs from it by an even number.
Rational principal_half_turns(const Rational& x) { return x + Rational(2 * floor((1 - x) / 2)); }

/// arg(x + y·√−d)/π where it is rational.
std::optional<Rational> half_turns_of(const Integer& x, const Integer& y, const Integer& d) {
  if (y == 0) return x > 0 ? 0 : 1;
  if (x == 0) return Rational(y > 0 ? 1 : -1, 2);
  const Rational squared_tangent(Integer(y * y * d), Integer(x * x));
  Rational acute;
  if (squared_tangent == 1)
    acute = Rational(1, 4);
  else if (squared_tangent == 3)
    acute = Rational(1, 3);
  else if (squared_tangent == Rational(1, 3))
    acute = Rational(1, 6);
  else
    return std::nullopt;
  const Rational upper = x > 0 ? acute : Rational(1 - acute);
  return y > 0 ? upper : Rational(-upper);
}

}  // namespace

AlgebraicAngle AlgebraicAngle::argument(const Rational& x, const Rational& y, const Rational& d) {
  if (d.sign() <= 0 || (x == 0 && y == 0))
    throw DomainError("argument of x + y*sqrt(-d): it is 0, or d is not positive");
  // √(p/q) = √(pq)/q
  const Integer root_denominator(denominator(d));
  const Rational part = y / Rational(root_denominator);
  const Integer below = lcm(Integer(denominator(x)), Integer(denominator(part)));
  AlgebraicAngle angle;
  angle.multiply({Integer(numerator(Rational(x * Rational(below)))),
                  Integer(numerator(Rational(part * Rational(below)))),
                  Integer(numerator(d)) * root_denominator});
  return angle;
}

// √−e = (f/d)·√−d where √d·√e = f. A real factor is no matter but for its sign.
void AlgebraicAngle::multiply(const Factor& z) {
  Factor product = z;
  for (Factor& known : factors_) {
    const RootProduct root = multiply_roots(known.d, z.d);
    if (root.radicand != 1) continue;
    const Integer x = z.x * known.d;
    const Integer y = z.y * root.factor;
    product = {known.x * x - known.y * y * known.d, known.x * y + known.y * x, known.d};
    std::swap(known, factors_.back());
    factors_.pop_back();
    break;
  }
  const Integer common = gcd(product.x, product.y);
  product.x = product.x / common;
  product.y = product.y / common;
  if (product.y == 0) {
    if (product.x < 0) half_turns_ += 1;
    return;
  }
  factors_.push_back(std::move(product));
}

AlgebraicAngle operator+(AlgebraicAngle a, const AlgebraicAngle& b) {
  a.half_turns_ += b.half_turns_;
  for (const AlgebraicAngle::Factor& z : b.factors_) a.multiply(z);
  return a;
}

AlgebraicAngle operator-(AlgebraicAngle a) {
  a.half_turns_ = -a.half_turns_;
  for (AlgebraicAngle::Factor& z : a.factors_) z.y = -z.y;
  return a;
}

std::optional<Rational> AlgebraicAngle::half_turns() const {
  Rational sum = half_turns_;
  for (const Factor& z : factors_) {
    const auto part = half_turns_of(z.x, z.y, z.d);
    if (!part) return std::nullopt;
    sum += *part;
  }
  return principal_half_turns(sum);
}

// The rest is 0 or transcendental.
Real real_angle(Real::Enclosure enclosure, AngleForm form, long bits_of_origin) {
  const Rational radians = form.radians;
  const auto known = std::make_shared<const AngleForm>(std::move(form));
  const auto irrational = [&] { return Real(std::move(enclosure), {true, bits_of_origin, known}); };
  const long most_bits = 4096 + 4 * bits_of(radians);
  for (long bits = 64; bits <= most_bits; bits *= 2) {
    const RealBall rest = subtract(enclosure(bits), RealBall(radians, bits), bits);
    if (!rest.is_finite()) continue;
    if (!rest.contains_zero()) return irrational();
    if (!is_less(absolute(rest), RealBall(6, bits))) continue;  // 2π
    const auto angle = known->rest();
    if (!angle) break;
    if (angle->half_turns() == Rational(0)) return radians;
    return irrational();
  }
  return {std::move(enclosure), {false, bits_of_origin, known}};
}

std::optional<Rational> over_pi(const Real& x) {
  if (x.exact()) return *x.exact() == 0 ? std::optional<Rational>(0) : std::nullopt;
  const auto form = x.origin().angle;
  if (!form || form->radians != 0) return std::nullopt;
  const auto angle = form->rest();
  const auto half_turns = angle ? angle->half_turns() : std::nullopt;
  if (!half_turns) return std::nullopt;
  for (long bits = 64; bits <= 4096; bits *= 2) {
    const RealBall whole =
        subtract(divide(x.enclose(bits), pi(bits), bits), RealBall(*half_turns, bits), bits);
    if (const auto turns = unique_integer(times_power_of_two(whole, -1)))
      return *half_turns + Rational(2 * *turns);
  }
  return std::nullopt;
}

}  // namespace phrame
