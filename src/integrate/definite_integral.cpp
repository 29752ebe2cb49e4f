// F = polynomial + rational + Σ c(z) log(t − z). An integral to ±∞ exists iff f = O(t⁻²): then
// polynomial = 0, rational → 0 and Σ c(z) = 0, so that the logarithms have a limit.
#include "phrame/integrate/definite_integral.hpp"

#include <fmt/format.h>

#include <memory>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/factor.hpp"
#include "phrame/algebra/resultant.hpp"
#include "phrame/integrate/definite.hpp"
#include "phrame/integrate/integrate.hpp"
#include "phrame/integrate/lazard_rioboo_trager.hpp"
#include "phrame/integrate/rothstein_trager.hpp"

namespace phrame {
namespace {

bool is_infinite(const Endpoint& end) { return std::holds_alternative<Infinity>(end); }

std::optional<Rational> rational(const Endpoint& end) {
  if (const auto* r = std::get_if<Rational>(&end)) return *r;
  if (const auto* a = std::get_if<RealAlgebraic>(&end)) return a->rational();
  return std::nullopt;
}

/// An algebraic number that is rational as a rational number.
Endpoint simplified(const Endpoint& end) {
  const auto r = rational(end);
  return r ? Endpoint(*r) : end;
}

/// A rational or infinite point on the given side of the end, or the end itself.
std::optional<Rational> outer(const Endpoint& end, bool below) {
  if (const auto* a = std::get_if<RealAlgebraic>(&end))
    return below ? a->interval().lower : a->interval().upper;
  return rational(end);
}

/// The real poles in [low, high], isolated.
std::vector<Interval> poles_between(const Polynomial& d, const Endpoint& low,
                                    const Endpoint& high) {
  std::vector<Interval> found;
  for (const Interval& at : located_real_roots(d, {outer(low, true), outer(high, false)})) {
    if (std::holds_alternative<RealAlgebraic>(low) || std::holds_alternative<RealAlgebraic>(high)) {
      const Endpoint pole = simplified(real_root(d, at));
      if (compare(pole, low) < 0 || compare(pole, high) > 0) continue;
    }
    found.push_back(at);
  }
  return found;
}

std::string place(const Interval& pole) {
  return fmt::format("t {} {}", pole.lower == pole.upper ? "=" : "in", to_string(pole));
}

bool is_pole(const Polynomial& d, const Endpoint& end) {
  if (is_infinite(end)) return false;
  if (const auto r = rational(end)) return d(*r) == 0;
  return sign_at(d, std::get<RealAlgebraic>(end)) == 0;
}

void require_integrable(const RationalFunction& f, const Endpoint& a, const Endpoint& b,
                        AtPoles at_poles) {
  const bool forward = compare(a, b) <= 0;
  const Endpoint& low = forward ? a : b;
  const Endpoint& high = forward ? b : a;
  const bool principal = at_poles == AtPoles::principal_value;
  const long order = f.denominator().degree() - f.numerator().degree();
  const bool symmetric = principal && is_infinite(a) && is_infinite(b) && order == 1;
  if ((is_infinite(a) || is_infinite(b)) && order < 2 && !symmetric)
    throw DomainError(fmt::format(
        "definite integral: it diverges at {}, where the integrand is about {}·t^{}",
        is_infinite(high) ? "∞" : "−∞",
        to_string(
            Rational(f.numerator().leading_coefficient() / f.denominator().leading_coefficient())),
        -order));
  if (f.is_polynomial()) return;
  const auto poles = poles_between(f.denominator(), low, high);
  if (poles.empty()) return;
  if (!principal)
    throw DomainError(fmt::format("definite integral: pole at {}", place(poles.front())));
  for (const Endpoint* end : {&low, &high})
    if (is_pole(f.denominator(), *end))
      throw DomainError(fmt::format("principal value: pole at an end, at {}",
                                    place(end == &low ? poles.front() : poles.back())));
  for (const auto& [base, exponent] : squarefree_factorization(f.denominator()).factors)
    for (const Interval& pole : poles)
      if (exponent > 1 && count_real_roots(base, pole) > 0)
        throw DomainError(
            fmt::format("principal value: pole of order {} at {}", exponent, place(pole)));
}

/// f(−t) = −f(t), or 0.
bool is_odd(const RationalFunction& f) {
  const Polynomial reflected{0, -1};
  return RationalFunction(compose(f.numerator(), reflected), compose(f.denominator(), reflected)) ==
         -f;
}

bool are_opposite(const Endpoint& a, const Endpoint& b) {
  if (is_infinite(a) || is_infinite(b)) return is_infinite(a) && is_infinite(b);
  const auto as_algebraic = [](const Endpoint& end) {
    const auto r = rational(end);
    return r ? RealAlgebraic(*r) : std::get<RealAlgebraic>(end);
  };
  const RealAlgebraic x = as_algebraic(a);
  const Interval& i = x.interval();
  const RealAlgebraic minus = real_root(compose(x.polynomial(), Polynomial{0, -1}),
                                        {-*i.upper, -*i.lower, i.upper_closed, i.lower_closed});
  return minus == as_algebraic(b);
}

/// F(x) for the algebraic x: the root, near its value, of the characteristic polynomial of F(x) in
/// ℚ[t]/(p), a power of an irreducible one.
RealAlgebraic image(const RationalFunction& F, const Endpoint& end) {
  if (const auto r = rational(end)) return {F(*r)};
  const RealAlgebraic& x = std::get<RealAlgebraic>(end);
  const QuotientRing ring(x.polynomial());
  const Polynomial y = ring.multiply(F.numerator(), ring.inverse(ring.reduce(F.denominator())));
  if (y.is_constant()) return {y.coefficient(0)};
  const Polynomial p = squarefree_part(
      residue_polynomial(ring.multiply(y, differentiate(x.polynomial())), x.polynomial()));
  for (long bits = 64;; bits *= 2) {
    const RealBall value = evaluate(y, {enclose(x, bits), {}}, bits).re();
    if (!value.is_finite()) continue;
    const Interval around = closed(value.lower(), value.upper());
    if (count_real_roots(p, around) == 1) return real_root(p, around);
  }
}

/// F(b) − F(a), where it is rational. If so, the two have polynomials of the same degree n, shifted
/// by it; it is the difference of their mean conjugates −c_{n−1}/(n·c_n).
std::optional<Rational> rational_difference(const RationalFunction& F, const Endpoint& a,
                                            const Endpoint& b) {
  const RealAlgebraic from = image(F, a);
  const RealAlgebraic to = image(F, b);
  const long n = from.polynomial().degree();
  if (to.polynomial().degree() != n) return std::nullopt;
  const auto mean = [n](const Polynomial& p) {
    return Rational(-p.coefficient(n - 1) / (n * p.leading_coefficient()));
  };
  const Rational shift = mean(to.polynomial()) - mean(from.polynomial());
  const Interval& i = from.interval();
  const RealAlgebraic shifted =
      real_root(compose(from.polynomial(), Polynomial{-shift, 1}),
                {*i.lower + shift, *i.upper + shift, i.lower_closed, i.upper_closed});
  return shifted == to ? std::optional(shift) : std::nullopt;
}

/// What is known exactly; `rational` is the part without logarithms.
std::optional<ExactValue> in_finite_terms(const Antiderivative& F, const Rational& rational,
                                          const Endpoint& a, const Endpoint& b) {
  std::vector<LogSum> sums;
  for (const LogSum& sum : F.logs)
    for (const SimpleFraction& f : simple_fractions(differentiate(sum))) {
      if (f.denominator.degree() > 2 && residues_are_distinct(f.numerator, f.denominator))
        return std::nullopt;
      sums.push_back(lazard_rioboo_trager({f.numerator, f.denominator}).front());
    }
  const GaussianLogs logs = gaussian_logs(merge_equal_residues(std::move(sums)));
  if (!logs.others.empty()) return std::nullopt;
  return exact_value(rational, log_change(logs, a, b));
}

}  // namespace

DefiniteIntegral definite_integral(const Antiderivative& F, const Endpoint& from,
                                   const Endpoint& to, AtPoles at_poles) {
  const Endpoint a = simplified(from);
  const Endpoint b = simplified(to);
  const RationalFunction f = differentiate(F);
  if (f.is_zero()) return {Rational(0), ExactValue{}};
  require_integrable(f, a, b, at_poles);
  if (compare(a, b) == 0 || (is_odd(f) && are_opposite(a, b))) return {Rational(0), ExactValue{}};

  const auto exactly = [](const Rational& x) {
    return DefiniteIntegral{x, ExactValue{x, 0, {}, {}}};
  };
  const RationalFunction plain = RationalFunction(F.polynomial) + F.rational;
  std::optional<ExactValue> exact;
  if (std::holds_alternative<RealAlgebraic>(a) || std::holds_alternative<RealAlgebraic>(b)) {
    const auto difference = F.logs.empty() ? rational_difference(plain, a, b) : std::nullopt;
    if (difference) return exactly(*difference);
  } else {
    const auto at = [&](const Endpoint& end) {
      return is_infinite(end) ? Rational(0) : plain(std::get<Rational>(end));
    };
    exact = in_finite_terms(F, at(b) - at(a), a, b);
    if (exact && *exact == ExactValue{exact->rational, 0, {}, {}}) return exactly(exact->rational);
  }
  const auto evaluator = std::make_shared<Evaluator>(F);
  const auto r = std::get_if<Rational>(&a);
  const auto s = std::get_if<Rational>(&b);
  if (r != nullptr && s != nullptr && at_poles == AtPoles::refuse) {
    const Real value = evaluator->value(*r, *s);
    if (value.exact()) return exactly(*value.exact());
    return {Real([evaluator, value](long bits) { return value.enclose(bits); }), exact};
  }
  return {Real([=](long bits) { return evaluator->branch_difference(a, b, bits); }), exact};
}

DefiniteIntegral definite_integral(const RationalFunction& f, const Endpoint& a, const Endpoint& b,
                                   AtPoles at_poles) {
  return definite_integral(integrate(f), a, b, at_poles);
}

}  // namespace phrame
