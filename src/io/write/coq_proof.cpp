#include "phrame/io/write/coq_proof.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "phrame/ph/curve/invariants.hpp"
#include "phrame/version.hpp"

namespace phrame::inline v0 {
namespace {

/// "3", "(-1/2)": Coq's reals have no rationals, but quotients.
std::string number(const Rational& x) {
  const std::string text = to_string(x);
  return x < 0 || denominator(x) != 1 ? "(" + text + ")" : text;
}

/// Horner's form, which the tactics evaluate with the fewest operations: "(4 * t - 4) * t + 2".
std::string horner(const Polynomial& p) {
  std::string text = number(p.leading_coefficient());
  bool is_sum = false;
  for (long k = p.degree() - 1; k >= 0; --k) {
    const Rational c = p.coefficient(k);
    text = text == "1" ? "t" : (is_sum ? "(" + text + ")" : text) + " * t";
    is_sum = c != 0;
    if (is_sum) text += (c < 0 ? " - " : " + ") + number(abs(c));
  }
  return text;
}

/// As an argument of a function.
std::string argument(const Polynomial& p) { return "(" + horner(p) + ")"; }

std::string coq_quotient(const RationalFunction& f) {
  return fmt::format("{} / {}", argument(f.numerator()), argument(f.denominator()));
}

std::string quaternion(const QuaternionPolynomial& a) {
  return fmt::format("Quaternion\n  {}\n  {}\n  {}\n  {}", argument(a.u), argument(a.v),
                     argument(a.p), argument(a.q));
}

QuaternionPolynomial differentiate(const QuaternionPolynomial& a) {
  return {differentiate(a.u), differentiate(a.v), differentiate(a.p), differentiate(a.q)};
}

/// |θ(t) − 0.2858| ≤ 5e-5; Coq reads decimals.
std::string nearness(const CoqAnswer& answer) {
  const std::string& value = answer.theta.value;
  return fmt::format("Rabs (theta {} - {}) <= 5e{}", number(answer.t),
                     value.starts_with('-') ? "(" + value + ")" : value,
                     decimal_exponent(answer.half_unit));
}

/// "1/3 + (1/2) * PI + atan (3/4)".
std::string coq_angle(const FrameAngle& angle) {
  std::vector<std::string> terms;
  if (angle.radians != 0) terms.push_back(number(angle.radians));
  const auto& z = angle.direction;
  const Rational half_turns = angle.half_turns + (z.re == 0 ? Rational(1, 2) : Rational(0));
  if (half_turns != 0) terms.push_back(number(half_turns) + " * PI");
  if (z.re != 0 && z.im != 0) terms.push_back("atan " + number(z.im / z.re));
  return terms.empty() ? "0" : fmt::format("{}", fmt::join(terms, " + "));
}

std::string coq_header(const CoqAnswer& answer) {
  return fmt::format(
      "(* The rotation-minimizing frame of a curve, and its angle at t = {}.\n"
      "   Written by phrame {}. What is proved is the last theorem. It needs Coq with Coquelicot "
      "and\n"
      "   CoqInterval, and beside it phrame's rotation_minimizing.v, compiled, which says what "
      "the\n"
      "   words mean. *)\n"
      "From Coq Require Import Reals Lra.\n"
      "From Coquelicot Require Import Coquelicot.\n"
      "From Interval Require Import Tactic.\n"
      "Require Import rotation_minimizing.\n"
      "Open Scope R_scope.\n\n",
      to_string(answer.t), version);
}

/// W > 0 in the domain, and the sign that it is multiplied by.
std::pair<Polynomial, Rational> weight_and_sign(const Curve& curve) {
  const Rational sign = curve.weight()(0) < 0 ? -1 : 1;
  return {sign * curve.weight(), sign};
}

std::string curve_definitions(const CoqAnswer& answer) {
  const Curve& curve = answer.curve;
  const QuaternionPolynomial derivative = differentiate(curve.preimage());
  std::string text = fmt::format(
      "(* The preimage A = u + v i + p j + q k, its derivative{}, the multiplier f, the curve r. "
      "*)\n"
      "Definition A (t : R) := {}.\n"
      "Definition A' (t : R) := {}.\n",
      answer.bend_rate ? "s" : "", quaternion(curve.preimage()), quaternion(derivative));
  if (answer.bend_rate)
    text += fmt::format("Definition A'' (t : R) := {}.\n", quaternion(differentiate(derivative)));
  const auto [x, y, z] = numerator(curve);
  if (curve.is_polynomial())
    return text + fmt::format(
                      "Definition f (t : R) := {}.\n"
                      "Definition r (t : R) := Vector\n  {}\n  {}\n  {}.\n\n",
                      horner(curve.multiplier()), argument(x), argument(y), argument(z));
  const auto [weight, sign] = weight_and_sign(curve);
  return text + fmt::format(
                    "Definition W (t : R) := {}.\n"
                    "Definition f (t : R) := {} / (W t * W t).\n"
                    "Definition r (t : R) := Vector\n"
                    "  ({} / W t)\n  ({} / W t)\n  ({} / W t).\n\n",
                    horner(weight), argument(curve.multiplier()), argument(sign * x),
                    argument(sign * y), argument(sign * z));
}

std::string rate_of(const CoqAnswer& answer) {
  return answer.bend_rate ? "frenet_rate (A t) (A' t) (A'' t)"
                          : "-2 * h (A t) (A' t) / sigma (A t)";
}

std::string frame_definitions(const CoqAnswer& answer) {
  const bool is_frenet = answer.bend_rate.has_value();
  const auto& domain = answer.domain;
  const char* const e2 = is_frenet ? "(normal (A t) (A' t))" : "(e2 (A t))";
  const char* const e3 = is_frenet ? "(binormal (A t) (A' t))" : "(e3 (A t))";
  return fmt::format(
      "(* Where the theorem holds. *)\n"
      "Definition D (t : R) := {}.\n\n"
      "(* The angle, and the {} frame turned by it. *)\n"
      "Definition start := {}.\n"
      "Definition theta (t : R) := start + RInt (fun t => {}) 0 t.\n"
      "Definition f2 (t : R) :=\n"
      "  add (scale (cos (theta t)) {}) (scale (sin (theta t)) {}).\n"
      "Definition f3 (t : R) :=\n"
      "  add (scale (- sin (theta t)) {}) (scale (cos (theta t)) {}).\n\n",
      domain ? fmt::format("{} < t < {}", number(domain->lower), number(domain->upper)) : "True",
      is_frenet ? "Frenet" : "Euler-Rodrigues", coq_angle(answer.start), rate_of(answer), e2, e3,
      e2, e3);
}

/// The proof of 0 < p on the domain, where `shown` is how p is made of what it is called.
std::string positive_by_intervals(const CoqAnswer& answer, const std::string& shown,
                                  const Polynomial& p) {
  const auto& [lower, upper] = *answer.domain;
  return fmt::format(
      "  intros [H1 H2]; assert (H : {} <= t <= {}) by lra.\n"
      "  replace ({}) with {} by (expand; field).\n"
      "  interval with (i_bisect t, i_taylor t, i_prec {}, i_depth 60).\n",
      number(lower), number(upper), shown, argument(p), answer.effort.precision);
}

std::string lemmas_of_curve(const CoqAnswer& answer) {
  const Curve& curve = answer.curve;
  const bool is_polynomial = curve.is_polynomial();
  std::string text = fmt::format(
      "Ltac expand := unfold g_squared, g_re, g_im, sigma, h, A, A'{}{}; simpl.\n\n"
      "Lemma A_derivative t : quaternion_derivative A t (A' t).\n"
      "Proof. unfold A, A'; differentiate. Qed.\n",
      answer.bend_rate ? ", A''" : "", is_polynomial ? "" : ", W");
  text += answer.bend_rate ? "Lemma A'_derivative t : quaternion_derivative A' t (A'' t).\n"
                             "Proof. unfold A', A''; differentiate. Qed.\n"
                             "Lemma A''_continuous t : quaternion_continuous A'' t.\n"
                             "Proof. unfold A''; continuous_polynomials. Qed.\n"
                           : "Lemma A'_continuous t : quaternion_continuous A' t.\n"
                             "Proof. unfold A'; continuous_polynomials. Qed.\n";
  if (!is_polynomial)
    text += "Lemma W_positive t : D t -> 0 < W t.\nProof.\n" +
            positive_by_intervals(answer, "W t", weight_and_sign(curve).first) + "Qed.\n";
  text += "Lemma sigma_positive t : D t -> 0 < sigma (A t).\nProof.\n";
  if (const auto& c = answer.cofactors)
    text += fmt::format(
        "  intros _; apply positive_by_cofactors with (Quaternion\n"
        "    {}\n    {}\n    {}\n    {}).\n"
        "  unfold A; simpl; field.\n",
        argument((*c)[0]), argument((*c)[1]), argument((*c)[2]), argument((*c)[3]));
  else
    text += positive_by_intervals(answer, "sigma (A t)", sigma(curve.preimage()));
  text += fmt::format(
      "Qed.\n"
      "Lemma r_derivative t : D t -> derivative r t (scale (f t * sigma (A t)) (e1 (A t))).\n"
      "Proof.\n"
      "  intro H; apply tangent_of_curve; [exact (sigma_positive t H) |].\n"
      "{}"
      "  unfold r, f, A{}; differentiate.\n"
      "Qed.\n",
      is_polynomial ? "" : "  pose proof (W_positive t H) as P; unfold W in P.\n",
      is_polynomial ? "" : ", W");
  return text;
}

/// That g has no zero.
std::string lemma_of_bend(const CoqAnswer& answer) {
  if (!answer.bend_rate) return "";
  std::string text = "Lemma no_inflection t : D t -> 0 < g_squared (A t) (A' t).\nProof.\n";
  if (const auto& c = answer.bend_cofactors)
    text += fmt::format(
        "  intros _; apply positive_by_two_cofactors with\n    {}\n    {}.\n"
        "  expand; field.\n",
        argument((*c)[0]), argument((*c)[1]));
  else
    text += positive_by_intervals(answer, "g_squared (A t) (A' t)",
                                  Rational(1, 4) * rho(answer.curve.preimage()));
  return text + "Qed.\n";
}

std::string lower_terms(const CoqAnswer::Fraction& fraction, const char* positive) {
  return fmt::format(
      "  {{ apply lower_terms with {}; [exact ({} t H) | expand; field | expand; field]. }}\n",
      argument(fraction.common), positive);
}

std::string lemmas_of_angle(const CoqAnswer& answer) {
  std::string rate = coq_quotient(answer.rate.lowest);
  std::string proof = lower_terms(answer.rate, "sigma_positive");
  if (const auto& bend = answer.bend_rate) {
    rate += " +\n  " + coq_quotient(bend->lowest);
    proof = "  unfold frenet_rate; f_equal.\n" + proof + lower_terms(*bend, "no_inflection");
  }
  return fmt::format(
      "Lemma rate_in_lowest_terms t : D t -> {} =\n  {}.\n"
      "Proof.\n  intro H.\n{}Qed.\n"
      "Lemma D_interval : open_interval D.\n"
      "Proof. {}. Qed.\n"
      "Lemma D_there t : 0 <= t <= {} -> D t.\n"
      "Proof. unfold D; lra. Qed.\n\n",
      rate_of(answer), rate, proof, answer.domain ? "apply between" : "exact everywhere",
      number(answer.t));
}

std::string theorem(const CoqAnswer& answer) {
  const bool is_frenet = answer.bend_rate.has_value();
  const auto& [precision, degree, fuel] = answer.effort;
  std::string text = fmt::format(
      "(* theta({}) = {}, correctly rounded: within half of one in its last place. *)\n"
      "Theorem frame :\n"
      "  (forall t, 0 <= t <= {} -> D t) /\\\n"
      "  (* e1 is a unit vector along r', which has the length |f| sigma. *)\n"
      "  (forall t, D t -> 0 < sigma (A t) /\\\n"
      "    derivative r t (scale (f t * sigma (A t)) (e1 (A t)))) /\\\n",
      to_string(answer.t), answer.theta.value, number(answer.t));
  if (is_frenet)
    text +=
        "  (* The tangent turns to the normal. *)\n"
        "  (forall t, D t -> 0 < g_abs (A t) (A' t) /\\\n"
        "    derivative (fun t => e1 (A t)) t\n"
        "      (scale (2 * g_abs (A t) (A' t) / sigma (A t)) (normal (A t) (A' t))) /\\\n"
        "    right_handed (e1 (A t)) (normal (A t) (A' t)) (binormal (A t) (A' t))) /\\\n";
  text += fmt::format(
      "  (* The angle. *)\n"
      "  theta 0 = start /\\\n"
      "  (forall t, D t -> is_derive theta t ({})) /\\\n"
      "  (* e1, f2, f3 are a right-handed frame, and f2', f3' are parallel to e1. *)\n"
      "  rotation_minimizing D (fun t => e1 (A t)) f2 f3 /\\\n"
      "  (* Any other such frame is this one turned by a constant. *)\n"
      "  (forall g2 g3, rotation_minimizing D (fun t => e1 (A t)) g2 g3 ->\n"
      "    exists a, forall t, D t -> g2 t = turn2 a (f2 t) (f3 t) /\\ g3 t = turn3 a (f2 t) (f3 "
      "t)) /\\\n"
      "  {}.\n",
      rate_of(answer), nearness(answer));
  text += fmt::format(
      "Proof.\n"
      "  destruct ({} D_interval (D_there 0 ltac:(lra))\n"
      "    (fun t _ => A_derivative t) sigma_positive {})\n"
      "    as (Hstart & Hrate & Hframe & Hunique).\n"
      "  split; [exact D_there |].\n"
      "  split; [intros t H; exact (conj (sigma_positive t H) (r_derivative t H)) |].\n",
      is_frenet ? "frame_by_psi D A A' A'' start" : "frame_by_theta D A A' start",
      is_frenet ? "(fun t _ => A'_derivative t)\n    (fun t _ => A''_continuous t) no_inflection"
                : "(fun t _ => A'_continuous t)");
  if (is_frenet)
    text +=
        "  split; [intros t H; split; [exact (g_abs_positive D A A' no_inflection t H) |];\n"
        "    exact (frenet_frame D A A' (fun t _ => A_derivative t) sigma_positive no_inflection "
        "t H) |].\n";
  return text +
         "  split; [exact Hstart |].\n"
         "  split; [exact Hrate |].\n"
         "  split; [exact Hframe |].\n"
         "  split; [exact Hunique |].\n" +
         fmt::format(
             "  unfold theta; rewrite (angle_of_same_rate D _ _ start {} D_interval "
             "(D_there 0 ltac:(lra))\n"
             "    (D_there {} ltac:(lra)) rate_in_lowest_terms).\n"
             "  unfold start; integral with (i_prec {}, i_degree {}, i_fuel {}).\n"
             "Qed.\n",
             number(answer.t), number(answer.t), precision, degree, fuel);
}

}  // namespace

std::string coq_proof(const CoqAnswer& answer) {
  return coq_header(answer) + curve_definitions(answer) + frame_definitions(answer) +
         lemmas_of_curve(answer) + lemma_of_bend(answer) + lemmas_of_angle(answer) +
         theorem(answer);
}

}  // namespace phrame
