#include "phrame/integrate/real_form.hpp"

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/factor.hpp"
#include "phrame/algebra/roots.hpp"
#include "phrame/integrate/evaluator.hpp"
#include "phrame/integrate/integrate.hpp"
#include "support/random.hpp"
#include "support/surds.hpp"

namespace real_form_test {

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
    if (count_real_roots(f.denominator(), closed_interval(last, t)) == 0) {
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

namespace {

Surd root(long d) { return {0, 1, d}; }

struct Terms {
  std::size_t logarithms;
  std::size_t arctangents;
  std::size_t quotients;
  friend bool operator==(const Terms&, const Terms&) = default;
};

/// The terms of the textbook form of 1/d, which has no sums; both forms are checked.
Terms terms_of(const Polynomial& d, const Polynomial& n = {1}) {
  CAPTURE(to_string(d));
  const RationalFunction f(n, d);
  const auto [form, sums] = textbook_form(integrate(f));
  CHECK(sums.empty());
  CHECK(differentiate(form) == f);
  check_values(f, form);
  const RealForm real = real_form(integrate(f));
  CHECK(real.others.empty());
  CHECK(real.logarithms == form.logarithms);
  return {form.logarithms.size(), form.arctangents.size(), form.quotients.size()};
}

}  // namespace

// x⁸ − x⁴ + 1 = Φ₂₄ is ∏ (x² + px + 1), p = −2·cos(kπ/12) for k = 1, 5, 7, 11, and
// 2·cos(π/12) = (√6 + √2)/2 [the general rule for 1/(1 + x²ⁿ): Gradshteyn, Ryzhik 2.146].
TEST_CASE("textbook form: 1/(x⁸ − x⁴ + 1) over ℚ(√2, √3)") {
  const RationalFunction f({1}, {1, 0, 0, 0, -1, 0, 0, 0, 1});
  const auto [form, sums] = textbook_form(integrate(f));
  CHECK(sums.empty());
  const Surd greater = Rational(1, 2) * (root(6) + root(2));
  const Surd less = Rational(1, 2) * (root(6) - root(2));
  const Surd factor = Rational(1, 24) * root(6);
  const auto denominator = [](const Surd& p) { return surd_polynomial({Surd(1), p, Surd(1)}); };
  CHECK(form.logarithms == std::vector<RealForm::Logarithm>{{factor, denominator(greater), true},
                                                            {-factor, denominator(-greater), true},
                                                            {factor, denominator(less), true},
                                                            {-factor, denominator(-less), true}});
  // √h = less/2, (x + greater/2)/√h = 2·greater·x + greater².
  REQUIRE(form.arctangents.size() == 4);
  const RealForm::Arctangent& first = form.arctangents.front();
  CHECK(first.radicand == Rational(1, 4) * less * less);
  CHECK(Rational(1, 2) * less * coefficient(first.of, 1) == Rational(2) * greater);
  CHECK(Rational(1, 2) * less * coefficient(first.of, 0) == greater * greater);
  CHECK(Rational(1, 2) * less * first.factor == Rational(1, 12) * root(6));
  CHECK(differentiate(form) == f);
  check_values(f, form);
}

// Minimal polynomials by SymPy (minimal_polynomial), those with a parameter by shifting it.
TEST_CASE("textbook form: eight poles over real biquadratic fields") {
  const Polynomial two_three_i{144, 0, 192, 0, 88, 0, -16, 0, 1};  // of √2 + √3 + i
  const Polynomial two_three_five{576, 0, -960, 0, 352, 0, -40, 0, 1};
  CHECK(terms_of(two_three_i) == Terms{4, 4, 0});
  CHECK(terms_of(two_three_five) == Terms{4, 0, 4});
  // θ′ of the curve with the preimage (t⁴ − 8t² − 12, 4t², 4t², 4t²).
  CHECK(terms_of(two_three_i, {0, 192, 0, 0, 0, 16}) == Terms{0, 4, 0});
  const Polynomial shifted = compose(two_three_i, {Rational(-1, 3), Rational(5, 2)});
  for (const Polynomial& n : {Polynomial{1}, Polynomial{0, 1}, Polynomial{1, 0, Rational(-2, 7)},
                              Polynomial{3, -1, 0, 0, 5, 0, 0, 1}}) {
    terms_of(two_three_i, n);
    terms_of(two_three_five, n);
    terms_of(shifted, n);
  }
  // x² − (5 + √2 + √3), whose p is 0, with roots of roots; x² + x/2 + 5 + √2 − √7: p is rational;
  // x² + √2·x + 4 + √3: p lies in a quadratic field.
  const auto of = [](const Surd& p, const Surd& q) {
    return norm(surd_polynomial({q, p, Surd(1)}));
  };
  CHECK(terms_of(of(Surd(0), -Surd(5) - root(2) - root(3))) == Terms{0, 0, 4});
  CHECK(terms_of(of(Surd(Rational(1, 2)), Surd(5) + root(2) - root(7))) == Terms{0, 4, 0});
  CHECK(terms_of(of(root(2), Surd(4) + root(3))) == Terms{4, 4, 0});
  // Two of four factors with real zeros: h has other signs than its conjugates.
  CHECK(terms_of(of(root(2), Surd(1) + root(3))) == Terms{4, 2, 2});
}

TEST_CASE("textbook form: a norm that is a square is a quadratic field's") {
  // x² + √2·x + √6/√3 + 3 lies in ℚ(√2)[x].
  const SurdPolynomial g = surd_polynomial({root(6) / root(3) + Surd(3), root(2), Surd(1)});
  CHECK(norm(g).degree() == 4);
  CHECK(terms_of(norm(g)) == Terms{2, 2, 0});
}

// x⁸ + 1 = Φ₁₆, Φ₁₅ and Φ₂₀ have cyclic real subfields of degree 4, with nested roots, as cos(π/8)
// is; that of x⁸ − 2 is ℚ(⁴√2), and x⁸ + 3x + 1 has
// factors of the degrees 1 and 7 modulo 37 [PARI, factormod].
TEST_CASE("textbook form: eight poles over other fields stay a sum") {
  for (const Polynomial& d :
       {Polynomial{1, 0, 0, 0, 0, 0, 0, 0, 1}, Polynomial{1, -1, 0, 1, -1, 1, 0, -1, 1},
        Polynomial{1, 0, -1, 0, 1, 0, -1, 0, 1}, Polynomial{1, 3, 0, 0, 0, 0, 0, 0, 1},
        Polynomial{-2, 0, 0, 0, 0, 0, 0, 0, 1}}) {
    const auto [form, sums] = textbook_form(integrate({{1}, d}));
    CHECK(sums.size() == 1);
    CHECK(form.logarithms.empty());
    CHECK(form.arctangents.empty());
    CHECK(form.quotients.empty());
    CHECK(real_form(integrate({{1}, d})).others.size() == 1);
  }
}

TEST_CASE("textbook form: law: norms of quadratic polynomials over biquadratic fields") {
  for_samples(25, [](Random& random) {
    const long d = random.integer(2, 3);
    const long e = random.integer(5, 7);
    const auto number = [&] {
      Surd x(random.integer(-4, 4));
      for (const long root_of : {d, e, d * e})
        if (random.chance(2)) x.add(random.integer(-3, 3), root_of);
      return x;
    };
    const SurdPolynomial g = surd_polynomial({number(), number(), Surd(1)});
    const Polynomial full = norm(g);
    const bool is_biquadratic = full.degree() == 8 && factor(full).factors.size() == 1 &&
                                factor(full).factors.front().exponent == 1;
    const RationalFunction f(random.nonzero_polynomial(7), full);
    const RealForm form = real_form(integrate(f));
    CHECK(differentiate(form) == f);
    if (!is_biquadratic) return;
    CHECK(form.others.empty());
    check_values(f, form);
  });
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

}  // namespace real_form_test
