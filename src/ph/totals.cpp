#include "phrame/ph/totals.hpp"

#include "phrame/algebra/surd.hpp"
#include "phrame/integrate/integrate.hpp"
#include "phrame/ph/frame.hpp"
#include "phrame/ph/invariants.hpp"
#include "phrame/ph/rmf_angle.hpp"
#include "phrame/ph/shape.hpp"

namespace phrame {
namespace {

/// Is sgn(orientation)·rate odd about t = 1/2?
bool is_odd_about_middle(const RationalFunction& rate, const Polynomial& orientation) {
  const Polynomial mirror{1, -1};
  const RationalFunction mirrored(compose(rate.numerator(), mirror),
                                  compose(rate.denominator(), mirror));
  const Polynomial opposite = compose(orientation, mirror);
  return (opposite == orientation && mirrored == -rate) ||
         (opposite == -orientation && mirrored == rate);
}

/// √radicand · ∫₀¹ sgn(orientation)·rate dt.
Total total(RationalFunction rate, const Polynomial& orientation, const Rational& radicand = 1) {
  if (sign_after_zero(orientation) < 0) rate = -rate;
  Total result{radicand, rate, integrate(rate), {}, Rational(0), ExactValue{}};
  for (const RealRoot& root : real_roots(orientation, open(0, 1)))
    if (root.order % 2 == 1) result.turns.push_back(root.at);

  if (is_odd_about_middle(rate, orientation)) return result;  // 0

  std::vector<Endpoint> ends{Rational(0)};
  ends.insert(ends.end(), result.turns.begin(), result.turns.end());
  ends.emplace_back(Rational(1));
  for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
    const Rational sign = k % 2 == 0 ? 1 : -1;
    const DefiniteIntegral part = definite_integral(result.antiderivative, ends[k], ends[k + 1]);
    result.value = result.value + sign * part.value;
    if (result.exact && part.exact)
      result.exact = *result.exact + sign * *part.exact;
    else
      result.exact.reset();
  }
  if (result.exact && *result.exact == ExactValue{result.exact->rational, 0, {}, {}})
    result.value = result.exact->rational;
  result.value = square_root_of(radicand) * result.value;
  return result;
}

/// The same of a rate that is not negative where the orientation is positive.
std::variant<Total, Infinite> nonnegative_total(const RationalFunction& rate,
                                                const Polynomial& orientation) {
  const auto poles = real_roots(rate.denominator(), closed(0, 1));
  if (!poles.empty()) return Infinite{poles.front().at};
  return total(rate, orientation);
}

}  // namespace

Total total_length(const Curve& curve) {
  const Polynomial speed = curve.multiplier() * sigma(curve.preimage());
  return total(RationalFunction(speed), curve.multiplier());
}

Total erf_twist(const Curve& curve) { return total(-erf_rate(curve.preimage()), Polynomial{1}); }

std::variant<Total, Infinite> bending_energy(const Curve& curve) {
  const QuaternionPolynomial& a = curve.preimage();
  return nonnegative_total({rho(a), curve.multiplier() * pow(sigma(a), 3)}, curve.multiplier());
}

std::variant<Total, Infinite> frenet_energy(const Curve& curve) {
  const Polynomial speed = curve.multiplier() * sigma(curve.preimage());
  return nonnegative_total(squared_frenet_rate(curve) * RationalFunction(speed),
                           curve.multiplier());
}

Total total_torsion(const Curve& curve) {
  return total(-frenet_rate(curve.preimage()), curve.multiplier());
}

std::optional<Total> total_curvature(const Curve& curve) {
  const auto square = double_ph(curve.preimage());
  if (!square) return std::nullopt;
  const RationalFunction rate(square->omega, sigma(curve.preimage()));
  if (square->constant == 0) return total({}, Polynomial{1});
  // √(n/d) = (root/d)·√rest for nd = root²·rest.
  const Integer d(denominator(square->constant));
  const auto [root, rest] = split_square(Integer(numerator(square->constant)) * d);
  return total(RationalFunction(Polynomial{Rational(root, d)}) * rate, square->omega,
               Rational(rest));
}

// The tangents at the ends are rational vectors. Between them the tangent turns by ±α up to whole
// turns, where it does not turn back; and an angle α with a rational cosine is a rational multiple
// of π only for cos α = 0, ±1/2 and ±1 (Niven), that is a multiple of π/6.
std::optional<Real> absolute_rotation_index(const Curve& curve) {
  if (!plane_normal(curve.preimage())) return std::nullopt;
  const Total curvature = total_curvature(curve).value();  // ρ of a plane curve is a square
  if (curvature.value.exact() == Rational(0)) return Real(Rational(0));
  if (const auto& x = curvature.exact; x && *x == ExactValue{0, x->pi, {}, {}})
    return square_root_of(curvature.radicand) * Rational(x->pi / 2);
  const Real index = curvature.value * Real([](long bits) {
                       return divide(RealBall(Rational(1, 2), bits), pi(bits), bits);
                     });
  if (!curvature.turns.empty()) return index;
  const Frame<Rational> start = euler_rodrigues_frame(curve, 0);
  const Frame<Rational> end = euler_rodrigues_frame(curve, 1);
  Rational cosine = 0;
  for (std::size_t k = 0; k < 3; ++k) cosine += start.e1[k] * end.e1[k];
  if (cosine != 0 && abs(cosine) != 1 && abs(cosine) != Rational(1, 2)) return index;
  for (long bits = 64;; bits *= 2) {
    const RealBall twelfths = multiply(RealBall(12, bits), index.enclose(bits), bits);
    flint::Fmpz nearest;
    if (arb_get_unique_fmpz(nearest.get(), twelfths.raw()) != 0)
      return Real(Rational(nearest.get()) / 12);
  }
}

}  // namespace phrame
