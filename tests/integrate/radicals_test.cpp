#include "phrame/integrate/radicals.hpp"

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/factor.hpp"
#include "phrame/algebra/roots.hpp"
#include "phrame/integrate/evaluator.hpp"
#include "phrame/integrate/integrate.hpp"
#include "phrame/io/read/expression.hpp"
#include "support/data.hpp"
#include "support/random.hpp"

namespace radicals_test {

using namespace phrame;
using test::for_samples;
using test::Random;

namespace {

constexpr long bits = 200;

bool is_over_poles(const RadicalForm& F) {
  return std::all_of(F.logs.begin(), F.logs.end(), [](const RadicalSum& sum) {
    return is_over_poles(sum.sum) || sum.sum.index.degree() == 1;
  });
}

/// Σ residue · (log|v(x, b)| − log|v(x, a)|) for real roots x, without bars for the others.
ComplexBall log_difference(const RadicalForm& F, const Rational& a, const Rational& b) {
  ComplexBall value;
  for (const RadicalSum& sum : F.logs) {
    for (std::size_t k = 0; k < sum.roots.size(); ++k) {
      for (const auto& [t, sign] : {std::pair(b, 1), std::pair(a, -1)}) {
        ComplexBall v = enclose(evaluate(evaluate_at(sum.sum.argument, t), sum.roots[k]), bits);
        if (k < sum.real_roots) v = ComplexBall(v.re(), RealBall());
        acb_log(v.raw(), v.raw(), bits);
        if (k < sum.real_roots) v = ComplexBall(v.re(), RealBall());
        acb_mul(v.raw(), v.raw(), enclose(sum.residues[k], bits).raw(), bits);
        acb_mul_si(v.raw(), v.raw(), sign, bits);
        acb_add(value.raw(), value.raw(), v.raw(), bits);
      }
    }
  }
  return value;
}

/// The radicals are the roots of irreducible polynomials, the residues those of F′ there; the form
/// has the derivative of F and, where all logarithms are continuous, its values.
void check_form(const RadicalForm& form, const Antiderivative& F) {
  CHECK(differentiate(antiderivative(form)) == differentiate(F));
  for (const RadicalSum& sum : form.logs) {
    const Polynomial& q = sum.sum.index;
    CHECK(q.degree() <= 4);
    CHECK(factor(q).factors == std::vector<Factor>{{primitive_part(q), 1}});
    const Roots certified = isolate_roots(q, bits);
    REQUIRE(static_cast<long>(sum.roots.size()) == q.degree());
    REQUIRE(sum.real_roots == certified.real.size());
    REQUIRE(sum.residues.size() == sum.roots.size());
    for (std::size_t k = 0; k < sum.roots.size(); ++k) {
      const std::size_t above = k - certified.real.size();
      const ComplexBall z = k < certified.real.size() ? ComplexBall(certified.real[k], RealBall())
                            : above < certified.upper.size()
                                ? certified.upper[above]
                                : conjugate(certified.upper[above - certified.upper.size()]);
      CHECK(enclose(sum.roots[k], bits).overlaps(z));
      CHECK(enclose(sum.residues[k], bits).overlaps(evaluate(sum.sum.residue, z, bits)));
    }
  }
  if (!is_over_poles(form)) return;
  const Rational a(17, 101);
  const Rational b(29, 103);
  RealBall expected;
  try {
    expected = Evaluator(Antiderivative{{}, {}, F.logs}).difference(a, b, bits);
  } catch (const DomainError&) {  // a pole in between
    return;
  }
  const ComplexBall value = log_difference(form, a, b);
  CHECK(value.re().overlaps(expected));
  CHECK(value.im().contains_zero());
  CHECK(value.re().radius() < Rational(1, Integer(1) << 80U));
}

RadicalForm checked_form(const RationalFunction& f) {
  const Antiderivative F = integrate(f);
  RadicalForm form = radical_form(F);
  check_form(form, F);
  return form;
}

}  // namespace

TEST_CASE("radicals: quadratic denominators have exact surds as poles and residues") {
  const RadicalForm form = checked_form({{3, 1}, {1, 1, 1}});  // (t + 3)/(t² + t + 1)
  REQUIRE(form.logs.size() == 1);
  const Radical i_root_3 = Radical::imaginary_unit() * sqrt(Radical(3));
  CHECK(form.logs[0].real_roots == 0);
  CHECK(form.logs[0].roots[0] == Rational(-1, 2) + i_root_3 / 2);
  CHECK(form.logs[0].residues[0] == Rational(1, 2) - 5 * i_root_3 / 6);
  const RadicalForm real = checked_form({{1}, {-2, 0, 1}});
  CHECK(real.logs.at(0).real_roots == 2);
  CHECK(real.logs[0].residues[1] == sqrt(Radical(2)) / 4);
}

TEST_CASE("radicals: a rational residue is one logarithm, whatever the degree") {
  const RadicalForm form = checked_form({{-1, 0, 0, 0, 5}, {-1, -1, 0, 0, 0, 1}});
  REQUIRE(form.logs.size() == 1);
  CHECK(form.logs[0].residues == std::vector<Radical>{Radical(1)});
  CHECK(checked_form({{0, 2}, {1, 0, 1}}).logs[0].roots.size() == 1);
  // 2t/(t² + 1) + 3t²/(t³ + 2): the residues are equal.
  const RadicalForm joined = checked_form({{0, 4, 3, 0, 5}, {2, 0, 2, 1, 0, 1}});
  REQUIRE(joined.logs.size() == 1);
  CHECK(joined.logs[0].sum.argument.degree() == 5);
}

TEST_CASE("radicals: cubic and quartic denominators, alone and together with a rational part") {
  CHECK(checked_form({{1}, {-2, 0, 0, 1}}).logs.at(0).roots.size() == 3);
  CHECK(checked_form({{1}, {1, 1, 0, 1}}).logs.at(0).real_roots == 1);
  CHECK(checked_form({{1}, {1, -3, 0, 1}}).logs.at(0).real_roots == 3);
  CHECK(checked_form({{1, 0, 1}, {1, 0, 0, 0, 1}}).logs.at(0).roots.size() == 4);
  CHECK(checked_form({{1}, {1, 1, 0, 0, 1}}).logs.at(0).roots.size() == 4);
  const RadicalForm all =
      checked_form({{1, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 3},
                    pow(Polynomial{1, 0, 1}, 2) * Polynomial{1, 1, 0, 1} * Polynomial{5, 1}});
  CHECK_FALSE(all.polynomial.is_zero());
  CHECK_FALSE(all.rational.is_zero());
  CHECK(all.logs.size() == 3);
  CHECK(checked_form({}).logs.empty());
}

TEST_CASE("radicals: Farouki's quintic of 2003, θ′ = −2h/σ") {
  const RadicalForm form = checked_form({{0, 8, -8}, {6, -12, 46, -72, 37}});
  REQUIRE(form.logs.size() == 1);
  const ComplexBall c = enclose(form.logs[0].residues[0], 64);
  CHECK(to_string(c.re(), 10) == "0.09609953951");
  CHECK(to_string(c.im(), 10) == "0.03018521416");
}

TEST_CASE(
    "radicals: a denominator of degree > 4 with residues of degree ≤ 4 is written over these") {
  const RadicalForm form = checked_form({{6, 0, -3, 0, 1}, {4, 0, 5, 0, -5, 0, 1}});
  REQUIRE(form.logs.size() == 1);
  CHECK(form.logs[0].sum.index == Polynomial{1, 0, 4});
  CHECK_FALSE(is_over_poles(form.logs[0].sum));
}

TEST_CASE("radicals: poles and residues of degree 5 are refused, with the factor") {
  CHECK_THROWS_WITH_AS(radical_form(integrate({{1}, {-1, -1, 0, 0, 0, 1}})),
                       "radicals: the poles and the residues at the roots of t^5 - t - 1 have a "
                       "degree > 4",
                       DomainError);
}

TEST_CASE("radicals: law: any form of the antiderivative gives the same radicals") {
  for_samples(30, [](Random& random) {
    Polynomial d = random.nonconstant_polynomial(4);
    if (random.chance(2)) d *= random.nonconstant_polynomial(3);
    const RationalFunction f(random.polynomial(6), random.chance(3) ? d * d : d);
    const RadicalForm form = checked_form(f);
    CHECK(radical_form(integrate(f, Form::partial_fractions)) == form);
    CHECK(radical_form(integrate(f, Form::rothstein_trager)) == form);
  });
}

TEST_CASE("radicals: corpus: every integrand whose poles or residues have a degree ≤ 4") {
  std::ifstream file(test::data("/integrals.jsonl"));
  long lines = 0;
  long solved = 0;
  long refused = 0;
  for (std::string line; std::getline(file, line);) {
    if (lines++ % test::everyday(2, 1) != 0) continue;  // every other one is enough for every day
    const auto object = nlohmann::json::parse(line);
    const std::string id = object["id"];
    CAPTURE(id);
    const RationalFunction f =
        parse_expression(std::string(object["integrand"]), std::string(object["variable"])).value;
    const Antiderivative F = integrate(f);
    long degree = 0;  // the largest that has to be solved
    const RationalFunction simple = differentiate(Antiderivative{{}, {}, F.logs});
    const Antiderivative over_residues = integrate(simple, Form::rothstein_trager);
    for (const LogSum& sum : over_residues.logs) degree = std::max(degree, sum.index.degree());
    std::optional<RadicalForm> form;
    try {
      form = radical_form(F);
    } catch (const DomainError&) {
      ++refused;
    }
    // Residues of degree ≤ 4 are always enough.
    if (degree <= 4) REQUIRE(form.has_value());
    if (!form) continue;
    ++solved;
    const auto& kinds = object["kinds"];
    CHECK(std::find(kinds.begin(), kinds.end(), "radicals") != kinds.end());
    check_form(*form, F);
  }
  CHECK(solved > test::everyday(100, 200));
  CHECK(refused > test::everyday(5, 10));
}

}  // namespace radicals_test
