#include "phrame/integrate/definite.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/sturm.hpp"
#include "phrame/integrate/rothstein_trager.hpp"

namespace phrame {
namespace {

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

}  // namespace

Evaluator::Evaluator(const Antiderivative& F) : polynomial_(F.polynomial), rational_(F.rational) {
  const auto add = [this](const Polynomial& n, const Polynomial& d) {
    if (n.is_zero()) return;
    poles_.push_back({n, d, differentiate(d), {}, {}, {}});
  };
  for (const LogSum& sum : F.logs) {
    const RationalFunction f = differentiate(sum);
    if (is_over_poles(sum))
      add(f.numerator(), f.denominator());
    else
      for (const auto& [n, d] : simple_fractions(f)) add(n, d);
  }
}

void Evaluator::require_no_pole(const Rational& a, const Rational& b) const {
  const Interval path = closed(std::min(a, b), std::max(a, b));
  const auto check = [&](const Polynomial& d) {
    if (count_real_roots(d, path) == 0) return;
    const Interval pole = located_real_roots(d, path).front();
    throw DomainError(fmt::format("definite integral from {} to {}: pole at t {} {}", to_string(a),
                                  to_string(b), pole.lower == pole.upper ? "=" : "in",
                                  to_string(pole)));
  };
  if (!rational_.is_polynomial()) check(rational_.denominator());
  for (const Poles& p : poles_)
    if (!p.roots.real.empty()) check(p.denominator);
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

RealBall Evaluator::difference(const Rational& a, const Rational& b, long bits) {
  prepare(bits + 24);
  require_no_pole(a, b);
  const Rational rational = rational_difference(a, b);
  if (poles_.empty() || a == b) return RealBall(rational, bits + 8);
  const long end = 64 * bits + 65536;
  for (long precision = bits + 24;; precision = std::min(end, precision + precision / 2)) {
    prepare(precision);
    RealBall value = add(RealBall(rational, precision), log_difference(a, b, precision), precision);
    if (value.is_accurate(bits)) return value;
    if (precision == end)
      throw Undecided(
          fmt::format("definite integral from {} to {}: {} bits of precision do not "
                      "give an enclosure of width 2^-{}",
                      to_string(a), to_string(b), end, bits));
  }
}

/// Λ = Σ c(z) log((b − z)/(a − z)) grouped by equal residues α is Σ α·L(α), where L(α) is a value
/// of log(v(α, b)/v(α, a)), v as in Rothstein–Trager's form. If v(α, b) = r·v(α, a) with r ∈ ℚ,
/// exactly, then L(α) = log|r| + πi·k with a whole k, which a ball narrower than half a turn
/// determines. So all k = 0 and, for every irreducible q, log|r| = 0 or Σ_{q(α)=0} α = 0 prove Λ =
/// 0. Poles z and z̄ turn in opposite directions, so k = 0 for a real α, and for an α above the real
/// axis πk = Σ_{c(z)=α} arg − Σ_{c(z)=ᾱ} arg over the poles z above it.
bool Evaluator::logs_cancel(const Rational& a, const Rational& b) const {
  std::vector<LogSum> sums;
  for (const Poles& p : poles_) sums.push_back(rothstein_trager({p.numerator, p.denominator}));
  Polynomial residues{1};
  for (const LogSum& sum : merge_equal_residues(std::move(sums))) {
    const Polynomial at_a = evaluate_at(sum.argument, a) % sum.index;
    const Polynomial at_b = evaluate_at(sum.argument, b) % sum.index;
    const Rational ratio = at_b.leading_coefficient() / at_a.leading_coefficient();
    if (!(at_b == ratio * at_a)) return false;
    if (abs(ratio) != 1 && QuotientRing(sum.index).trace(sum.residue) != 0) return false;
    residues *= sum.index;
  }
  const Roots alphas = isolate_roots(residues, precision_);
  std::vector<RealBall> turns(alphas.upper.size());
  for (const Poles& p : poles_)
    for (std::size_t k = 0; k < p.roots.upper.size(); ++k) {
      const ComplexBall& c = p.upper_residues[k];
      const RealBall turn = log_ratio(p.roots.upper[k], a, b, precision_).im();
      long matches = 0;
      for (const RealBall& alpha : alphas.real) matches += c.overlaps({alpha, RealBall()}) ? 1 : 0;
      for (std::size_t j = 0; j < turns.size(); ++j) {
        if (c.overlaps(alphas.upper[j])) {
          turns[j] = add(turns[j], turn, precision_);
          ++matches;
        }
        if (c.overlaps(conjugate(alphas.upper[j]))) {
          turns[j] = subtract(turns[j], turn, precision_);
          ++matches;
        }
      }
      if (matches != 1) return false;  // the balls are too wide to tell the residues apart
    }
  return std::all_of(turns.begin(), turns.end(), [](const RealBall& turn) {
    return turn.is_finite() && turn.lower() > -1 && turn.upper() < 1;
  });
}

Real Evaluator::value(const Rational& a, const Rational& b) {
  constexpr long bits = 128;  // enough for a double, so that the first ball is often the last
  const RealBall first = difference(a, b, bits);
  if (poles_.empty() || a == b) return rational_difference(a, b);
  if (first.contains(rational_difference(a, b)) && logs_cancel(a, b))
    return rational_difference(a, b);
  return Real([this, a, b, first](long precision) {
    return precision <= bits ? first : difference(a, b, precision);
  });
}

RealBall definite(const Antiderivative& F, const Rational& a, const Rational& b, long bits) {
  return Evaluator(F).difference(a, b, bits);
}

}  // namespace phrame
