// The grid is as fine as the claims need: with discs of a first, coarse grid it is known what the
// angle may be off, and that falls as 2^−bits. The bound is rational arithmetic on what does not
// depend on the machine, so that no two machines choose different grids.
#include "phrame/ph/proof/certify.hpp"

#include <algorithm>

#include "phrame/algebra/argument.hpp"
#include "phrame/algebra/modular.hpp"
#include "phrame/ph/curve/ph_path.hpp"
#include "phrame/ph/proof/check_decisions.hpp"
#include "phrame/ph/proof/disc_laws.hpp"
#include "phrame/ph/proof/stated_number.hpp"

namespace phrame::inline v0 {
namespace {

/// A prime modulo which a and b, not both 0, are coprime: proof that they are coprime.
Integer coprime_modulus(const Polynomial& a, const Polynomial& b) {
  const IntegerPolynomial f = integer_primitive_part(a);
  const IntegerPolynomial g = integer_primitive_part(b);
  Primes primes;
  for (;;) {
    const Word p = primes.next();
    const ModularPolynomial x(p, f);
    const ModularPolynomial y(p, g);
    const bool is_good = x.degree() == a.degree() && y.degree() == b.degree();
    if (is_good && are_coprime(x, y)) return Integer(p);
  }
}

/// The sums over the poles of F′ without their discs.
std::vector<CertifiedLogs> logs_over_poles(const Antiderivative& F) {
  std::vector<CertifiedLogs> logs;
  for (const LogSum& sum : F.logs) logs.push_back({primitive_part(sum.index), sum.residue, {}});
  return logs;
}

/// Discs for all roots; false where the grid is too coarse.
bool place_discs(std::vector<CertifiedLogs>& logs, long bits) {
  for (CertifiedLogs& sum : logs) {
    const Polynomial n = (sum.residue * differentiate(sum.index)) % sum.index;
    auto discs = root_discs(sum.index, n, bits);
    if (!discs) return false;
    sum.roots = *std::move(discs);
  }
  return true;
}

/// On a grid that proves the angle up to `slack` for all |t| ≤ reach and, where there is no
/// rational frame though all poles are simple, a residue that is not in iℤ.
void place_discs(Certificate& c, const std::optional<Rational>& slack, const Rational& reach) {
  const bool shows_residue = !c.decisions.rational_frame && c.rational.is_zero();
  for (c.bits = 64;;) {
    long missing = c.bits;  // where nothing is known yet, twice as many
    if (place_discs(c.logs, c.bits)) {
      Rational error = 0;
      for (const CertifiedLogs& sum : c.logs) error += log_error(sum.roots, c.bits, reach);
      const bool is_fine = !slack || error <= *slack;
      if (is_fine && (!shows_residue || shows_residue_outside_multiples_of_i(c.logs, c.bits)))
        return;
      if (!is_fine) missing = binary_exponent(error / *slack) + 2;
    }
    c.bits += missing;
  }
}

/// A claim, and what the angle may be off for it to be proved: 0 where no logarithm is needed.
struct Planned {
  AngleClaim claim;
  Rational slack;
};

Planned plan(const Real& theta, const Rational& t, long digits, bool is_rational) {
  const StatedNumber stated = stated_number(theta, digits, is_rational, 32);
  return {{t, stated.value, stated.radius, {}}, stated.slack};
}

}  // namespace

Certificate certify(const Curve& curve, Reference reference, const std::vector<Rational>& at,
                    long digits) {
  if (!curve.is_polynomial())
    for (const Rational& t : at) locate_inside(1, t);
  const QuaternionPolynomial& a = curve.preimage();
  const RationalFunction rate = rate_to_erf(a);
  const Polynomial s = sigma(a);
  const Antiderivative F = integrate(rate, Form::partial_fractions);
  const RmfAngle angle(curve, reference, Form::partial_fractions);
  const Classification classification = classify(curve);

  Certificate c{curve,
                reference,
                hodograph_numerator(curve),
                s,
                twist_numerator(a),
                bend_numerator(a),
                {rate.numerator(), rate.denominator(), exact_quotient(s, rate.denominator()),
                 coprime_modulus(rate.numerator(), rate.denominator())},
                F.rational,
                logs_over_poles(F),
                0,
                {},
                {},
                stated(classification)};
  std::optional<ContinuousArgument> bend;
  if (reference == Reference::frenet) {
    c.bend = {regular_bend(a), gcd(c.g.re, c.g.im)};
    bend.emplace(c.bend->polynomial);
  }
  Rational reach = 0;
  std::optional<Rational> slack;
  for (const Rational& t : at) {
    const bool is_rational = t == 0 || angle.antiderivative().logs.empty();
    Planned planned = plan(angle.value(t), t, digits, is_rational);
    if (bend) planned.claim.turn = bend->turn(t);
    c.claims.push_back(std::move(planned.claim));
    reach = std::max(reach, Rational(abs(t)));
    if (!is_rational && (!slack || planned.slack < *slack)) slack = planned.slack;
  }
  if (!c.logs.empty()) place_discs(c, slack, reach);
  return c;
}

}  // namespace phrame
