#include "phrame/ph/frame/rational_frame.hpp"

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/factor.hpp"
#include "phrame/algebra/resultant.hpp"
#include "phrame/integrate/gaussian_logs.hpp"
#include "phrame/ph/along/rmf_angle.hpp"
#include "phrame/ph/curve/invariants.hpp"

// e₂ and e₃ of A are A j A*/σ and A k A*/σ. For a complex w = |w|e^{iφ} the frame of B = A·w has
// B j B*/|B|² = A e^{2iφ} j A*/σ = cos 2φ·e₂ + sin 2φ·e₃: that of A, turned by 2φ. So A·w has a
// rotation-minimizing frame where 2·arg w = θ, and e^{iθ} = w²/|w|² is rational. The converse:
//
// θ = ∫ −2h/σ = Σ −2·Im c·arg(t − z) + Re c·log|t − z|² over the poles z with Im z > 0 and residues
// c, plus the integral of a proper rational function where a pole is multiple. e^{iθ} is rational
// only if the latter is 0, all Re c are 0, and all e^{−2i·Im c·arg(t − z)} = ((t − z)/(t − z̄))^{−Im
// c} are rational: these are independent, and Im c must be an integer. Where all residues are, θ is
// Σ k·arg v with even k and v the product of the t − z with the residue −ik/2.

namespace phrame::inline v0 {
namespace {

/// The polynomial whose roots are the n with p(in) = 0, n real.
Polynomial on_imaginary_axis(const Polynomial& p) {
  std::vector<Rational> re;
  std::vector<Rational> im;
  for (long k = 0; k <= p.degree(); ++k) {
    const Rational c = k % 4 < 2 ? p.coefficient(k) : -p.coefficient(k);
    re.push_back(k % 2 == 0 ? c : Rational(0));
    im.push_back(k % 2 == 0 ? Rational(0) : c);
  }
  return gcd(Polynomial(re), Polynomial(im));
}

/// p without its roots in iℤ; p is squarefree.
Polynomial without_integer_multiples_of_i(Polynomial p) {
  const Polynomial on_axis = on_imaginary_axis(p);
  if (on_axis.is_constant()) return p;
  for (const auto& [base, exponent] : factor(on_axis).factors) {
    const Rational n = base.coefficient(0);
    // n and −n both: n = 0 is no residue.
    if (base.degree() == 1 && base.coefficient(1) == 1 && n > 0)
      p = exact_quotient(p, Polynomial{n * n, 0, 1});
  }
  return p;
}

}  // namespace

std::variant<RationalFrame, NoRationalFrame> rational_frame(const QuaternionPolynomial& a) {
  using Reason = NoRationalFrame::Reason;
  const RationalFunction rate = rate_to_erf(a);
  RationalFrame frame{{{1}, {}}, {}};
  if (!rate.is_zero()) {
    const Polynomial& d = rate.denominator();
    const Polynomial multiple = gcd(d, differentiate(d));
    if (!multiple.is_constant())
      return NoRationalFrame{Reason::multiple_pole, squarefree_part(multiple)};
    const Polynomial offending =
        without_integer_multiples_of_i(squarefree_part(residue_polynomial(-rate.numerator(), d)));
    if (!offending.is_constant())
      return NoRationalFrame{Reason::residue, primitive_part(offending)};
    GaussianLogs half = gaussian_logs(integrate(rate, Form::rothstein_trager).logs);
    for (GaussianLogs::Argument& argument : half.arguments) argument.factor /= 2;
    frame.w = single_argument(half).value();
    const Polynomial slope = (differentiate(frame.w) * conjugate(frame.w)).im;
    if (!(RationalFunction(Rational(2) * slope, norm(frame.w)) == rate))
      throw Error("rational_frame: the check failed, 2·arg w is not the angle");
  }
  const auto [alpha, beta] = hopf_form(a);
  frame.preimage = without_real_content(from_hopf_form({alpha * frame.w, beta * frame.w}));
  return frame;
}

}  // namespace phrame
