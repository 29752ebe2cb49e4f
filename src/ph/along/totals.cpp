#include "phrame/ph/along/totals.hpp"

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/surd.hpp"
#include "phrame/integrate/gaussian_logs.hpp"
#include "phrame/integrate/integrate.hpp"
#include "phrame/integrate/known_integral.hpp"
#include "phrame/integrate/taylor_integral.hpp"
#include "phrame/ph/along/rmf_angle.hpp"
#include "phrame/ph/along/total_rates.hpp"
#include "phrame/ph/curve/invariants.hpp"
#include "phrame/ph/curve/special_points.hpp"

namespace phrame::inline v0 {
namespace {

/// Is sgn(orientation)·rate odd about t = 1/2?
bool is_odd_about_middle(const RationalFunction& rate, const Polynomial& orientation) {
  const auto product = [&](const Rational& s, const Rational& t) {
    return abs(rate.numerator()(s) * rate.denominator()(t));
  };
  if (product(0, 1) != product(1, 0)) return false;  // for most rates
  const Polynomial mirror{1, -1};
  const RationalFunction mirrored = compose(rate, mirror);
  const Polynomial opposite = compose(orientation, mirror);
  return (opposite == orientation && mirrored == -rate) ||
         (opposite == -orientation && mirrored == rate);
}

/// √radicand · ∫₀¹ ±rate dt for the rate F′, + at first, the sign changing where that of the
/// orientation does.
CurveTotal total(const RationalFunction& rate, const FactoredIntegral& of,
                 const Polynomial& orientation, const Rational& radicand = 1,
                 bool has_no_poles = false) {
  CurveTotal result{radicand, rate, of.F, {}, Rational(0), ExactValue{}};
  for (const RealRoot& root : odd(real_roots(orientation, open_interval(0, 1))))
    result.sign_changes.push_back(root.at);

  if (is_odd_about_middle(rate, orientation)) return result;  // 0

  std::vector<Endpoint> ends{Rational(0)};
  ends.insert(ends.end(), result.sign_changes.begin(), result.sign_changes.end());
  ends.emplace_back(Rational(1));
  for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
    const Rational sign = k % 2 == 0 ? 1 : -1;
    const DefiniteIntegral part = definite_integral(of, rate, ends[k], ends[k + 1], has_no_poles);
    result.value = result.value + sign * part.value;
    if (result.exact && part.exact && !(result.exact->irrational_pi && part.exact->irrational_pi))
      result.exact = *result.exact + sign * *part.exact;
    else
      result.exact.reset();
  }
  if (result.exact && is_rational(*result.exact)) result.value = result.exact->rational;
  result.value = square_root_of(radicand) * result.value;
  return result;
}

/// With the sign of the orientation.
TotalRate oriented(RationalFunction rate, const Polynomial& orientation,
                   RationalFunction known = {}) {
  if (sign_after_zero(orientation) < 0) return {-rate, orientation, -known};
  return {std::move(rate), orientation, std::move(known)};
}

/// The rate without what is known of its integral, which is no logarithm.
RationalFunction unknown_rate(const TotalRate& of) {
  return of.known.is_zero() ? of.rate : of.rate - differentiate(of.known);
}

Antiderivative with_known(Antiderivative F, const TotalRate& of) {
  if (!of.known.is_zero()) F.rational = F.rational + of.known;
  return F;
}

FactoredIntegral integrate(const TotalRate& of) {
  FactoredIntegral result = factored_integral(unknown_rate(of));
  result.F = with_known(std::move(result.F), of);
  return result;
}

CurveTotal total(const TotalRate& of, const Rational& radicand = 1) {
  return total(of.rate, integrate(of), of.orientation, radicand);
}

/// Why a rate that is not negative has an infinite integral.
std::optional<Infinite> pole_on_path(const RationalFunction& rate) {
  const auto poles = real_roots(rate.denominator(), closed_interval(0, 1));
  if (poles.empty()) return std::nullopt;
  return Infinite{poles.front().at};
}

/// Of a rate that is not negative, whose integral may be infinite.
std::variant<CurveTotal, Infinite> energy(const TotalRate& of) {
  if (const auto infinite = pole_on_path(of.rate)) return *infinite;
  return total(of.rate, integrate(of), of.orientation, 1, true);
}

/// The torsion τ·ds/dt is that of the twist and (arg bend)′.
struct TorsionParts {
  RationalFunction twist;
  GaussianPolynomial bend;
};

TorsionParts torsion_parts(const Curve& curve) {
  const QuaternionPolynomial& a = curve.preimage();
  if (sign_after_zero(curve.multiplier()) > 0) return {-rate_to_erf(a), conjugate(regular_bend(a))};
  return {rate_to_erf(a), regular_bend(a)};
}

/// ∫ rate for the rate `twist` + (arg bend)′, as integrate() has it. Where no residue of `twist` is
/// ±i/2 and no pole is a zero of the bend, the argument of the bend is that part of the integral
/// whose residues are ±i/2, so that nothing is to be found out.
Antiderivative integrate_turning(const TorsionParts& parts, const RationalFunction& rate) {
  const auto& [twist, bend] = parts;
  const Polynomial& n = twist.numerator();
  const Polynomial& d = twist.denominator();
  const Polynomial slope = differentiate(d);
  const Polynomial zeros = norm(bend);
  const bool is_separate = degree(bend) > 1 && twist.is_proper() && is_squarefree(d) &&
                           is_squarefree(zeros) && gcd(d, zeros).is_constant() &&
                           gcd(d, Rational(4) * n * n + slope * slope).is_constant();
  if (!is_separate) return integrate(rate);
  Antiderivative F = integrate(twist);
  F.logs.insert(F.logs.begin(), argument_as_logs(bend));
  if (!(differentiate(F) == rate))
    throw Error("total torsion: the check failed, the derivative is not the rate");
  return F;
}

/// That of the multiplier, where a polynomial curve has one all along (0, 1).
std::optional<Rational> constant_sign(const Curve& curve) {
  const Polynomial& f = curve.multiplier();
  if (!curve.is_polynomial()) return std::nullopt;
  if (!f.is_constant() && !odd(real_roots(f, open_interval(0, 1))).empty()) return std::nullopt;
  return Rational(sign_after_zero(f));
}

/// The numerator of τ·fσ = …/(σρ).
const Polynomial& turning(const Curve& curve, const TotalPoles& poles) {
  return poles.turning.get([&] {
    const auto [of_bend, of_speed] = closed_split(curve.preimage());
    return of_bend * poles.rho.polynomial() + of_speed * poles.sigma.polynomial();
  });
}

}  // namespace

CurveTotal total_length(const Curve& curve) {
  const Polynomial speed = curve.multiplier() * sigma(curve.preimage());
  return total(oriented({speed, pow(curve.weight(), 2)}, curve.multiplier()));
}

TotalRate erf_twist_rate(const Curve& curve) {
  return {-rate_to_erf(curve.preimage()), Polynomial{1}};
}

CurveTotal erf_twist(const Curve& curve) { return total(erf_twist_rate(curve)); }

TotalRate bending_energy_rate(const Curve& curve) {
  const Polynomial& f = curve.multiplier();
  const Polynomial speed = sigma(curve.preimage());
  return oriented({rho(curve.preimage()) * pow(curve.weight(), 2), f * pow(speed, 3)}, f);
}

std::variant<CurveTotal, Infinite> bending_energy(const Curve& curve) {
  return energy(bending_energy_rate(curve));
}

// τ fσ is 2h/σ − b with b = Im(g′/g), N = |g|² and
//   b² = ½ Re(g′/g)′ − ½ Re(g″/g) + |g′|²/(2N),  Re(g′/g) = N′/(2N),
// so that b²/(fσ) is (N′/(4N·fσ))′ plus what has N in the denominator only once: the rational part
// of the integral is known as far as N is in it.
TotalRate frenet_energy_rate(const Curve& curve) {
  const QuaternionPolynomial& a = curve.preimage();
  const Polynomial& f = curve.multiplier();
  if (!curve.is_polynomial()) return oriented(frenet_rate_by_t(curve), f);
  const Polynomial size = norm(regular_bend(a));
  return oriented(frenet_rate_by_t(curve), f,
                  {differentiate(size), Rational(4) * size * f * sigma(a)});
}

std::variant<CurveTotal, Infinite> frenet_energy(const Curve& curve) {
  return energy(frenet_energy_rate(curve));
}

TotalRate total_torsion_rate(const Curve& curve) {
  const auto [twist, bend] = torsion_parts(curve);
  return {twist + rate_of_argument(bend), curve.multiplier()};
}

CurveTotal total_torsion(const Curve& curve) {
  const TotalRate of = total_torsion_rate(curve);
  return total(of.rate, {integrate_turning(torsion_parts(curve), of.rate), {}}, of.orientation);
}

TotalPoles total_poles(const Curve& curve) {
  return {sigma(curve.preimage()), rho(curve.preimage())};
}

std::optional<FactoredFunction> bending_energy_factors(const Curve& curve,
                                                       const TotalPoles& poles) {
  const auto sign = constant_sign(curve);
  if (!sign) return std::nullopt;
  return FactoredFunction{*sign * poles.rho.polynomial(),
                          {{curve.multiplier(), 1}, {poles.sigma, 3}}};
}

std::optional<FactoredFunction> frenet_energy_factors(const Curve& curve, const TotalPoles& poles) {
  const auto sign = constant_sign(curve);
  if (!sign || poles.rho.polynomial().is_zero()) return std::nullopt;
  return FactoredFunction{*sign * (pow(poles.rho.polynomial(), 3) + pow(turning(curve, poles), 2)),
                          {{curve.multiplier(), 1}, {poles.sigma, 3}, {poles.rho, 2}}};
}

std::optional<FactoredFunction> total_torsion_factors(const Curve& curve, const TotalPoles& poles) {
  const auto sign = constant_sign(curve);
  if (!sign || poles.rho.polynomial().is_zero()) return std::nullopt;
  return FactoredFunction{*sign * turning(curve, poles), {{poles.sigma, 1}, {poles.rho, 1}}};
}

std::optional<FactoredFunction> erf_twist_factors(const Curve& curve, const TotalPoles& poles) {
  if (!curve.is_polynomial()) return std::nullopt;
  return FactoredFunction{Rational(2) * twist_numerator(curve.preimage()), {{poles.sigma, 1}}};
}

std::optional<Real> value_without_closed_form(const TotalRate& of) {
  if (!odd(real_roots(of.orientation, open_interval(0, 1))).empty()) return std::nullopt;
  if (count_real_roots(of.rate.denominator(), closed_interval(0, 1)) > 0) return std::nullopt;
  return TaylorIntegral({of.rate.numerator(), of.rate.denominator()}).value(1);
}

Rational without_logarithms(const TotalRate& of) {
  const Antiderivative F = with_known(algebraic_part(unknown_rate(of)).F, of);
  return difference_without_logarithms(F, 0, 1);
}

std::optional<CurveTotal> total_curvature(const Curve& curve) {
  const auto square = double_ph(curve.preimage());
  if (!square) return std::nullopt;
  const RationalFunction rate(square->omega, sigma(curve.preimage()));
  if (square->constant == 0) return total(TotalRate{{}, Polynomial{1}});
  // √(n/d) = (root/d)·√rest for nd = root²·rest.
  const Integer d(denominator(square->constant));
  const auto [root, rest] = split_square(Integer(numerator(square->constant)) * d);
  return total(oriented(RationalFunction(Polynomial{Rational(root, d)}) * rate, square->omega),
               Rational(rest));
}

}  // namespace phrame
