// On a part [c − r, c + r] of [0, t] a Taylor polynomial of degree d is off by about (r/R)^(d+1), R
// the distance of c to the next pole of h/σ. Parts are halved until that is small enough; this is
// what the tactic does, too, so that their number bounds its fuel. Nothing is proved here: a wrong
// guess makes coqc fail or take long, not accept.
#include "phrame/answer/coq.hpp"

#include <algorithm>
#include <cmath>
#include <complex>

#include "phrame/algebra/as_written.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/algebra/roots.hpp"
#include "phrame/answer/rounded.hpp"
#include "phrame/ph/along/rmf_angle.hpp"

namespace phrame::inline v0 {
namespace {

using Effort = CoqAnswer::Effort;

std::vector<std::complex<double>> poles(const Polynomial& d) {
  std::vector<std::complex<double>> list;
  if (d.is_constant()) return list;
  const auto middle = [](const RealBall& x) { return round_to_double(x.midpoint()); };
  const Roots roots = isolate_roots(squarefree_part(d), 64);
  for (const RealBall& x : roots.real) list.emplace_back(middle(x), 0.0);
  for (const ComplexBall& z : roots.upper) list.emplace_back(middle(z.re()), middle(z.im()));
  return list;
}

/// The number of parts of [a, b] that are needed.
long parts(double a, double b, const std::vector<std::complex<double>>& poles, long degree,
           double log_error) {
  const double c = (a + b) / 2;
  const double r = (b - a) / 2;
  double log_ratio = 0;
  for (const auto& z : poles) log_ratio = std::max(log_ratio, r / std::abs(z - c));
  log_ratio = std::log10(log_ratio);
  if (poles.empty() || static_cast<double>(degree + 1) * log_ratio < log_error || r < 1e-9)
    return 1;
  return parts(a, c, poles, degree, log_error) + parts(c, b, poles, degree, log_error);
}

Effort effort(const std::vector<std::complex<double>>& z, const Rational& t, long digits) {
  const double end = round_to_double(t);
  Effort best{static_cast<long>(3.33 * static_cast<double>(digits)) + 40, 0, 0};
  double least = HUGE_VAL;
  for (long degree = 8; degree <= 60; degree += 4) {
    const long count = parts(0, end, z, degree, -static_cast<double>(digits) - 3);
    const double cost = static_cast<double>(count * degree * degree * degree);
    if (cost >= least) continue;
    least = cost;
    best.degree = degree;
    best.fuel = 3 * count + 20;
  }
  return best;
}

/// bound − |value − theta|, to some digits, for a theta that is no farther from it than the bound;
/// 0 only where that is so.
Rational room_below(const Rational& bound, const Real& value, const Rational& theta) {
  if (value.exact()) return bound - abs(*value.exact() - theta);
  for (long bits = 64 + 2 * std::max(0L, -binary_exponent(bound));; bits *= 2) {
    const RealBall off = absolute(subtract(value.enclose(bits), RealBall(theta, bits), bits));
    const Rational room = bound - off.upper();
    if (room > 0 && bound - off.lower() < 2 * room) return room;
  }
}

/// c with Σ c·p = gcd, where that is constant; no value otherwise.
template <std::size_t n>
std::optional<std::array<Polynomial, n>> cofactors(const std::array<Polynomial, n>& list) {
  std::array<Polynomial, n> c;
  Polynomial g;
  for (std::size_t k = 0; k < n && (g.is_zero() || !g.is_constant()); ++k) {
    const ExtendedGcd next = extended_gcd(g, list[k]);
    for (std::size_t i = 0; i < k; ++i) c[i] *= next.s;
    c[k] = next.t;
    g = next.g;
  }
  if (!g.is_constant()) return std::nullopt;
  return c;
}

CoqAnswer::Fraction fraction(const Polynomial& numerator, const Polynomial& denominator) {
  RationalFunction lowest(numerator, denominator);
  Polynomial common = exact_quotient(denominator, lowest.denominator());
  return {std::move(lowest), std::move(common)};
}

/// An interval around [0, t] that is as far from the zeros as it is wide beyond its ends, or
/// farther.
std::optional<CoqAnswer::Domain> domain(const Polynomial& zeros, const Rational& t) {
  if (zeros.is_constant()) return std::nullopt;
  Rational beyond = t / 4;
  while (count_real_roots(zeros, closed_interval(-2 * beyond, t + 2 * beyond)) > 0) beyond /= 2;
  return CoqAnswer::Domain{-beyond, t + beyond};
}

/// What must have no zero in [0, t], where the theorem would be about nothing.
const Polynomial& without_zeros(const Polynomial& p, const Rational& t, const std::string& what,
                                const std::string& why = "") {
  if (count_real_roots(p, closed_interval(0, t)) > 0)
    throw DomainError("proof: " + what + " between 0 and t = " + as_written(t) + why);
  return p;
}

}  // namespace

CoqAnswer answer(const Curve& curve, const CoqQuery& query) {
  const auto& [t, digits, reference, start] = query;
  if (t <= 0) throw DomainError("proof: t = " + to_string(t) + " is not positive");
  const QuaternionPolynomial& a = curve.preimage();
  const bool is_frenet = reference == Reference::frenet;
  Polynomial zeros = without_zeros(gcd(gcd(a.u, a.v), gcd(a.p, a.q)), t, "the preimage has a zero",
                                   ", where h/sigma is undefined") *
                     without_zeros(curve.weight(), t, "the curve has a point at infinity");
  const RmfAngle angle(curve, reference);  // where it throws for a straight line
  const GaussianPolynomial g = is_frenet ? bend_numerator(a) : GaussianPolynomial{};
  if (is_frenet)
    zeros *= without_zeros(gcd(g.re, g.im), t, "the curve has an inflection",
                           ", where the normal jumps");
  const FrameAngle at_zero = start_angle(start, curve, reference);
  const Real value = angle.value(t, at_zero);
  const Decimal shown = rounded(value, "theta", digits);
  const Rational theta = parse_rational(shown.value);
  const long leading = theta == 0 ? -1 : decimal_exponent(abs(theta));
  const Rational half_unit = power_of_ten(leading + 1 - digits) / 2;
  const Rational room = room_below(half_unit, value, theta);
  // No interval arithmetic proves a distance that is exactly the bound.
  if (room == 0) return answer(curve, {t, digits + 1, reference, start});
  CoqAnswer result{curve,
                   reference,
                   t,
                   at_zero,
                   shown,
                   half_unit,
                   domain(zeros, t),
                   cofactors(std::array{a.u, a.v, a.p, a.q}),
                   {},
                   fraction(Rational(-2) * twist_numerator(a), sigma(a)),
                   {},
                   {}};
  auto z = poles(result.rate.lowest.denominator());
  if (is_frenet) {
    result.bend_cofactors = cofactors(std::array{g.re, g.im});
    result.bend_rate = fraction(g.re * differentiate(g.im) - g.im * differentiate(g.re),
                                g.re * g.re + g.im * g.im);
    for (const auto& pole : poles(result.bend_rate->lowest.denominator())) z.push_back(pole);
  }
  result.effort = effort(z, t, std::max(digits, 1 - decimal_exponent(room)));
  return result;
}

}  // namespace phrame
