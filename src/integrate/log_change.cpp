#include "phrame/integrate/log_change.hpp"

#include <algorithm>
#include <map>

#include "phrame/algebra/algebraic_image.hpp"
#include "phrame/algebra/argument.hpp"
#include "phrame/algebra/ball_order.hpp"
#include "phrame/algebra/error.hpp"

namespace phrame::inline v0 {
namespace {

/// A rational point beyond which, towards the end, Re v has no zero.
Rational beyond_zeros(const GaussianPolynomial& v, Infinity end) {
  Rational bound = 1;  // Cauchy's bound
  for (long k = 0; k < v.re.degree(); ++k)
    bound = std::max(bound, Rational(1 + abs(v.re.coefficient(k) / v.re.leading_coefficient())));
  return end == Infinity::positive ? bound : Rational(-bound);
}

/// The value of v at the end up to a positive factor, for monic v, and a rational point for it: the
/// point itself, or one from which arg v changes by less than π/2 on the way to infinity.
struct At {
  GaussianRational value;
  Rational point;
};

At at(const GaussianPolynomial& v, const Endpoint& end) {
  if (const auto* t = std::get_if<Rational>(&end)) return {{v.re(*t), v.im(*t)}, *t};
  const Infinity infinity = std::get<Infinity>(end);
  const bool odd = infinity == Infinity::negative && v.re.degree() % 2 == 1;
  return {{odd ? -1 : 1, 0}, beyond_zeros(v, infinity)};
}

Rational size_at(const Polynomial& v, const Endpoint& end) {
  const auto* t = std::get_if<Rational>(&end);
  return t == nullptr ? Rational(1) : Rational(abs(v(*t)));
}

RealBall argument_of(const GaussianRational& z, long bits) { return argument(z.re, z.im, bits); }

/// The principal argument of z as r·π + sign·arctan(of).
struct PrincipalAngle {
  Rational pi;
  int sign = 0;
  Rational of;
};

PrincipalAngle angle(const GaussianRational& z) {
  if (z.re == 0) return {Rational(z.im > 0 ? 1 : -1, 2), 0, 0};
  const int side = z.im < 0 ? -1 : 1;
  const Rational turned = z.re < 0 ? side : 0;
  const Rational slope = z.im / z.re;
  if (slope == 0) return {turned, 0, 0};
  const int sign = slope < 0 ? -1 : 1;
  if (abs(slope) == 1) return {turned + Rational(sign, 4), 0, 0};
  return {turned, sign, abs(slope)};
}

}  // namespace

// The change of arg v between the two points is counted exactly; it differs from the sought one by
// less than π/2 at each infinite end. arg z, z = v(b)·conj v(a), differs from the sought change by
// whole turns, which therefore are the whole number nearest to the difference over 2π, if that
// difference is corrected by the small ones: those are principal arguments.
LogChange log_change(const GaussianLogs& logs, const Endpoint& a, const Endpoint& b) {
  if (!logs.others.empty()) throw DomainError("log_change: a residue is not in ℚ(i)");
  LogChange change;
  for (const auto& [factor, v] : logs.logarithms)
    change.sizes.push_back({{size_at(v, b) / size_at(v, a), 0}, factor});
  for (const GaussianLogs::Argument& term : logs.arguments) {
    const GaussianPolynomial& v = term.of;
    const At from = at(v, a);
    const At to = at(v, b);
    const auto value = [&v](const Rational& t) { return GaussianRational{v.re(t), v.im(t)}; };
    const GaussianRational z = to.value * conjugate(from.value);
    ContinuousArgument argument(v);
    for (long bits = 64;; bits *= 2) {
      RealBall turn = subtract(argument.difference(to.point, bits),
                               argument.difference(from.point, bits), bits);
      // On to infinity: from v(point) to v(end).
      const auto rest = [&](const At& end) {
        return argument_of(end.value * conjugate(value(end.point)), bits);
      };
      if (is_infinite(b)) turn = add(turn, rest(to), bits);
      if (is_infinite(a)) turn = subtract(turn, rest(from), bits);
      turn = subtract(turn, argument_of(z, bits), bits);
      turn = divide(turn, multiply(pi(bits), RealBall(2, bits), bits), bits);
      const auto whole = unique_integer(turn);
      if (!whole) continue;
      change.turns.push_back({{z, term.factor}, *whole});
      break;
    }
  }
  return change;
}

namespace {

/// The sum of the turns over π, where that is rational.
std::optional<Rational> turns_over_pi(const std::vector<LogChange::Turn>& turns) {
  std::vector<Power> powers;
  for (const auto& [power, whole] : turns) powers.push_back(power);
  if (!turns_are_rational(powers)) return std::nullopt;
  const Rational unit = Rational(1, 4) / Rational(common_denominator(powers));
  for (long bits = 64;; bits *= 2) {
    RealBall sum;
    for (const auto& [power, whole] : turns) {
      const RealBall angle = add(divide(argument_of(power.base, bits), pi(bits), bits),
                                 RealBall(Rational(2 * whole), bits), bits);
      sum = add(sum, multiply(RealBall(power.exponent / unit, bits), angle, bits), bits);
    }
    if (const auto multiple = unique_integer(sum)) return unit * *multiple;
  }
}

}  // namespace

std::optional<Rational> multiple_of_pi(const LogChange& change) {
  if (!sizes_cancel(change.sizes)) return std::nullopt;
  return turns_over_pi(change.turns);
}

ExactValue exact_value(const Rational& rational, const LogChange& change) {
  ExactValue value{rational, 0, {}, {}};
  const std::optional<Rational> turned = turns_over_pi(change.turns);
  if (turned == Rational(0) && sizes_cancel(change.sizes)) return value;
  std::map<Rational, Rational> logs;  // by factor > 0, arguments multiplied
  for (const auto& [base, exponent] : change.sizes) {
    if (exponent == 0 || abs(base.re) == 1) continue;
    Rational& of = logs.try_emplace(abs(exponent), 1).first->second;
    of *= exponent > 0 ? abs(base.re) : Rational(1 / abs(base.re));
  }
  for (const auto& [factor, of] : logs) {
    if (of > 1) value.logarithms.push_back({factor, of});
    if (of < 1) value.logarithms.push_back({-factor, 1 / of});
  }
  if (turned) {
    value.pi = *turned;
    return value;
  }
  std::map<Rational, Rational> arctangents;  // by argument, factors added
  for (const auto& [power, whole] : change.turns) {
    const PrincipalAngle principal = angle(power.base);
    value.pi += power.exponent * (principal.pi + Rational(2 * whole));
    if (principal.sign != 0) arctangents[principal.of] += principal.sign * power.exponent;
  }
  for (const auto& [of, factor] : arctangents)
    if (factor != 0) value.arctangents.push_back({factor, of});
  return value;
}

ExactValue exact_value(const Rational& rational, LogChange change, const RealAlgebraic& multiple) {
  const auto r = multiple.rational();
  if (r) change.turns.push_back({{{-1, 0}, *r}, 0});
  ExactValue value = exact_value(rational, change);
  if (!r) value.irrational_pi = affine(multiple, 1, std::exchange(value.pi, 0));
  return value;
}

}  // namespace phrame
