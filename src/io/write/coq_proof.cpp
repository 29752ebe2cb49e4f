// On a part [c − r, c + r] of [0, t] a Taylor polynomial of degree d is off by about (r/R)^(d+1), R
// the distance of c to the next pole of h/σ. Parts are halved until that is small enough; this is
// what the tactic does, too, so that their number bounds its fuel. Nothing is proved here: a wrong
// guess makes coqc fail or take long, not accept.
#include "phrame/io/write/coq_proof.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/roots.hpp"
#include "phrame/io/write/text.hpp"
#include "phrame/ph/frame/rmf_angle.hpp"
#include "phrame/version.hpp"

namespace phrame {
namespace {

/// "(3)", "(-1/2)": Coq's reals have no rationals, but quotients.
std::string number(const Rational& x) { return "(" + to_string(x) + ")"; }

/// Horner's form, which the tactic evaluates with the fewest operations.
std::string horner(const Polynomial& p) {
  if (p.is_zero()) return "0";
  std::string text = number(p.leading_coefficient());
  for (long k = p.degree() - 1; k >= 0; --k)
    text = fmt::format("({} * t + {})", text, number(p.coefficient(k)));
  return text;
}

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

struct Effort {
  long precision;
  long degree;
  long fuel;
};

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

}  // namespace

std::string coq_proof(const NamedCurve& named, const Rational& t, long digits) {
  const QuaternionPolynomial& a = named.curve.preimage();
  if (t <= 0) throw DomainError("proof: t = " + to_string(t) + " is not positive");
  const Polynomial s = sigma(a);
  if (count_real_roots(s, closed(0, t)) > 0)
    throw DomainError("proof: the preimage has a zero between 0 and t = " +
                      abbreviated(to_string(t)) + ", where h/sigma is undefined");
  const Polynomial h = twist_numerator(a);
  const RmfAngle angle(named.curve);
  const std::string shown = rounded(angle.value(t), "theta", digits).value;
  const Rational theta = parse_rational(shown);
  const long leading = theta == 0 ? -1 : decimal_exponent(abs(theta));
  const Rational unit = power_of_ten(leading + 1 - digits);  // one in the place of the last digit
  const Effort tactic = effort(angle.rate(), t, digits);

  std::string text = fmt::format(
      "(* The angle of the rotation-minimizing frame at t = {}, written by phrame {}.\n"
      "   The theorem is the last one. Needs Coq with Coquelicot and CoqInterval. *)\n"
      "From Coq Require Import Reals.\n"
      "From Coquelicot Require Import Coquelicot.\n"
      "From Interval Require Import Tactic.\n"
      "Open Scope R_scope.\n\n"
      "(* The preimage A = u + v i + p j + q k. *)\n",
      to_string(t), version);
  const std::array<std::pair<const char*, const Polynomial*>, 4> parts{
      {{"u", &a.u}, {"v", &a.v}, {"p", &a.p}, {"q", &a.q}}};
  for (const auto& [name, polynomial] : parts)
    text += fmt::format(
        "Definition {0} (t : R) := {1}.\n"
        "Definition {0}' (t : R) := {2}.\n"
        "Lemma {0}_derivative t : is_derive {0} t ({0}' t).\n"
        "Proof. unfold {0}, {0}'; auto_derive; first [exact I | field]. Qed.\n\n",
        name, horner(*polynomial), horner(differentiate(*polynomial)));
  text += fmt::format(
      "Definition sigma t := u t * u t + v t * v t + p t * p t + q t * q t.\n"
      "Definition h t := u t * v' t - u' t * v t - p t * q' t + p' t * q t.\n\n"
      "Lemma sigma_expanded t : sigma t = {}.\n"
      "Proof. unfold sigma, u, v, p, q; field. Qed.\n\n"
      "Lemma h_expanded t : h t = {}.\n"
      "Proof. unfold h, u, v, p, q, u', v', p', q'; field. Qed.\n\n",
      horner(s), horner(h));
  text += fmt::format(
      "(* theta' = -2h/sigma; theta = {0}, correctly rounded. *)\n"
      "Theorem angle :\n"
      "  Rabs (RInt (fun t => -2 * h t / sigma t) 0 {1} -\n"
      "      {2}) <=\n"
      "      {3}.\n"
      "Proof.\n"
      "  rewrite (RInt_ext _ (fun t => -2 * {4} / {5}));\n"
      "    [| intros t _; rewrite h_expanded, sigma_expanded; reflexivity].\n"
      "  integral with (i_prec {6}, i_degree {7}, i_fuel {8}).\n"
      "Qed.\n",
      shown, number(t), number(theta), number(unit), horner(h), horner(s), tactic.precision,
      tactic.degree, tactic.fuel);
  return text;
}

}  // namespace phrame
