// F = polynomial + rational + Σ c(z) log(t − z). An integral to ±∞ exists iff f = O(t⁻²): then
// polynomial = 0, rational → 0 and Σ c(z) = 0, so that the logarithms have a limit. The limit of
// the integral from −R to R also exists where F(R) − F(−R) has one: polynomial is even, and log|R|
// − log|−R| = 0 whatever Σ c(z) is.
#include "phrame/integrate/definite_integral.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "phrame/algebra/algebraic_image.hpp"
#include "phrame/algebra/as_written.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/algebra/factor.hpp"
#include "phrame/integrate/algebraic_logs.hpp"
#include "phrame/integrate/evaluator.hpp"
#include "phrame/integrate/integrate.hpp"
#include "phrame/integrate/known_integral.hpp"
#include "phrame/integrate/log_change.hpp"
#include "phrame/integrate/rothstein_trager.hpp"
#include "phrame/integrate/turned_logs.hpp"

namespace phrame::inline v0 {
namespace {

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

/// The real poles in [low, high].
std::vector<RealRoot> poles_between(const Polynomial& d, const Endpoint& low,
                                    const Endpoint& high) {
  std::vector<RealRoot> found = real_roots(d, {outer(low, true), outer(high, false)});
  std::erase_if(found, [&](const RealRoot& pole) {
    return compare(pole.at, low) < 0 || compare(pole.at, high) > 0;
  });
  return found;
}

std::string place(const RealAlgebraic& pole) {
  if (pole.is_rational()) return "at " + as_written(*pole.rational());
  return "in " + to_string(narrowed(pole.polynomial(), pole.interval(), Rational(1, 1 << 20)));
}

/// Throws where the integral from −R to R has no limit for R → ∞. With f = Σ pₖtᵏ + c/t + O(t⁻²)
/// the odd powers and c/t contribute nothing, pₖtᵏ with an even k contributes 2pₖR^(k+1)/(k+1).
void require_symmetric_limit(const RationalFunction& f) {
  const Polynomial whole = divide(f.numerator(), f.denominator()).quotient;
  for (long k = whole.degree(); k >= 0; --k)
    if (const Rational c = whole.coefficient(k); k % 2 == 0 && c != 0)
      throw DomainError(fmt::format(
          "principal value: it diverges, as the integral from -R to R is about {}·R{}",
          to_string(Rational(2 * c / (k + 1))), k == 0 ? "" : fmt::format("^{}", k + 1)));
}

/// Throws where there is no integral; else, are there poles between the ends?
bool require_integrable(const RationalFunction& f, const Endpoint& a, const Endpoint& b,
                        AtPoles at_poles) {
  const bool forward = compare(a, b) <= 0;
  const Endpoint& low = forward ? a : b;
  const Endpoint& high = forward ? b : a;
  const bool principal = at_poles == AtPoles::principal_value;
  const long drop = f.denominator().degree() - f.numerator().degree();
  const bool symmetric =
      principal && is_infinite(low) && is_infinite(high) && compare(low, high) != 0;
  if (symmetric) {
    require_symmetric_limit(f);
  } else if ((is_infinite(a) || is_infinite(b)) && drop < 2) {
    const Endpoint& end = is_infinite(high) ? high : low;
    const Rational c = f.numerator().leading_coefficient() / f.denominator().leading_coefficient();
    throw DomainError(
        fmt::format("definite integral: it diverges at {}, where the integrand is about {}{}",
                    end == Endpoint(Infinity::positive) ? "∞" : "−∞", to_string(c),
                    drop == 0 ? "" : fmt::format(" times the power {} of its variable", -drop)));
  }
  if (f.is_polynomial() || (is_infinite(a) && compare(a, b) == 0)) return false;
  const auto poles = poles_between(f.denominator(), low, high);
  if (poles.empty()) return false;
  if (!principal)
    throw DomainError(fmt::format("definite integral: pole {}", place(poles.front().at)));
  for (const auto& [at, order] : poles) {
    if (compare(at, a) == 0 || compare(at, b) == 0)
      throw DomainError(fmt::format("principal value: pole at an end, {}", place(at)));
    if (order > 1)
      throw DomainError(fmt::format("principal value: pole of order {} {}", order, place(at)));
  }
  return true;
}

/// m with f(2m − t) = −f(t), where there is one: the mean of the zeros of the denominator, or of
/// the numerator of a polynomial.
std::optional<Rational> center_of_symmetry(const RationalFunction& f) {
  const Polynomial& p = f.is_polynomial() ? f.numerator() : f.denominator();
  const long n = p.degree();
  if (n < 1) return std::nullopt;
  const Rational m = -p.coefficient(n - 1) / (n * p.leading_coefficient());
  // Two values deny it for most f.
  const auto product = [&](const Rational& s, const Rational& t) {
    return f.numerator()(s) * f.denominator()(t);
  };
  if (product(m + 1, m - 1) != -product(m - 1, m + 1)) return std::nullopt;
  return compose(f, Polynomial{2 * m, -1}) == -f ? std::optional(m) : std::nullopt;
}

/// Is a + b = 2m, or a = −b infinite?
bool are_opposite(const Endpoint& a, const Endpoint& b, const Rational& m) {
  if (is_infinite(a) || is_infinite(b)) return is_infinite(a) && is_infinite(b);
  return affine(*finite(a), -1, 2 * m) == *finite(b);
}

/// F at an end; at ±∞, where there is an integral, F tends to 0.
RealAlgebraic value_at(const RationalFunction& F, const Endpoint& end) {
  if (is_infinite(end)) return {};
  if (const auto r = rational(end)) return F(*r);
  return image(F, std::get<RealAlgebraic>(end));
}

/// F(b) − F(a), where it is rational. If so, the two have polynomials of the same degree n, shifted
/// by it; it is the difference of their mean conjugates −c_{n−1}/(n·c_n).
std::optional<Rational> rational_difference(const RationalFunction& F, const Endpoint& a,
                                            const Endpoint& b) {
  const RealAlgebraic from = value_at(F, a);
  const RealAlgebraic to = value_at(F, b);
  const long n = from.polynomial().degree();
  if (to.polynomial().degree() != n) return std::nullopt;
  const auto mean = [n](const Polynomial& p) {
    return Rational(-p.coefficient(n - 1) / (n * p.leading_coefficient()));
  };
  const Rational shift = mean(to.polynomial()) - mean(from.polynomial());
  return affine(from, 1, shift) == to ? std::optional(shift) : std::nullopt;
}

/// The logarithms of F, those with residues in ℚ(i) apart from the other fractions.
struct Logs {
  GaussianLogs gaussian;
  std::vector<SimpleFraction> others;
  std::vector<SimpleFraction> all;  ///< what sums up to the derivative, of any denominators
};

/// Is the sum one over its residues, which lie in a quadratic field or ℚ?
bool is_over_quadratic_residues(const LogSum& sum) {
  return sum.index.degree() <= 2 && sum.residue == Polynomial{0, 1} % sum.index &&
         (sum.index.degree() == 1 || factor(sum.index).factors.size() == 1);
}

/// Of the sums the simple fractions may be known, one for each.
Logs split_logs(const Antiderivative& F, const std::vector<SimpleFraction>& known) {
  Logs result;
  std::vector<LogSum> quadratic;
  for (std::size_t k = 0; k < F.logs.size(); ++k) {
    const LogSum& sum = F.logs[k];
    if (is_over_quadratic_residues(sum)) {  // of a high degree: to find them again takes long
      quadratic.push_back(sum);
      const RationalFunction f = differentiate(sum);
      result.all.push_back({f.numerator(), f.denominator()});
      continue;
    }
    for (SimpleFraction& f : known.empty() ? simple_fractions(differentiate(sum))
                                           : std::vector<SimpleFraction>{known[k]}) {
      result.all.push_back(f);
      if (has_residues_of_degree_at_most(f, 2))
        quadratic.push_back(over_residues({f}).front());
      else
        result.others.push_back(std::move(f));
    }
  }
  result.gaussian = gaussian_logs(merge_equal_residues(std::move(quadratic)));
  for (const LogSum& sum : std::exchange(result.gaussian.others, {}))
    for (SimpleFraction& f : simple_fractions(differentiate(sum)))
      result.others.push_back(std::move(f));
  return result;
}

/// What is known exactly between rational or infinite ends; `rational` is the part without
/// logarithms.
std::optional<ExactValue> in_finite_terms(const Logs& logs, const Rational& rational,
                                          const Endpoint& a, const Endpoint& b) {
  const auto turned = turned_logs(logs.others, a, b);
  if (!turned) return std::nullopt;
  LogChange change = log_change(logs.gaussian, a, b);
  change.sizes.insert(change.sizes.end(), turned->sizes.begin(), turned->sizes.end());
  return exact_value(rational, std::move(change), turned->multiple);
}

/// The same where an end is algebraic: a rational number plus a rational multiple of π.
std::optional<ExactValue> in_finite_terms(const Logs& logs, const Antiderivative& F,
                                          const RationalFunction& plain, const Endpoint& a,
                                          const Endpoint& b) {
  Rational turned = 0;
  if (!F.logs.empty()) {
    if (!logs.others.empty()) return std::nullopt;
    const Evaluator evaluator(Antiderivative{{}, {}, F.logs});
    const auto multiple = multiple_of_pi(
        logs.gaussian, a, b, [&](long bits) { return evaluator.branch_difference(a, b, bits); });
    if (!multiple) return std::nullopt;
    turned = *multiple;
  }
  const auto difference = rational_difference(plain, a, b);
  return difference ? std::optional(ExactValue{*difference, turned, {}, {}}) : std::nullopt;
}

DefiniteIntegral exactly(const Rational& x) { return {x, exact_value(x)}; }

/// The parts may be known, as those of a FactoredIntegral, and that there are no poles.
DefiniteIntegral integral_between(const Antiderivative& F, const RationalFunction& f,
                                  const std::vector<SimpleFraction>& parts, const Endpoint& from,
                                  const Endpoint& to, AtPoles at_poles, bool has_no_poles) {
  const Endpoint a = simplified(from);
  const Endpoint b = simplified(to);
  if (f.is_zero()) return exactly(0);
  const bool has_poles = !has_no_poles && require_integrable(f, a, b, at_poles);
  if (compare(a, b) == 0) return exactly(0);
  if (const auto m = center_of_symmetry(f); m && are_opposite(a, b, *m)) return exactly(0);

  // A constant of integration would not vanish at ±∞.
  const RationalFunction plain =
      RationalFunction(F.polynomial - Polynomial{F.polynomial.coefficient(0)}) + F.rational;
  const Logs logs = split_logs(F, parts);
  std::optional<ExactValue> exact;
  if (std::holds_alternative<RealAlgebraic>(a) || std::holds_alternative<RealAlgebraic>(b)) {
    exact = in_finite_terms(logs, F, plain, a, b);
  } else {
    const auto at = [&](const Endpoint& end) {
      return is_infinite(end) ? Rational(0) : plain(std::get<Rational>(end));
    };
    exact = in_finite_terms(logs, at(b) - at(a), a, b);
  }
  if (exact && is_rational(*exact)) return exactly(exact->rational);
  const Evaluator evaluator(F, f, logs.all);
  const auto r = std::get_if<Rational>(&a);
  const auto s = std::get_if<Rational>(&b);
  if (r != nullptr && s != nullptr && !has_poles) {
    const Real value = evaluator.value(*r, *s);
    if (value.exact()) return exactly(*value.exact());
    return {value, exact};
  }
  return {{[=](long bits) { return evaluator.branch_difference(a, b, bits); },
           {exact.has_value(), bits_of(a) + bits_of(b) + bits_of(f)}},  // not rational: see above
          exact};
}

}  // namespace

DefiniteIntegral definite_integral(const Antiderivative& F, const RationalFunction& f,
                                   const Endpoint& a, const Endpoint& b, AtPoles at_poles) {
  return integral_between(F, f, {}, a, b, at_poles, false);
}

DefiniteIntegral definite_integral(const FactoredIntegral& of, const RationalFunction& f,
                                   const Endpoint& a, const Endpoint& b, bool has_no_poles) {
  return integral_between(of.F, f, of.parts, a, b, AtPoles::refuse, has_no_poles);
}

DefiniteIntegral definite_integral(const Antiderivative& F, const Endpoint& a, const Endpoint& b,
                                   AtPoles at_poles) {
  return definite_integral(F, differentiate(F), a, b, at_poles);
}

DefiniteIntegral definite_integral(const RationalFunction& f, const Endpoint& a, const Endpoint& b,
                                   AtPoles at_poles) {
  return definite_integral(integrate(f, Form::partial_fractions), f, a, b, at_poles);
}

}  // namespace phrame
