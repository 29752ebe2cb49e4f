#include "phrame/integrate/evaluator.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "phrame/algebra/as_written.hpp"
#include "phrame/algebra/ball_order.hpp"
#include "phrame/algebra/decomposition.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/algebra/roots.hpp"
#include "phrame/algebra/shared.hpp"
#include "phrame/algebra/sturm.hpp"
#include "phrame/integrate/exact_value.hpp"
#include "phrame/integrate/log_change.hpp"
#include "phrame/integrate/pole_sum.hpp"
#include "phrame/integrate/quadrature.hpp"
#include "phrame/integrate/rothstein_trager.hpp"
#include "phrame/integrate/short_integral.hpp"

namespace phrame::inline v0 {
namespace {

/// Of the first ball: enough for a double, so that it is often the last.
constexpr long first_bits = 128;

/// What may be lost to cancellation: a multiple of the digits that the ends have, and much more.
long largest_precision(long bits, const Endpoint& a, const Endpoint& b) {
  return 64 * bits + 65536 + 4 * (bits_of(a) + bits_of(b));
}

}  // namespace

/// F = polynomial + rational + Σ c(z) log(t − z).
struct PHRAME_INSIDE Evaluator::Function {
  /// What was integrated on the automatic route, once.
  struct Integrated {
    Rational a;
    Rational b;
    RealBall value;
  };
  struct LogsOverPi {
    std::optional<Rational> multiple;  ///< as multiple_of_pi
    bool is_decided = false;           ///< that there is none, where there is none
  };

  Antiderivative plain;  ///< F without its logarithms
  RationalFunction derivative;
  PoleSum poles;  ///< of the logarithms
  Lazy<std::optional<Integrated>> integrated;

  Function(const Antiderivative& F, const RationalFunction& F_prime)
      : plain{F.polynomial - Polynomial{F.polynomial.coefficient(0)}, F.rational, {}},
        derivative(F_prime) {}

  void add_poles_of(const Antiderivative& F);

  void require_no_pole(const Rational& a, const Rational& b) const;
  bool prefers_known_poles(const Rational& a, const Rational& b) const;
  RealBall difference_by_roots(const Rational& a, const Rational& b, long bits) const;
  std::optional<RealBall> difference_by_quadrature(const Rational& a, const Rational& b,
                                                   long bits) const;
  RealBall branch(const Endpoint& t, long bits) const;
  std::vector<SimpleFraction> fractions() const;
  bool closes_between(const Rational& a, const Rational& b) const;
  LogsOverPi logs_over_pi(const Rational& a, const Rational& b,
                          const GaussianPolynomial& phase) const;
};

void Evaluator::Function::add_poles_of(const Antiderivative& F) {
  if (F.logs.empty()) return;
  const bool is_over_all_poles = std::all_of(F.logs.begin(), F.logs.end(), is_over_poles);
  const bool is_all_logs = plain.polynomial.is_zero() && plain.rational.is_zero();
  if (is_over_all_poles && (F.logs.size() > 1 || !is_all_logs)) {
    for (const LogSum& sum : F.logs) {
      const RationalFunction f = differentiate(sum);
      poles.add_term(f.numerator(), f.denominator());
    }
    return;
  }
  RationalFunction logs = derivative;
  if (!is_all_logs) logs = logs - differentiate(plain);
  if (is_over_all_poles || F.logs.size() == 1)
    poles.add_term(logs.numerator(), logs.denominator());
  else
    for (const auto& [n, d] : simple_fractions(logs)) poles.add_term(n, d);
}

void Evaluator::Function::require_no_pole(const Rational& a, const Rational& b) const {
  const Interval path = closed_interval(std::min(a, b), std::max(a, b));
  const auto check = [&](const Polynomial& d) {
    if (count_real_roots(d, path) == 0) return;
    const Interval pole = located_real_roots(d, path).front();
    throw DomainError(fmt::format("definite integral from {} to {}: pole {} {}", as_written(a),
                                  as_written(b), pole.lower == pole.upper ? "at" : "in",
                                  to_string(pole)));
  };
  if (!plain.rational.is_polynomial()) check(plain.rational.denominator());
  const auto known = poles.known();
  for (std::size_t k = 0; k < poles.terms().size(); ++k)
    if (!known || !known->poles[k].roots.real.empty()) check(poles.terms()[k].denominator);
}

/// A logarithm for each known pole costs less than a Taylor series at a, unless b is so near to a
/// beside the poles that few terms of it are enough. Between ends that are not 0 short_integral
/// itself asks for more than that.
bool Evaluator::Function::prefers_known_poles(const Rational& a, const Rational& b) const {
  constexpr long near = 16;
  if (a != 0) return false;
  const auto known = poles.known();
  return known && exponent_above(RealBall(b, 53)) > known->nearness - near;
}

Evaluator::Evaluator(const Antiderivative& F, const RationalFunction& derivative) {
  Function function(F, derivative);
  function.add_poles_of(F);
  function_ = std::make_shared<const Function>(std::move(function));
}

Evaluator::Evaluator(const Antiderivative& F, const RationalFunction& derivative,
                     const std::vector<SimpleFraction>& of_logs) {
  Function function(F, derivative);
  for (auto f = of_logs.begin(); f != of_logs.end(); ++f) {
    const auto has_common_pole = [&](const SimpleFraction& g) {
      return !gcd(f->denominator, g.denominator).is_constant();
    };
    if (std::any_of(of_logs.begin(), f, has_common_pole)) {
      *this = Evaluator(F, derivative);
      return;
    }
    function.poles.add_term(f->numerator, f->denominator);
  }
  function_ = std::make_shared<const Function>(std::move(function));
}

const RationalFunction& Evaluator::derivative() const { return function_->derivative; }

/// F at t, by PoleSum::branch(), at ±∞ without the polynomial and the rational part.
RealBall Evaluator::Function::branch(const Endpoint& t, long bits) const {
  const RealBall logs = poles.branch(t, bits);
  if (is_infinite(t)) return logs;
  const RealBall at = enclose(t, bits);
  const auto value = [&](const Polynomial& p) { return evaluate(p, {at, {}}, bits).re(); };
  const RealBall rational =
      divide(value(plain.rational.numerator()), value(plain.rational.denominator()), bits);
  return add(add(value(plain.polynomial), rational, bits), logs, bits);
}

RealBall Evaluator::branch_difference(const Endpoint& a, const Endpoint& b, long bits) const {
  if (route_ == Route::automatic && !is_infinite(a) && !is_infinite(b))
    if (auto value = short_integral(derivative(), a, b, bits)) return *std::move(value);
  const long end = largest_precision(bits, a, b);
  for (long precision = bits + 24;; precision = std::min(end, precision + precision / 2)) {
    RealBall value =
        subtract(function_->branch(b, precision), function_->branch(a, precision), precision);
    if (value.is_accurate(bits)) return value;
    if (precision == end)
      throw Undecided(fmt::format(
          "definite integral: {} bits of precision do not give an enclosure of width 2^-{}", end,
          bits));
  }
}

/// The value by quadrature, where it is likely to be cheaper than by roots that all lie in
/// clusters, and has not been asked for with other ends before (the table: docs/performance.md). A
/// point costs about as much as one of the first steps towards a root, of which clusters need a
/// hundred and more; so little is lost if it fails.
std::optional<RealBall> Evaluator::cheap_quadrature(const Rational& a, const Rational& b,
                                                    long bits) const {
  constexpr long greatest_bits = 192;
  constexpr long high_degree = 32;
  constexpr long points_per_pole = 60;
  if (bits > greatest_bits) return std::nullopt;
  const Function& f = *function_;
  const std::vector<PoleSum::Term>& terms = f.poles.terms();
  const auto& integrated = f.integrated.get([&]() -> std::optional<Function::Integrated> {
    const auto is_clustered = [](const PoleSum::Term& p) {
      return p.denominator.degree() >= high_degree && has_no_clear_root(p.denominator);
    };
    if (f.poles.known() || std::none_of(terms.begin(), terms.end(), is_clustered))
      return std::nullopt;
    f.require_no_pole(a, b);
    return Function::Integrated{a, b,
                                quadrature(f.derivative, a, b, greatest_bits + 16,
                                           points_per_pole * f.derivative.denominator().degree())};
  });
  if (!integrated) return std::nullopt;
  const auto& [from, to, value] = *integrated;
  return from == a && to == b && value.is_accurate(bits) ? std::optional(value) : std::nullopt;
}

RealBall Evaluator::difference(const Rational& a, const Rational& b, long bits) const {
  const Function& f = *function_;
  if (f.poles.terms().empty() || a == b || route_ == Route::roots)
    return f.difference_by_roots(a, b, bits);
  if (route_ == Route::automatic) {
    if (!f.prefers_known_poles(a, b))
      if (auto value = short_integral(f.derivative, a, b, bits)) return *std::move(value);
    if (auto value = cheap_quadrature(a, b, bits)) return *std::move(value);
    return f.difference_by_roots(a, b, bits);
  }
  const auto value = f.difference_by_quadrature(a, b, bits);
  if (value && route_ == Route::quadrature) return *value;
  const RealBall other = f.difference_by_roots(a, b, bits);
  if (!value)
    throw Undecided(
        fmt::format("definite integral from {} to {}: the quadrature does not give an enclosure "
                    "of width 2^-{}",
                    as_written(a), as_written(b), bits));
  if (!value->overlaps(other))
    throw Error(fmt::format("definite integral from {} to {}: quadrature and roots do not agree",
                            as_written(a), as_written(b)));
  return other;
}

/// No value where the quadrature gives up, as next to a pole.
std::optional<RealBall> Evaluator::Function::difference_by_quadrature(const Rational& a,
                                                                      const Rational& b,
                                                                      long bits) const {
  require_no_pole(a, b);
  for (const long more : {16L, 64L, 64 + bits}) {
    const RealBall value = quadrature(derivative, a, b, bits + more);
    if (value.is_accurate(bits)) return value;
  }
  return std::nullopt;
}

RealBall Evaluator::Function::difference_by_roots(const Rational& a, const Rational& b,
                                                  long bits) const {
  poles.isolate(bits + 24);
  require_no_pole(a, b);
  const Rational without_logs = difference_without_logarithms(plain, a, b);
  if (poles.terms().empty() || a == b) return RealBall(without_logs, bits + 8);
  const long end = largest_precision(bits, a, b);
  for (long precision = bits + 24;; precision = std::min(end, precision + precision / 2)) {
    RealBall value =
        add(RealBall(without_logs, precision), poles.change(a, b, precision), precision);
    if (value.is_accurate(bits)) return value;
    if (precision == end)
      throw Undecided(
          fmt::format("definite integral from {} to {}: {} bits of precision do not "
                      "give an enclosure of width 2^-{}",
                      as_written(a), as_written(b), end, bits));
  }
}

/// Those of the logarithms, over the irreducible factors of their denominators.
std::vector<SimpleFraction> Evaluator::Function::fractions() const {
  std::vector<SimpleFraction> all;
  for (const PoleSum::Term& p : poles.terms())
    for (SimpleFraction& f : simple_fractions({p.numerator, p.denominator}))
      all.push_back(std::move(f));
  return all;
}

/// Is Σ c(z)·log((b − z)/(a − z)) seen to be 0, as on curves that are symmetric under t → a + b −
/// t?
bool Evaluator::Function::closes_between(const Rational& a, const Rational& b) const {
  return std::all_of(poles.terms().begin(), poles.terms().end(), [&](const PoleSum::Term& p) {
    return closes(p.numerator, p.denominator, a, b);
  });
}

// Residues in ℚ(i) are decided together with the phase. The sum Σ α·L(α) over others, L(α) a value
// of log(v(α, b)/v(α, a)): if v(α, b) = r·v(α, a) with r ∈ ℚ, exactly, then L(α) = log|r| + πi·k
// with a whole k. So k = 0 and, for every irreducible polynomial of residues, log|r| = 0 or Σ α = 0
// prove that the sum is 0.
Evaluator::Function::LogsOverPi Evaluator::Function::logs_over_pi(
    const Rational& a, const Rational& b, const GaussianPolynomial& phase) const {
  const std::vector<LogSum> sums =
      over_residues(closes_between(a, b) ? std::vector<SimpleFraction>() : fractions());
  GaussianLogs gaussian = gaussian_logs(sums);
  gaussian.arguments.push_back({1, phase});
  const std::vector<LogSum> others = std::exchange(gaussian.others, {});

  Polynomial residues{1};
  Polynomial other_residues{1};
  for (const LogSum& sum : sums) other_residues *= sum.index;
  for (const LogSum& sum : others) {
    const Polynomial at_a = evaluate_at(sum.argument, a) % sum.index;
    const Polynomial at_b = evaluate_at(sum.argument, b) % sum.index;
    const Rational ratio = at_b.leading_coefficient() / at_a.leading_coefficient();
    if (!(at_b == ratio * at_a)) return {};
    if (abs(ratio) != 1 && QuotientRing(sum.index).trace(sum.residue) != 0) return {};
    residues *= sum.index;
    other_residues = exact_quotient(other_residues, sum.index);
  }
  if (!poles.turns_vanish(residues, other_residues, a, b, 256)) return {};
  return {phrame::multiple_of_pi(log_change(gaussian, a, b)), true};
}

std::optional<Rational> Evaluator::multiple_of_pi(const Rational& a, const Rational& b,
                                                  const GaussianPolynomial& phase) const {
  return function_->logs_over_pi(a, b, phase).multiple;
}

std::optional<GaussianPolynomial> Evaluator::single_argument() const {
  const Function& f = *function_;
  if (!f.plain.polynomial.is_zero() || !f.plain.rational.is_zero()) return std::nullopt;
  constexpr long bits = first_bits + 24;  // as the first value needs
  const auto known = f.poles.isolate(bits);
  for (const PoleSum::Residues& p : known->poles)
    for (const ComplexBall& c : p.upper) {
      const RealBall twice = multiply(c.im(), RealBall(2, bits), bits);
      if (!c.re().contains_zero() || !contains_integer(twice)) return std::nullopt;
    }
  return phrame::single_argument(gaussian_logs(over_residues(f.fractions())));
}

Real Evaluator::value(const Rational& a, const Rational& b) const {
  return value(a, b, {{1}, {}},
               [evaluator = *this, a, b](long bits) { return evaluator.difference(a, b, bits); });
}

// What is nearly rational is rarely rational: the decision waits for a ball that an integral of
// this size, about 2^−degree where the poles are not near, has left. A linear form in logarithms of
// algebraic numbers with algebraic coefficients is 0 or transcendental [Baker 1975], so that a
// number that is not its rational part is irrational. A sum of logarithms that is a rational
// multiple of π other than 0 is not 0.
Real Evaluator::value(const Rational& a, const Rational& b, const GaussianPolynomial& phase,
                      const Real::Enclosure& enclose, const Angle& offset) const {
  const Function& f = *function_;
  const Rational rational = difference_without_logarithms(f.plain, a, b) + offset.radians;
  if (a == b || (f.poles.terms().empty() && degree(phase) == 0))
    return to_real(Angle(offset.half_turns, rational));
  constexpr long bits = first_bits;
  const RealBall first = enclose(bits);
  const auto is_apart = [&] {
    if (!first.contains(rational)) return true;
    if (f.closes_between(a, b)) return false;
    long poles = degree(phase);
    for (const PoleSum::Term& p : f.poles.terms()) poles += p.denominator.degree();
    return !enclose(bits + 16 * poles).contains(rational);
  };
  bool is_irrational = is_apart();
  if (!is_irrational) {
    const auto [multiple, is_decided] = f.logs_over_pi(a, b, phase);
    if (multiple == Rational(-offset.half_turns)) return rational;
    is_irrational = is_decided;
  }
  return {
      [enclose, first](long precision) { return precision <= bits ? first : enclose(precision); },
      {is_irrational, bits_of(a) + bits_of(b) + bits_of(f.derivative)}};
}

}  // namespace phrame
