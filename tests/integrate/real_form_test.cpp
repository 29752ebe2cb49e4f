#include "phrame/integrate/real_form.hpp"

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/roots.hpp"
#include "phrame/integrate/definite.hpp"
#include "phrame/integrate/integrate.hpp"
#include "support/random.hpp"
#include "support/surds.hpp"

using namespace phrame;
using test::for_samples;
using test::norm;
using test::Random;

namespace {

constexpr long bits = 200;

RealBall value(const Surd& x) { return test::value(x, bits); }

RealBall value(const SurdPolynomial& p, const Rational& t) {
  Surd sum;
  for (const auto& [d, c] : p.terms()) sum.add(c(t), d);
  return value(sum);
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
  for (const auto& [factor, of, radicand] : form.arctangents) {
    const RealBall root = sqrt(value(radicand), bits);
    RealBall term = multiply(root, value(of, t), bits);
    arb_atan(term.raw(), term.raw(), bits);
    total = add(total, multiply(multiply(root, value(factor), bits), term, bits), bits);
  }
  for (const auto& [factor, of, radicand] : form.quotients) {
    const RealBall root = sqrt(value(radicand), bits);
    const RealBall w = value(of, t);
    RealBall term = absolute(divide(subtract(w, root, bits), add(w, root, bits), bits));
    arb_log(term.raw(), term.raw(), bits);
    total = add(total, multiply(multiply(root, value(factor), bits), term, bits), bits);
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

// The table of integrals: ∫ dx/(x⁴ + 1) = √2/8·log((x² + √2x + 1)/(x² − √2x + 1))
//   + √2/4·(arctan(√2x + 1) + arctan(√2x − 1)) [Gradshteyn, Ryzhik, 2.132.1].
TEST_CASE("textbook form: 1/(x⁴ + 1) over ℚ(√2)") {
  const RationalFunction f({1}, {1, 0, 0, 0, 1});
  const auto [form, sums] = textbook_form(integrate(f));
  CHECK(sums.empty());
  CHECK(form.others.empty());
  const Surd eighth(0, Rational(1, 8), 2);
  const Surd root(0, 1, 2);
  CHECK(form.logarithms == std::vector<RealForm::Logarithm>{
                               {eighth, surd_polynomial({Surd(1), root, Surd(1)}), true},
                               {-eighth, surd_polynomial({Surd(1), -root, Surd(1)}), true}});
  // √(1/2)·(2x ± √2) = √2x ± 1, and 1/2·√(1/2) = √2/4.
  const Surd half(Rational(1, 2));
  CHECK(form.arctangents ==
        std::vector<RealForm::Arctangent>{{half, surd_polynomial({root, Surd(2)}), half},
                                          {half, surd_polynomial({-root, Surd(2)}), half}});
  CHECK(differentiate(form) == f);
  check_values(f, form);
}

TEST_CASE("textbook form: four poles need a real quadratic field, and roots of its numbers") {
  // Poles with real and imaginary parts in ℚ(√3), ℚ(√2, √3), with nested roots, and real ones.
  for (const Polynomial& d :
       {Polynomial{1, 0, -1, 0, 1}, Polynomial{1, 0, 10, 0, 1}, Polynomial{1, 1, 1, 1, 1},
        Polynomial{9, 0, -2, 0, 1}, Polynomial{1, 0, -10, 0, 1}, Polynomial{5, 0, -5, 0, 1},
        Polynomial{-2, 0, 0, 0, 1}, Polynomial{1, 4, 5, 2, 1}}) {
    CAPTURE(to_string(d));
    for (const Polynomial& n : {Polynomial{1}, Polynomial{3, -1}, Polynomial{0, 0, 0, 1},
                                Polynomial{Rational(1, 3), 0, -2, 5}}) {
      const RationalFunction f(n, d);
      const auto [form, sums] = textbook_form(integrate(f));
      CHECK(sums.empty());
      CHECK(differentiate(form) == f);
      check_values(f, form);
    }
  }
}

TEST_CASE("textbook form: what needs no square root has none") {
  // x/(x⁴ + 1) = d/dx arctan(x²)/2, (x² + 1)/(x⁴ − x² + 1) = d/dx (arctan(x) + arctan(x³)).
  const auto arctangents = [](const RationalFunction& f) {
    return textbook_form(integrate(f)).real.arctangents;
  };
  const auto of = [](const Rational& factor, const Polynomial& p) {
    return RealForm::Arctangent{{factor, 0, 1}, {p, {}, 1}};
  };
  CHECK(arctangents({{0, 1}, {1, 0, 0, 0, 1}}) == std::vector{of(Rational(1, 2), {0, 0, 1})});
  CHECK(arctangents({{1, 0, 1}, {1, 0, -1, 0, 1}}) ==
        std::vector{of(1, {0, 0, 0, 1}), of(1, {0, 1})});
  // Equal residues of different factors stay apart: arctan(x) + arctan(x + 1).
  const RationalFunction two = RationalFunction({1}, {1, 0, 1}) + RationalFunction({1}, {2, 2, 1});
  CHECK(arctangents(two) == std::vector{of(1, {0, 1}), of(1, {1, 1})});
}

TEST_CASE("textbook form: beyond quadratic fields there are sums over roots") {
  for (const Polynomial& d : {Polynomial{1, 1, 0, 1}, Polynomial{2, 0, 1, 0, 1},
                              Polynomial{1, 1, 0, 0, 1}, Polynomial{3, 1, 0, 0, 0, 1}}) {
    const auto [form, sums] = textbook_form(integrate({{1}, d}));
    CHECK(sums.size() == 1);
    CHECK(form.logarithms.empty());
    CHECK(form.arctangents.empty());
  }
}

TEST_CASE("textbook form: law: with its sums it has the derivative f") {
  for_samples(60, [](Random& random) {
    RationalFunction f;
    for (long k = random.integer(1, 3); k > 0; --k) {
      // A quadratic polynomial over ℚ(√D), times its conjugate; or anything.
      const Integer D(random.integer(2, 7));
      const SurdPolynomial factor{
          {random.rational(), random.rational(), 1}, {random.rational(), random.rational()}, D};
      const Polynomial d = random.chance(3) ? random.nonzero_polynomial(6) : norm(factor);
      f = f + RationalFunction(random.polynomial(3), d);
    }
    const auto [form, sums] = textbook_form(integrate(f));
    CHECK(differentiate(form) + differentiate(Antiderivative{{}, {}, sums}) == f);
    if (sums.empty()) check_values(f, form);
  });
}
