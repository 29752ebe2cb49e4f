#include "phrame/integrate/evaluator.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "phrame/algebra/ball_log.hpp"
#include "phrame/algebra/ball_order.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/algebra/roots.hpp"
#include "phrame/algebra/shared.hpp"
#include "phrame/algebra/sturm.hpp"
#include "phrame/integrate/exact_value.hpp"
#include "phrame/integrate/lazard_rioboo_trager.hpp"
#include "phrame/integrate/quadrature.hpp"
#include "phrame/integrate/short_integral.hpp"

namespace phrame {
namespace {

/// Of the first ball: enough for a double, so that it is often the last.
constexpr long first_bits = 128;

/// z ↦ log((b − z)/(a − z)) = log(1 + (a − b)/(z − a)), accurate also for b close to a.
class LogRatio {
 public:
  LogRatio(const Rational& a, const Rational& b, long bits)
      : a_(RealBall(a, bits), {}), a_minus_b_(a - b, bits), bits_(bits) {}

  ComplexBall operator()(const ComplexBall& z) const {
    return log1p(multiply(a_minus_b_, inverse(subtract(z, a_, bits_), bits_), bits_), bits_);
  }
  RealBall operator()(const RealBall& z) const {
    return log1p(divide(a_minus_b_, subtract(z, a_.re(), bits_), bits_), bits_);
  }

 private:
  ComplexBall a_;
  RealBall a_minus_b_;
  long bits_;
};

/// z·w + z̄·w̄.
RealBall twice_real_part(const ComplexBall& z, const ComplexBall& w, long bits) {
  return times_power_of_two(multiply(z, w, bits).re(), 1);
}

/// What may be lost to cancellation: a multiple of the digits that the ends have, and much more.
long largest_precision(long bits, const Endpoint& a, const Endpoint& b) {
  return 64 * bits + 65536 + 4 * (bits_of(a) + bits_of(b));
}

}  // namespace

/// F = polynomial + rational + Σ c(z) log(t − z).
struct Evaluator::Function {
  /// n/d = Σ c(z)/(t − z) over the roots z of the squarefree d.
  struct Poles {
    Polynomial numerator;
    Polynomial denominator;
    Polynomial slope;  ///< d′
  };
  /// The z and c(z) of one d.
  struct Residues {
    Roots roots;
    std::vector<RealBall> real;
    std::vector<ComplexBall> upper;
  };
  /// The same of all.
  struct Isolated {
    long precision;
    std::vector<Residues> poles;
    long nearness;  ///< no pole is nearer to 0 than 2^nearness
  };
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
  std::vector<Poles> poles;
  Refined<Isolated> isolated;
  Lazy<std::optional<Integrated>> integrated;

  Function(const Antiderivative& F, const RationalFunction& F_prime)
      : plain{F.polynomial - Polynomial{F.polynomial.coefficient(0)}, F.rational, {}},
        derivative(F_prime) {}

  void add_poles(const Polynomial& n, const Polynomial& d) {
    if (!n.is_zero()) poles.push_back({n, d, differentiate(d)});
  }
  void add_poles_of(const Antiderivative& F);

  std::shared_ptr<const Isolated> isolate(long precision) const;
  void require_no_pole(const Rational& a, const Rational& b) const;
  bool prefers_known_poles(const Rational& a, const Rational& b) const;
  RealBall log_difference(const Rational& a, const Rational& b, long bits) const;
  RealBall difference_by_roots(const Rational& a, const Rational& b, long bits) const;
  std::optional<RealBall> difference_by_quadrature(const Rational& a, const Rational& b,
                                                   long bits) const;
  RealBall branch(const Endpoint& t, long bits) const;
  bool turns_vanish(const Isolated& known, const Polynomial& residues,
                    const Polynomial& other_residues, const Rational& a, const Rational& b) const;
  std::vector<SimpleFraction> fractions() const;
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
      add_poles(f.numerator(), f.denominator());
    }
    return;
  }
  RationalFunction logs = derivative;
  if (!is_all_logs) logs = logs - differentiate(plain);
  if (is_over_all_poles)
    add_poles(logs.numerator(), logs.denominator());
  else
    for (const auto& [n, d] : simple_fractions(logs)) add_poles(n, d);
}

void Evaluator::Function::require_no_pole(const Rational& a, const Rational& b) const {
  const Interval path = closed(std::min(a, b), std::max(a, b));
  const auto check = [&](const Polynomial& d) {
    if (count_real_roots(d, path) == 0) return;
    const Interval pole = located_real_roots(d, path).front();
    throw DomainError(fmt::format("definite integral from {} to {}: pole {} {}",
                                  abbreviated(to_string(a)), abbreviated(to_string(b)),
                                  pole.lower == pole.upper ? "at" : "in", to_string(pole)));
  };
  if (!plain.rational.is_polynomial()) check(plain.rational.denominator());
  const auto known = isolated.known();
  for (std::size_t k = 0; k < poles.size(); ++k)
    if (!known || !known->poles[k].roots.real.empty()) check(poles[k].denominator);
}

std::shared_ptr<const Evaluator::Function::Isolated> Evaluator::Function::isolate(
    long precision) const {
  return isolated.get(precision, [&](const Isolated* known) {
    Isolated found{precision, {}, unbounded_exponent};
    for (std::size_t k = 0; k < poles.size(); ++k) {
      const Poles& p = poles[k];
      Residues here;
      if (known == nullptr) {
        here.roots = isolate_roots(p.denominator, precision);
      } else {
        here.roots = known->poles[k].roots;
        refine(p.denominator, here.roots, precision);
      }
      const auto residue = [&](const ComplexBall& z) {
        return divide(evaluate(p.numerator, z, precision), evaluate(p.slope, z, precision),
                      precision);
      };
      for (const RealBall& z : here.roots.real) {
        here.real.push_back(residue(ComplexBall(z, RealBall())).re());
        found.nearness = std::min(found.nearness, exponent_below(z));
      }
      for (const ComplexBall& z : here.roots.upper) {
        here.upper.push_back(residue(z));
        found.nearness =
            std::min(found.nearness, std::max(exponent_below(z.re()), exponent_below(z.im())));
      }
      found.poles.push_back(std::move(here));
    }
    return found;
  });
}

/// A logarithm for each known pole costs less than a Taylor series at a, unless b is so near to a
/// beside the poles that few terms of it are enough. Between ends that are not 0 short_integral
/// itself asks for more than that.
bool Evaluator::Function::prefers_known_poles(const Rational& a, const Rational& b) const {
  constexpr long near = 16;
  if (a != 0) return false;
  const auto known = isolated.known();
  return known && exponent_above(RealBall(b, 53)) > known->nearness - near;
}

/// Σ c(z) log((b − z)/(a − z)); a pair of conjugate poles gives twice the real part of one term.
RealBall Evaluator::Function::log_difference(const Rational& a, const Rational& b,
                                             long bits) const {
  const auto known = isolate(bits);
  const LogRatio log_ratio(a, b, bits);
  RealBall sum;
  for (const Residues& p : known->poles) {
    for (std::size_t k = 0; k < p.roots.real.size(); ++k)
      sum = add_product(std::move(sum), p.real[k], log_ratio(p.roots.real[k]), bits);
    for (std::size_t k = 0; k < p.roots.upper.size(); ++k) {
      const ComplexBall term = log_ratio(p.roots.upper[k]);
      sum = add(sum, twice_real_part(term, p.upper[k], bits), bits);
    }
  }
  return sum;
}

/// Σ c(z) log|t − z| over the real poles, and twice the real parts of c(z) log(t − z), principal
/// branch, over those above the real axis; at ±∞ the limit. For Im z > 0 t − z is below the axis,
/// so that log(t − z) tends to log|t| − πi at −∞.
RealBall Evaluator::Function::branch(const Endpoint& t, long bits) const {
  const auto known = isolate(bits);
  RealBall sum;
  if (const auto* infinity = std::get_if<Infinity>(&t)) {
    if (*infinity == Infinity::positive) return sum;
    const ComplexBall half_turn(RealBall(), subtract({}, pi(bits), bits));
    for (const Residues& p : known->poles)
      for (const ComplexBall& c : p.upper)
        sum = add(sum, twice_real_part(half_turn, c, bits), bits);
    return sum;
  }
  const RealBall at = enclose(t, bits);
  const auto value = [&](const Polynomial& p) { return evaluate(p, {at, {}}, bits).re(); };
  sum = add(value(plain.polynomial),
            divide(value(plain.rational.numerator()), value(plain.rational.denominator()), bits),
            bits);
  for (const Residues& p : known->poles) {
    for (std::size_t k = 0; k < p.roots.real.size(); ++k) {
      const RealBall distance = absolute(subtract(at, p.roots.real[k], bits));
      sum = add_product(std::move(sum), p.real[k], log(distance, bits), bits);
    }
    for (std::size_t k = 0; k < p.roots.upper.size(); ++k) {
      const ComplexBall term = log(subtract({at, {}}, p.roots.upper[k], bits), bits);
      sum = add(sum, twice_real_part(term, p.upper[k], bits), bits);
    }
  }
  return sum;
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
    function.add_poles(f->numerator, f->denominator);
  }
  function_ = std::make_shared<const Function>(std::move(function));
}

const RationalFunction& Evaluator::derivative() const { return function_->derivative; }

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
  const auto& integrated = f.integrated.get([&]() -> std::optional<Function::Integrated> {
    const auto is_clustered = [](const Function::Poles& p) {
      return p.denominator.degree() >= high_degree && has_no_clear_root(p.denominator);
    };
    if (f.isolated.known() || std::none_of(f.poles.begin(), f.poles.end(), is_clustered))
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
  if (f.poles.empty() || a == b || route_ == Route::roots) return f.difference_by_roots(a, b, bits);
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
                    abbreviated(to_string(a)), abbreviated(to_string(b)), bits));
  if (!value->overlaps(other))
    throw Error(fmt::format("definite integral from {} to {}: quadrature and roots do not agree",
                            abbreviated(to_string(a)), abbreviated(to_string(b))));
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
  isolate(bits + 24);
  require_no_pole(a, b);
  const Rational without_logs = difference_without_logarithms(plain, a, b);
  if (poles.empty() || a == b) return RealBall(without_logs, bits + 8);
  const long end = largest_precision(bits, a, b);
  for (long precision = bits + 24;; precision = std::min(end, precision + precision / 2)) {
    RealBall value =
        add(RealBall(without_logs, precision), log_difference(a, b, precision), precision);
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
bool Evaluator::Function::turns_vanish(const Isolated& known, const Polynomial& residues,
                                       const Polynomial& other_residues, const Rational& a,
                                       const Rational& b) const {
  if (residues.is_constant()) return true;
  const auto roots_of = [&](const Polynomial& p) {
    return p.is_constant() ? Roots() : isolate_roots(p, known.precision);
  };
  const Roots alphas = roots_of(residues);
  const Roots others = roots_of(other_residues);
  const LogRatio log_ratio(a, b, known.precision);
  std::vector<RealBall> turns(alphas.upper.size());
  for (const Residues& p : known.poles)
    for (std::size_t k = 0; k < p.roots.upper.size(); ++k) {
      const ComplexBall& c = p.upper[k];
      long matches = 0;
      for (const Roots* roots : {&alphas, &others}) {
        for (const RealBall& alpha : roots->real) matches += c.overlaps({alpha, {}}) ? 1 : 0;
        for (const ComplexBall& alpha : roots->upper)
          matches += (c.overlaps(alpha) ? 1 : 0) + (c.overlaps(conjugate(alpha)) ? 1 : 0);
      }
      if (matches != 1) return false;  // the balls are too wide to tell the residues apart
      const RealBall turn = log_ratio(p.roots.upper[k]).im();
      for (std::size_t j = 0; j < turns.size(); ++j) {
        if (c.overlaps(alphas.upper[j])) turns[j] = add(turns[j], turn, known.precision);
        if (c.overlaps(conjugate(alphas.upper[j])))
          turns[j] = subtract(turns[j], turn, known.precision);
      }
    }
  return std::all_of(turns.begin(), turns.end(), [](const RealBall& turn) {
    return turn.is_finite() && turn.lower() > -1 && turn.upper() < 1;
  });
}

/// Those of the logarithms, over the irreducible factors of their denominators.
std::vector<SimpleFraction> Evaluator::Function::fractions() const {
  std::vector<SimpleFraction> all;
  for (const Poles& p : poles)
    for (SimpleFraction& f : simple_fractions({p.numerator, p.denominator}))
      all.push_back(std::move(f));
  return all;
}

// Residues in ℚ(i) are decided together with the phase. The sum Σ α·L(α) over others, L(α) a value
// of log(v(α, b)/v(α, a)): if v(α, b) = r·v(α, a) with r ∈ ℚ, exactly, then L(α) = log|r| + πi·k
// with a whole k. So k = 0 and, for every irreducible polynomial of residues, log|r| = 0 or Σ α = 0
// prove that the sum is 0.
Evaluator::Function::LogsOverPi Evaluator::Function::logs_over_pi(
    const Rational& a, const Rational& b, const GaussianPolynomial& phase) const {
  const auto known = isolate(256);
  const std::vector<LogSum> sums = over_residues(fractions());
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
  if (!turns_vanish(*known, residues, other_residues, a, b)) return {};
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
  const auto known = f.isolate(bits);
  for (const Function::Residues& p : known->poles)
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
  if (a == b || (f.poles.empty() && degree(phase) == 0))
    return to_real(Angle(offset.half_turns, rational));
  constexpr long bits = first_bits;
  const RealBall first = enclose(bits);
  const auto is_apart = [&] {
    if (!first.contains(rational)) return true;
    long poles = degree(phase);
    for (const Function::Poles& p : f.poles) poles += p.denominator.degree();
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
