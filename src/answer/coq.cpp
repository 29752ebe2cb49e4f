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

Effort effort(const RationalFunction& rate, const Rational& t, long digits) {
  const auto z = poles(rate.denominator());
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

}  // namespace

CoqAnswer answer(const Curve& curve, const CoqQuery& query) {
  const auto& [t, digits] = query;
  if (t <= 0) throw DomainError("proof: t = " + to_string(t) + " is not positive");
  if (count_real_roots(sigma(curve.preimage()), closed_interval(0, t)) > 0)
    throw DomainError("proof: the preimage has a zero between 0 and t = " + as_written(t) +
                      ", where h/sigma is undefined");
  const RmfAngle angle(curve);
  const Real value = angle.value(t);
  const Decimal shown = rounded(value, "theta", digits);
  const Rational theta = parse_rational(shown.value);
  const long leading = theta == 0 ? -1 : decimal_exponent(abs(theta));
  const Rational half_unit = power_of_ten(leading + 1 - digits) / 2;
  const Rational room = room_below(half_unit, value, theta);
  // No interval arithmetic proves a distance that is exactly the bound.
  if (room == 0) return answer(curve, {t, digits + 1});
  return {curve, t, shown, half_unit,
          effort(angle.rate(), t, std::max(digits, 1 - decimal_exponent(room)))};
}

}  // namespace phrame
