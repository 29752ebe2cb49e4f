#include "phrame/io/write/coq_proof.hpp"

#include <fmt/format.h>

#include <array>

#include "phrame/ph/curve/invariants.hpp"
#include "phrame/version.hpp"

namespace phrame::inline v0 {
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

}  // namespace

std::string coq_proof(const CoqAnswer& answer) {
  const QuaternionPolynomial& a = answer.curve.preimage();
  const Polynomial s = sigma(a);
  const Polynomial h = twist_numerator(a);
  const auto& [precision, degree, fuel] = answer.effort;
  std::string text = fmt::format(
      "(* The angle of the rotation-minimizing frame at t = {}, written by phrame {}.\n"
      "   The theorem is the last one. Needs Coq with Coquelicot and CoqInterval. *)\n"
      "From Coq Require Import Reals.\n"
      "From Coquelicot Require Import Coquelicot.\n"
      "From Interval Require Import Tactic.\n"
      "Open Scope R_scope.\n\n"
      "(* The preimage A = u + v i + p j + q k. *)\n",
      to_string(answer.t), version);
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
      "(* theta' = -2h/sigma; theta = {0}, correctly rounded: within half of one in its last\n"
      "   place. *)\n"
      "Theorem angle :\n"
      "  Rabs (RInt (fun t => -2 * h t / sigma t) 0 {1} -\n"
      "      {2}) <=\n"
      "      {3}.\n"
      "Proof.\n"
      "  rewrite (RInt_ext _ (fun t => -2 * {4} / {5}));\n"
      "    [| intros t _; rewrite h_expanded, sigma_expanded; reflexivity].\n"
      "  integral with (i_prec {6}, i_degree {7}, i_fuel {8}).\n"
      "Qed.\n",
      answer.theta.value, number(answer.t), number(parse_rational(answer.theta.value)),
      number(answer.half_unit), horner(h), horner(s), precision, degree, fuel);
  return text;
}

}  // namespace phrame
