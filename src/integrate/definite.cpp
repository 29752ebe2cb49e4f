#include "phrame/integrate/definite.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/sturm.hpp"
#include "phrame/integrate/exact_value.hpp"
#include "phrame/integrate/lazard_rioboo_trager.hpp"
#include "phrame/integrate/quadrature.hpp"
#include "phrame/integrate/short_integral.hpp"

namespace phrame {
namespace {

/// Of the first ball: enough for a double, so that it is often the last.
constexpr long first_bits = 128;

/// log((b − z)/(a − z)) = log(1 + (b − a)/(a − z)), accurate also for b close to a.
ComplexBall log_ratio(const ComplexBall& z, const Rational& a, const Rational& b, long bits) {
  ComplexBall ratio;
  acb_sub_arb(ratio.raw(), z.raw(), RealBall(a, bits).raw(), bits);  // z − a
  acb_inv(ratio.raw(), ratio.raw(), bits);
  acb_mul_arb(ratio.raw(), ratio.raw(), RealBall(a - b, bits).raw(), bits);
  acb_log1p(ratio.raw(), ratio.raw(), bits);
  return ratio;
}

RealBall log_ratio(const RealBall& z, const Rational& a, const Rational& b, long bits) {
  RealBall ratio = divide(RealBall(a - b, bits), subtract(z, RealBall(a, bits), bits), bits);
  arb_log1p(ratio.raw(), ratio.raw(), bits);
  return ratio;
}

/// What may be lost to cancellation: a multiple of the digits that the ends have, and much more.
long largest_precision(long bits, const Endpoint& a, const Endpoint& b) {
  return 64 * bits + 65536 + 4 * (bits_of(a) + bits_of(b));
}

}  // namespace

void Evaluator::add_poles(const Polynomial& numerator, const Polynomial& denominator) {
  if (numerator.is_zero()) return;
  poles_.push_back({numerator, denominator, differentiate(denominator), {}, {}, {}});
}

Evaluator::Evaluator(const Antiderivative& F, const RationalFunction& derivative)
    : polynomial_(F.polynomial - Polynomial{F.polynomial.coefficient(0)}),
      rational_(F.rational),
      derivative_(derivative) {
  if (F.logs.empty()) return;
  const bool is_over_all_poles = std::all_of(F.logs.begin(), F.logs.end(), is_over_poles);
  const bool is_all_logs = polynomial_.is_zero() && rational_.is_zero();
  if (is_over_all_poles && (F.logs.size() > 1 || !is_all_logs)) {
    for (const LogSum& sum : F.logs) {
      const RationalFunction f = differentiate(sum);
      add_poles(f.numerator(), f.denominator());
    }
    return;
  }
  RationalFunction logs = derivative;
  if (!is_all_logs)
    logs = logs - (RationalFunction(differentiate(polynomial_)) + differentiate(rational_));
  if (is_over_all_poles)
    add_poles(logs.numerator(), logs.denominator());
  else
    for (const auto& [n, d] : simple_fractions(logs)) add_poles(n, d);
}

Evaluator::Evaluator(const Antiderivative& F, const RationalFunction& derivative,
                     const std::vector<SimpleFraction>& of_logs)
    : polynomial_(F.polynomial - Polynomial{F.polynomial.coefficient(0)}),
      rational_(F.rational),
      derivative_(derivative) {
  for (auto f = of_logs.begin(); f != of_logs.end(); ++f) {
    const auto has_common_pole = [&](const SimpleFraction& g) {
      return !gcd(f->denominator, g.denominator).is_constant();
    };
    if (std::any_of(of_logs.begin(), f, has_common_pole)) {
      *this = Evaluator(F, derivative);
      return;
    }
    add_poles(f->numerator, f->denominator);
  }
}

void Evaluator::require_no_pole(const Rational& a, const Rational& b) const {
  const Interval path = closed(std::min(a, b), std::max(a, b));
  const auto check = [&](const Polynomial& d) {
    if (count_real_roots(d, path) == 0) return;
    const Interval pole = located_real_roots(d, path).front();
    throw DomainError(fmt::format("definite integral from {} to {}: pole {} {}",
                                  abbreviated(to_string(a)), abbreviated(to_string(b)),
                                  pole.lower == pole.upper ? "at" : "in", to_string(pole)));
  };
  if (!rational_.is_polynomial()) check(rational_.denominator());
  for (const Poles& p : poles_)
    if (precision_ == 0 || !p.roots.real.empty()) check(p.denominator);
}

Rational Evaluator::rational_difference(const Rational& a, const Rational& b) const {
  return polynomial_(b) - polynomial_(a) + rational_(b) - rational_(a);
}

void Evaluator::prepare(long precision) {
  if (precision <= precision_) return;
  for (Poles& p : poles_) {
    if (precision_ == 0)
      p.roots = isolate_roots(p.denominator, precision);
    else
      refine(p.denominator, p.roots, precision);
    const auto residue = [&](const ComplexBall& z) {
      return divide(evaluate(p.numerator, z, precision), evaluate(p.slope, z, precision),
                    precision);
    };
    p.real_residues.clear();
    p.upper_residues.clear();
    for (const RealBall& z : p.roots.real)
      p.real_residues.push_back(residue(ComplexBall(z, RealBall())).re());
    for (const ComplexBall& z : p.roots.upper) p.upper_residues.push_back(residue(z));
  }
  precision_ = precision;
}

/// Σ c(z) log((b − z)/(a − z)); a pair of conjugate poles gives twice the real part of one term.
RealBall Evaluator::log_difference(const Rational& a, const Rational& b, long bits) const {
  RealBall sum;
  for (const Poles& p : poles_) {
    for (std::size_t k = 0; k < p.roots.real.size(); ++k) {
      const RealBall term = log_ratio(p.roots.real[k], a, b, bits);
      arb_addmul(sum.raw(), p.real_residues[k].raw(), term.raw(), bits);
    }
    for (std::size_t k = 0; k < p.roots.upper.size(); ++k) {
      ComplexBall term = log_ratio(p.roots.upper[k], a, b, bits);
      acb_mul(term.raw(), term.raw(), p.upper_residues[k].raw(), bits);
      arb_mul_2exp_si(acb_realref(term.raw()), acb_realref(term.raw()), 1);
      arb_add(sum.raw(), sum.raw(), acb_realref(term.raw()), bits);
    }
  }
  return sum;
}

/// Σ c(z) log|t − z| over the real poles, and twice the real parts of c(z) log(t − z), principal
/// branch, over those above the real axis; at ±∞ the limit. For Im z > 0 t − z is below the axis,
/// so that log(t − z) tends to log|t| − πi at −∞.
RealBall Evaluator::branch(const Endpoint& t, long bits) {
  prepare(bits);
  const auto twice_real = [&](ComplexBall term, const ComplexBall& c) {
    acb_mul(term.raw(), term.raw(), c.raw(), bits);
    arb_mul_2exp_si(acb_realref(term.raw()), acb_realref(term.raw()), 1);
    return term.re();
  };
  RealBall sum;
  if (const auto* infinity = std::get_if<Infinity>(&t)) {
    if (*infinity == Infinity::positive) return sum;
    const ComplexBall half_turn(RealBall(), subtract({}, pi(bits), bits));
    for (const Poles& p : poles_)
      for (const ComplexBall& c : p.upper_residues) sum = add(sum, twice_real(half_turn, c), bits);
    return sum;
  }
  const RealBall at = enclose(t, bits);
  const auto value = [&](const Polynomial& p) { return evaluate(p, {at, {}}, bits).re(); };
  sum = add(value(polynomial_),
            divide(value(rational_.numerator()), value(rational_.denominator()), bits), bits);
  for (const Poles& p : poles_) {
    for (std::size_t k = 0; k < p.roots.real.size(); ++k) {
      RealBall term = subtract(at, p.roots.real[k], bits);
      arb_abs(term.raw(), term.raw());
      arb_log(term.raw(), term.raw(), bits);
      arb_addmul(sum.raw(), p.real_residues[k].raw(), term.raw(), bits);
    }
    for (std::size_t k = 0; k < p.roots.upper.size(); ++k) {
      ComplexBall term;
      acb_sub_arb(term.raw(), p.roots.upper[k].raw(), at.raw(), bits);
      acb_neg(term.raw(), term.raw());
      acb_log(term.raw(), term.raw(), bits);
      sum = add(sum, twice_real(std::move(term), p.upper_residues[k]), bits);
    }
  }
  return sum;
}

RealBall Evaluator::branch_difference(const Endpoint& a, const Endpoint& b, long bits) {
  if (route_ == Route::automatic && !is_infinite(a) && !is_infinite(b))
    if (auto value = short_integral(derivative_, a, b, bits)) return *std::move(value);
  const long end = largest_precision(bits, a, b);
  for (long precision = bits + 24;; precision = std::min(end, precision + precision / 2)) {
    RealBall value = subtract(branch(b, precision), branch(a, precision), precision);
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
const RealBall* Evaluator::cheap_quadrature(const Rational& a, const Rational& b, long bits) {
  constexpr long greatest_bits = 192;
  constexpr long high_degree = 32;
  constexpr long points_per_pole = 60;
  if (bits > greatest_bits) return nullptr;
  if (!integrated_) {
    const auto is_clustered = [](const Poles& p) {
      return p.denominator.degree() >= high_degree && has_no_clear_root(p.denominator);
    };
    if (precision_ > 0 || std::none_of(poles_.begin(), poles_.end(), is_clustered)) return nullptr;
    require_no_pole(a, b);
    integrated_ = {a, b,
                   quadrature(derivative_, a, b, greatest_bits + 16,
                              points_per_pole * derivative_.denominator().degree())};
  }
  const auto& [from, to, value] = *integrated_;
  return from == a && to == b && value.is_accurate(bits) ? &value : nullptr;
}

RealBall Evaluator::difference(const Rational& a, const Rational& b, long bits) {
  if (poles_.empty() || a == b || route_ == Route::roots) return difference_by_roots(a, b, bits);
  if (route_ == Route::automatic) {
    if (auto value = short_integral(derivative_, a, b, bits)) return *std::move(value);
    const RealBall* value = cheap_quadrature(a, b, bits);
    return value != nullptr ? *value : difference_by_roots(a, b, bits);
  }
  const auto value = difference_by_quadrature(a, b, bits);
  if (value && route_ == Route::quadrature) return *value;
  const RealBall other = difference_by_roots(a, b, bits);
  if (!value)
    throw Undecided(
        fmt::format("definite integral from {} to {}: the quadrature does not give an enclosure "
                    "of width 2^-{}",
                    abbreviated(to_string(a)), abbreviated(to_string(b)), bits));
  if (!value->overlaps(other))
    throw Error(fmt::format("definite integral from {} to {}: quadrature and roots do not agree",
                            abbreviated(to_string(a)), abbreviated(to_string(b))));
  return other;
}

/// No value where the quadrature gives up, as next to a pole.
std::optional<RealBall> Evaluator::difference_by_quadrature(const Rational& a, const Rational& b,
                                                            long bits) const {
  require_no_pole(a, b);
  for (const long more : {16L, 64L, 64 + bits}) {
    const RealBall value = quadrature(derivative_, a, b, bits + more);
    if (value.is_accurate(bits)) return value;
  }
  return std::nullopt;
}

RealBall Evaluator::difference_by_roots(const Rational& a, const Rational& b, long bits) {
  prepare(bits + 24);
  require_no_pole(a, b);
  const Rational rational = rational_difference(a, b);
  if (poles_.empty() || a == b) return RealBall(rational, bits + 8);
  const long end = largest_precision(bits, a, b);
  for (long precision = bits + 24;; precision = std::min(end, precision + precision / 2)) {
    prepare(precision);
    RealBall value = add(RealBall(rational, precision), log_difference(a, b, precision), precision);
    if (value.is_accurate(bits)) return value;
    if (precision == end)
      throw Undecided(
          fmt::format("definite integral from {} to {}: {} bits of precision do not "
                      "give an enclosure of width 2^-{}",
                      abbreviated(to_string(a)), abbreviated(to_string(b)), end, bits));
  }
}

/// For every root α of `residues`: is Σ_{c(z)=α} arg − Σ_{c(z)=ᾱ} arg of (b − z)/(a − z), over the
/// poles z above the real axis, 0, given that it is a multiple of π? Poles z and z̄ turn in opposite
/// directions, so there is nothing to ask for a real α.
bool Evaluator::turns_vanish(const Polynomial& residues, const Polynomial& other_residues,
                             const Rational& a, const Rational& b) const {
  if (residues.is_constant()) return true;
  const auto isolated = [&](const Polynomial& p) {
    return p.is_constant() ? Roots() : isolate_roots(p, precision_);
  };
  const Roots alphas = isolated(residues);
  const Roots others = isolated(other_residues);
  std::vector<RealBall> turns(alphas.upper.size());
  for (const Poles& p : poles_)
    for (std::size_t k = 0; k < p.roots.upper.size(); ++k) {
      const ComplexBall& c = p.upper_residues[k];
      long matches = 0;
      for (const Roots* roots : {&alphas, &others}) {
        for (const RealBall& alpha : roots->real) matches += c.overlaps({alpha, {}}) ? 1 : 0;
        for (const ComplexBall& alpha : roots->upper)
          matches += (c.overlaps(alpha) ? 1 : 0) + (c.overlaps(conjugate(alpha)) ? 1 : 0);
      }
      if (matches != 1) return false;  // the balls are too wide to tell the residues apart
      const RealBall turn = log_ratio(p.roots.upper[k], a, b, precision_).im();
      for (std::size_t j = 0; j < turns.size(); ++j) {
        if (c.overlaps(alphas.upper[j])) turns[j] = add(turns[j], turn, precision_);
        if (c.overlaps(conjugate(alphas.upper[j]))) turns[j] = subtract(turns[j], turn, precision_);
      }
    }
  return std::all_of(turns.begin(), turns.end(), [](const RealBall& turn) {
    return turn.is_finite() && turn.lower() > -1 && turn.upper() < 1;
  });
}

// Residues in ℚ(i) are decided together with the phase. The sum Σ α·L(α) over others, L(α) a value
// of log(v(α, b)/v(α, a)): if v(α, b) = r·v(α, a) with r ∈ ℚ, exactly, then L(α) = log|r| + πi·k
// with a whole k. So k = 0 and, for every irreducible polynomial of residues, log|r| = 0 or Σ α = 0
// prove that the sum is 0.
Evaluator::LogsOverPi Evaluator::logs_over_pi(const Rational& a, const Rational& b,
                                              const GaussianPolynomial& phase) {
  prepare(256);
  std::vector<SimpleFraction> fractions;
  for (const Poles& p : poles_)
    for (SimpleFraction& f : simple_fractions({p.numerator, p.denominator}))
      fractions.push_back(std::move(f));
  const std::vector<LogSum> sums = over_residues(fractions);
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
  if (!turns_vanish(residues, other_residues, a, b)) return {};
  return {phrame::multiple_of_pi(log_change(gaussian, a, b)), true};
}

std::optional<GaussianPolynomial> Evaluator::single_argument() {
  if (!polynomial_.is_zero() || !rational_.is_zero()) return std::nullopt;
  constexpr long bits = first_bits + 24;  // as the first value needs
  prepare(bits);
  std::vector<SimpleFraction> fractions;
  for (const Poles& p : poles_) {
    for (const ComplexBall& c : p.upper_residues) {
      const RealBall twice = multiply(c.im(), RealBall(2, bits), bits);
      if (!c.re().contains_zero() || arb_contains_int(twice.raw()) == 0) return std::nullopt;
    }
    for (SimpleFraction& f : simple_fractions({p.numerator, p.denominator}))
      fractions.push_back(std::move(f));
  }
  return phrame::single_argument(gaussian_logs(over_residues(fractions)));
}

Real Evaluator::value(const Rational& a, const Rational& b) {
  return value(a, b, {{1}, {}}, [this, a, b](long bits) { return difference(a, b, bits); });
}

// What is nearly rational is rarely rational: the decision waits for a ball that an integral of
// this size, about 2^−degree where the poles are not near, has left. A linear form in logarithms of
// algebraic numbers with algebraic coefficients is 0 or transcendental [Baker 1975], so that a
// number that is not its rational part is irrational. A sum of logarithms that is a rational
// multiple of π other than 0 is not 0.
Real Evaluator::value(const Rational& a, const Rational& b, const GaussianPolynomial& phase,
                      const Real::Enclosure& enclose, const Angle& offset) {
  const Rational rational = rational_difference(a, b) + offset.radians;
  if (a == b || (poles_.empty() && degree(phase) == 0))
    return to_real(Angle(offset.half_turns, rational));
  constexpr long bits = first_bits;
  const RealBall first = enclose(bits);
  const auto is_apart = [&] {
    if (!first.contains(rational)) return true;
    long poles = degree(phase);
    for (const Poles& p : poles_) poles += p.denominator.degree();
    return !enclose(bits + 16 * poles).contains(rational);
  };
  bool is_irrational = is_apart();
  if (!is_irrational) {
    const auto [multiple, is_decided] = logs_over_pi(a, b, phase);
    if (multiple == Rational(-offset.half_turns)) return rational;
    is_irrational = is_decided;
  }
  return {
      [enclose, first](long precision) { return precision <= bits ? first : enclose(precision); },
      {is_irrational, bits_of(a) + bits_of(b) + bits_of(derivative_)}};
}

RealBall definite(const Antiderivative& F, const Rational& a, const Rational& b, long bits) {
  return Evaluator(F).difference(a, b, bits);
}

}  // namespace phrame
