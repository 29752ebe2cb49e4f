#include "phrame/integrate/real_form.hpp"

#include "phrame/algebra/error.hpp"
#include "phrame/integrate/definite.hpp"
#include "phrame/integrate/integrate.hpp"
#include "support/random.hpp"

using namespace phrame;
using test::for_samples;
using test::Random;

namespace {

constexpr long bits = 200;

RealBall value(const Surd& x) {
  return add(RealBall(x.a, bits),
             multiply(RealBall(x.b, bits), sqrt(RealBall(x.d, bits), bits), bits), bits);
}

RealBall value(const SurdPolynomial& p, const Rational& t) {
  return value(Surd{p.a(t), p.b(t), p.d});
}

/// The sum over the poles, as real_form.hpp gives it.
RealBall value(const LogSum& sum, const Rational& t) {
  const Roots roots = isolate_roots(sum.index, bits);
  RealBall total;
  RealBall term;
  for (const RealBall& z : roots.real) {
    const RealBall distance = subtract(RealBall(t, bits), z, bits);
    arb_abs(term.raw(), distance.raw());
    arb_log(term.raw(), term.raw(), bits);
    total = add(total, multiply(evaluate(sum.residue, {z, {}}, bits).re(), term, bits), bits);
  }
  for (const ComplexBall& z : roots.upper) {
    const ComplexBall c = evaluate(sum.residue, z, bits);
    const RealBall distance = subtract(RealBall(t, bits), z.re(), bits);
    const RealBall square =
        add(multiply(distance, distance, bits), multiply(z.im(), z.im(), bits), bits);
    arb_log(term.raw(), square.raw(), bits);
    total = add(total, multiply(c.re(), term, bits), bits);
    arb_atan(term.raw(), divide(distance, z.im(), bits).raw(), bits);
    arb_mul_2exp_si(term.raw(), term.raw(), 1);
    total = subtract(total, multiply(c.im(), term, bits), bits);
  }
  return total;
}

RealBall value(const RealForm& form, const Rational& t) {
  RealBall total(form.polynomial(t) + form.rational(t), bits);
  for (const auto& [factor, of, positive] : form.logarithms) {
    RealBall term = value(of, t);
    if (!positive)
      arb_abs(term.raw(), term.raw());  // log of a ball that is not positive is no number
    arb_log(term.raw(), term.raw(), bits);
    total = add(total, multiply(value(factor), term, bits), bits);
  }
  for (const auto& [factor, of] : form.arctangents) {
    RealBall term = value(of, t);
    arb_atan(term.raw(), term.raw(), bits);
    total = add(total, multiply(value(factor), term, bits), bits);
  }
  for (const LogSum& sum : form.others) total = add(total, value(sum, t), bits);
  return total;
}

/// Walks over the real line, around every real zero of the function's denominator's neighbourhood:
/// the change of the form is the certified integral wherever there is no pole between.
void check_values(const RationalFunction& f, const RealForm& form) {
  Evaluator evaluator(integrate(f));
  Rational last = -6;
  for (Rational t = last + Rational(3, 7); t < 6; t += Rational(3, 7)) {
    if (count_real_roots(f.denominator(), closed(last, t)) == 0) {
      const RealBall change = subtract(value(form, t), value(form, last), bits);
      CHECK(change.is_finite());
      CHECK(change.overlaps(evaluator.difference(last, t, 100)));
      CHECK(change.is_accurate(100));
    }
    last = t;
  }
}

}  // namespace

TEST_CASE("real form: Rioboo's arctangents of (x⁴ − 3x² + 6)/(x⁶ − 5x⁴ + 5x² + 4)") {
  // arctan((x⁵ − 3x³ + x)/2) + arctan(x³) + arctan(x) [Bronstein 2005, §2.8].
  const RationalFunction f({6, 0, -3, 0, 1}, {4, 0, 5, 0, -5, 0, 1});
  const RealForm form = real_form(integrate(f));
  const auto arctangent = [](const Polynomial& of) {
    return RealForm::Arctangent{{1, 0, 1}, {of, {}, 1}};
  };
  CHECK(form.logarithms.empty());
  CHECK(form.others.empty());
  CHECK(form.arctangents ==
        std::vector{arctangent({0, Rational(1, 2), 0, Rational(-3, 2), 0, Rational(1, 2)}),
                    arctangent({0, 0, 0, 1}), arctangent({0, 1})});
  check_values(f, form);
}

TEST_CASE("real form: the arctangent of (3x² + x + 1)/(x³ + x) is not lost") {
  // log|x| + log(x² + 1) + arctan x.
  const RealForm form = real_form(integrate({{1, 1, 3}, {0, 1, 0, 1}}));
  CHECK(form.logarithms == std::vector<RealForm::Logarithm>{{{1, 0, 1}, {{0, 1}, {}, 1}, false},
                                                            {{1, 0, 1}, {{1, 0, 1}, {}, 1}, true}});
  CHECK(form.arctangents == std::vector<RealForm::Arctangent>{{{1, 0, 1}, {{0, 1}, {}, 1}}});
}

TEST_CASE("real form: residues in ℚ(√2) and in ℚ(√−3)") {
  // ∫ dx/(x² − 2) = (√2/4)·(log|x − √2| − log|x + √2|).
  const RealForm real = real_form(integrate({{1}, {-2, 0, 1}}));
  CHECK(real.logarithms ==
        std::vector<RealForm::Logarithm>{{{0, Rational(1, 4), 2}, {{0, 1}, {-1}, 2}, false},
                                         {{0, Rational(-1, 4), 2}, {{0, 1}, {1}, 2}, false}});
  // ∫ dx/(x² + x + 1) = (2/√3)·arctan((2x + 1)/√3).
  const RealForm imaginary = real_form(integrate({{1}, {1, 1, 1}}));
  CHECK(imaginary.arctangents ==
        std::vector<RealForm::Arctangent>{
            {{0, Rational(2, 3), 3}, {{}, {Rational(1, 3), Rational(2, 3)}, 3}}});
  check_values({{1}, {1, 1, 1}}, imaginary);
  check_values({{1}, {-2, 0, 1}}, real);
}

TEST_CASE("real form: residues of degree 3 stay a sum over the poles") {
  const RationalFunction f({1}, {1, 1, 0, 1});
  const RealForm form = real_form(integrate(f));
  CHECK(form.others.size() == 1);
  CHECK(form.logarithms.empty());
  check_values(f, form);
}

TEST_CASE("real form: law: its derivative is f, its values are the certified integrals") {
  for_samples(30, [](Random& random) {
    // Logarithmic derivatives of polynomials over ℚ, ℚ(i), ℚ(√d) and ℚ(√−d), and anything.
    RationalFunction f;
    for (long k = random.integer(1, 3); k > 0; --k) {
      const Polynomial a = random.nonconstant_polynomial(3);
      const Polynomial b = random.polynomial(2);
      const Rational d = random.integer(-5, 5);
      const Polynomial n = a * a - d * (b * b);
      if (n.is_constant() || !gcd(a, b).is_constant()) continue;
      // Tr((p + q√d)(a′ + b′√d)/(a + b√d)).
      const Polynomial x = differentiate(a) * a - d * (differentiate(b) * b);
      const Polynomial y = differentiate(b) * a - differentiate(a) * b;
      f = f + RationalFunction(random.rational() * x + (random.rational() * d) * y, n);
    }
    if (random.chance(3))
      f = f + RationalFunction(random.polynomial(5), random.nonzero_polynomial(4));
    for (const Form from : {Form::automatic, Form::partial_fractions}) {
      const RealForm form = real_form(integrate(f, from));
      CHECK(differentiate(form) == f);
      check_values(f, form);
    }
  });
}
