#include "phrame/ph/twist/frame_weight.hpp"

#include <algorithm>
#include <array>
#include <map>

#include "phrame/algebra/ball_order.hpp"
#include "phrame/algebra/disc_evaluation.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/algebra/numerical_integral.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/ph/along/rmf_angle.hpp"
#include "phrame/ph/curve/invariants.hpp"
#include "phrame/ph/curve/special_points.hpp"

namespace phrame::inline v0 {
namespace {

/// A part of [0, 1] on which a polynomial has one sign.
struct SignedPart {
  RealBall from;
  RealBall to;
  int sign;
};

/// Those between the sign changes of p ≠ 0, of which there is a ball around each.
std::vector<SignedPart> signed_parts(const Polynomial& p, long bits) {
  std::vector<RealAlgebraic> ends{Rational(0)};
  if (p.degree() > 0)
    for (const RealRoot& root : odd(real_roots(p, open_interval(0, 1)))) ends.push_back(root.at);
  ends.emplace_back(Rational(1));
  std::vector<SignedPart> parts;
  for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
    const int sign = parts.empty() ? sign_after_zero(p) : -parts.back().sign;
    parts.push_back({enclose(ends[k], bits), enclose(ends[k + 1], bits), sign});
  }
  return parts;
}

/// ∫₀¹ |p|·tᵏ dt.
std::vector<RealBall> polynomial_moments(const Polynomial& p, long count, long bits) {
  std::vector<RealBall> moments;
  const std::vector<SignedPart> parts = signed_parts(p, bits);
  for (long k = 0; k < count; ++k) {
    const Polynomial sum = antiderivative(p * Polynomial::monomial(1, k));
    RealBall moment;
    for (const auto& [from, to, sign] : parts) {
      const RealBall part = subtract(evaluate(sum, to, bits), evaluate(sum, from, bits), bits);
      moment = add_product(moment, RealBall(sign, bits), part, bits);
    }
    moments.push_back(moment);
  }
  return moments;
}

/// |τκ| = |T|/(f²σ⁴√ρ), T = 2hρ − 4 Im(g′ḡ)σ, where g = c·g₁ has the greatest real factor c:
/// T = c²T₁ and √ρ = 2|c|·|g₁|, so that |τκ| = |cT₁|/(f²σ⁴√(4|g₁|²)).
struct TorsionCurvature {
  Polynomial numerator;    ///< cT₁
  Polynomial denominator;  ///< f²σ⁴
  Polynomial squared;      ///< 4|g₁|², > 0 on ℝ

  explicit TorsionCurvature(const Curve& curve) {
    const QuaternionPolynomial& preimage = curve.preimage();
    const GaussianPolynomial g = bend_numerator(preimage);
    const auto [a, b] = closed_split(preimage);
    const Polynomial s = sigma(preimage);
    const Polynomial triple = a * rho(preimage) + b * s;
    if (triple.is_zero()) throw DomainError("the weight |τκ| is 0 everywhere: the curve is plane");
    const auto found = cusps(curve);
    if (!found.empty())
      throw DomainError("the weight |τκ| is infinite at " + place_text("t", found.front().at) +
                        ": a cusp");
    const Polynomial content = phrame::gcd(g.re, g.im);
    numerator = exact_quotient(triple, content);
    denominator = curve.multiplier() * curve.multiplier() * pow(s, 4);
    squared = exact_quotient(rho(preimage), content * content);
  }

  /// An e with a weight of about 2ᵉ where it is greatest.
  long size() const {
    constexpr long bits = 128;
    constexpr long points = 16;
    long most = -unbounded_exponent;
    for (long k = 0; k <= points; ++k) {
      const RealBall t(Rational(k, points), bits);
      const RealBall root = sqrt(evaluate(squared, t, bits), bits);
      const RealBall below = multiply(evaluate(denominator, t, bits), root, bits);
      most = std::max(most, exponent_above(divide(evaluate(numerator, t, bits), below, bits)));
    }
    return most == unbounded_exponent ? 0 : most;
  }
};

/// cT₁/(f²σ⁴√(4|g₁|²)), whose values are kept: the quadratures of all moments meet the same points.
class TorsionCurvatureValues {
 public:
  TorsionCurvatureValues(const TorsionCurvature& weight, long size, long precision)
      : numerator_(BallPolynomial(power_of_two(-size) * weight.numerator, precision)),
        denominator_(BallPolynomial(weight.denominator, precision)),
        squared_(BallPolynomial(weight.squared, precision)) {}

  const ComplexBall& operator()(const ComplexBall& z, long bits) {
    Value& known = values_[{approximate(z.re()), approximate(z.im()),
                            approximate(radius_of(z.re())), approximate(radius_of(z.im()))}];
    if (known.bits != bits || !known.z.is_same_ball(z)) {
      const ComplexBall root = integrand_sqrt(squared_(z, bits), bits);
      known = {bits, z,
               divide(numerator_(z, bits), multiply(denominator_(z, bits), root, bits), bits)};
    }
    return known.value;
  }

 private:
  struct Value {
    long bits = 0;
    ComplexBall z;
    ComplexBall value;
  };
  IntegrandPolynomial numerator_;
  IntegrandPolynomial denominator_;
  IntegrandPolynomial squared_;
  std::map<std::array<double, 4>, Value> values_;
};

std::vector<RealBall> torsion_curvature_moments(const Curve& curve, long count, long bits) {
  const TorsionCurvature weight(curve);
  const long size = weight.size();
  const long precision = bits + 64 + 4 * weight.denominator.degree();
  const auto parts = signed_parts(weight.numerator, precision);
  TorsionCurvatureValues values(weight, size, precision);
  std::vector<RealBall> moments;
  for (long k = 0; k < count; ++k) {
    const auto integrand = [&](const ComplexBall& z, long working) {
      ComplexBall product = values(z, working);
      for (long factor = 0; factor < k; ++factor) product = multiply(product, z, working);
      return product;
    };
    RealBall moment;
    for (const auto& [from, to, sign] : parts)
      moment = add_product(moment, RealBall(sign, precision),
                           numerical_integral(integrand, from, to, {bits + 32, precision, 100'000}),
                           precision);
    moments.push_back(times_power_of_two(moment, size));
  }
  return moments;
}

}  // namespace

Curve with_primitive_preimage(const Curve& curve) {
  const Polynomial content = real_content(curve.preimage());
  return curve.with_form(without_real_content(curve.preimage()),
                         curve.multiplier() * content * content);
}

std::vector<RealBall> weight_moments(const Curve& curve, FrameWeight weight, long count,
                                     long bits) {
  if (weight == FrameWeight::one) return polynomial_moments({1}, count, bits);
  if (!curve.is_polynomial()) throw DomainError("frame weight: the curve is rational");
  const Curve primitive = with_primitive_preimage(curve);
  if (weight == FrameWeight::torsion_curvature)
    return torsion_curvature_moments(primitive, count, bits);
  return polynomial_moments(primitive.multiplier() * sigma(primitive.preimage()), count, bits);
}

}  // namespace phrame
