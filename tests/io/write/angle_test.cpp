#include <algorithm>

#include "phrame/answer/angle.hpp"
#include "phrame/io/write/answers.hpp"
#include "phrame/io/write/heading.hpp"
#include "phrame/io/write/text.hpp"

#include "io/reference.hpp"
#include "support/text.hpp"

using namespace phrame;
using test::contains;
using test::Json;

namespace {

struct Options {
  Reference reference = Reference::euler_rodrigues;
  Form form = Form::automatic;
  std::vector<Rational> at = {};
  long digits = 50;
  Rational start_angle = 0;
};

using Printer = std::string (*)(const AngleAnswer&);

std::string printed(Printer print, const NamedPhPath& named, const Options& options) {
  AngleQuery query;
  query.reference = options.reference;
  query.form = options.form;
  query.at = options.at;
  query.digits = options.digits;
  query.start = Angle(options.start_angle);
  query.most_poles = 24;
  return print(answer(named, query));
}

Json json(const NamedPhPath& named, const Options& options) {
  return Json::parse(printed(to_json, named, options));
}

std::vector<std::string> keys(const Json& object) {
  std::vector<std::string> names;
  for (const auto& [key, value] : object.items()) names.push_back(key);
  std::sort(names.begin(), names.end());
  return names;
}

Antiderivative antiderivative_of(const Json& F) {
  Antiderivative result{
      test::polynomial(F["polynomial"]), test::rational_function(F["rational"]), {}};
  for (const Json& sum : F["logs"]) {
    std::vector<Polynomial> argument;
    for (const Json& c : sum["argument"]) argument.push_back(test::polynomial(c));
    result.logs.push_back({test::polynomial(sum["index"]), test::polynomial(sum["residue"]),
                           Bivariate(std::move(argument))});
  }
  return result;
}

struct Complex {
  Rational re;
  Rational im;
};

Complex evaluate(const Polynomial& p, const Complex& z) {
  Complex sum{0, 0};
  for (long k = p.degree(); k >= 0; --k)
    sum = {sum.re * z.re - sum.im * z.im + p.coefficient(k), sum.re * z.im + sum.im * z.re};
  return sum;
}

bool is_small(const Complex& z, long digits) {
  return abs(z.re) < power_of_ten(-digits) && abs(z.im) < power_of_ten(-digits);
}

const Form forms[] = {Form::automatic, Form::partial_fractions, Form::rothstein_trager};
const Reference references[] = {Reference::euler_rodrigues, Reference::frenet};

}  // namespace

TEST_CASE("angle report: JSON has exactly the fields of angle/1") {
  const Json report = json(test::farouki_quintic(), {.at = {1}});
  CHECK(report["phrame"] == "angle/1");
  CHECK(report["curve"] == Json{{"name", "quintic"}, {"degree", 5}});
  CHECK(report["frame"] == "erf");
  CHECK(json(test::farouki_quintic(), {.reference = Reference::frenet})["frame"] == "frenet");
  using Keys = std::vector<std::string>;
  CHECK(keys(report) ==
        Keys{"antiderivative", "curve", "frame", "integrand", "phrame", "theta0", "values"});
  CHECK(keys(report["integrand"]) == Keys{"denominator", "numerator"});
  CHECK(keys(report["antiderivative"]) ==
        Keys{"checked", "form", "logs", "polynomial", "rational"});
  CHECK(report["antiderivative"]["checked"] == true);
  REQUIRE(report["values"].size() == 1);
  CHECK(keys(report["values"][0]) == Keys{"radius", "t", "theta"});
  for (const Json& field : report["values"][0]) CHECK(field.is_string());
}

TEST_CASE("angle report: values are listed in the order given, t in lowest terms") {
  const Json values = json(test::farouki_quintic(), {.at = {1, Rational(-2, 4), 0}})["values"];
  REQUIRE(values.size() == 3);
  CHECK(values[0]["t"] == "1");
  CHECK(values[1]["t"] == "-1/2");
  CHECK(values[2] == Json{{"t", "0"}, {"theta", "0"}, {"radius", "0"}});
}

TEST_CASE("angle report: the 2003 paper's angles in both frames, all forms, to 50 digits") {
  for (const Reference reference : references)
    for (const Form form : forms) {
      const Json& truth = test::farouki_2003()["quintic"][reference == Reference::euler_rodrigues
                                                              ? "theta_RMF_rel_ERF"
                                                              : "theta_RMF_rel_Frenet"];
      std::vector<Rational> at;
      for (const auto& [t, theta] : truth.items()) at.push_back(parse_rational(t));
      REQUIRE(at.size() == 11);
      const Json values = json(test::farouki_quintic(), {reference, form, at})["values"];
      for (const Json& value : values)  // the reference is rounded to 50 digits itself
        test::check_rounded(value["theta"], value["radius"],
                            truth[value["t"].get<std::string>()] == "0.0"
                                ? "0"
                                : truth[value["t"].get<std::string>()].get<std::string>(),
                            50, 50);
    }
}

TEST_CASE("angle report: a decimal has the digits asked for, correctly rounded") {
  const std::string truth = test::farouki_2003()["quintic"]["theta_RMF_rel_ERF"]["1"];
  for (const long digits : {1L, 2L, 3L, 7L, 17L, 40L}) {
    const Json value = json(test::farouki_quintic(), {.at = {1}, .digits = digits})["values"][0];
    test::check_rounded(value["theta"], value["radius"], truth, digits, 50);
  }
  // 0.285856…
  CHECK(json(test::farouki_quintic(), {.at = {1}, .digits = 1})["values"][0]["theta"] == "0.3");
  CHECK(json(test::farouki_quintic(), {.at = {1}, .digits = 3})["values"][0]["theta"] == "0.286");
}

// θ = −2t/(t² + 1) is rational: −4/5 at t = 1/2, −1 at t = 1, and −2/3.333… = −3/5 at t = 1/3.
TEST_CASE("angle report: exact angles have radius 0 and still all their digits") {
  const Json values = json(test::rational_angle_curve(),
                           {.at = {Rational(1, 2), 1, Rational(1, 3)}, .digits = 5})["values"];
  CHECK(values[0] == Json{{"t", "1/2"}, {"theta", "-0.80000"}, {"radius", "0"}});
  CHECK(values[1] == Json{{"t", "1"}, {"theta", "-1.0000"}, {"radius", "0"}});
  CHECK(values[2] == Json{{"t", "1/3"}, {"theta", "-0.60000"}, {"radius", "0"}});
  const Json frenet = json(test::rational_angle_curve(),
                           {.reference = Reference::frenet, .at = {Rational(1, 2), 1}})["values"];
  const Json& truth = test::farouki_2003()["rational_part_example"]["theta_RMF_rel_Frenet"];
  test::check_rounded(frenet[0]["theta"], frenet[0]["radius"], truth["0.5"], 50, 50);
  test::check_rounded(frenet[1]["theta"], frenet[1]["radius"], truth["1"], 50, 50);
}

// The Bernstein coefficients A0, A1 and the values are in the reference data.
TEST_CASE("angle report: the cubic example to 50 digits") {
  const Json& example = test::farouki_2003()["cubic_example"];
  const Json curve = {{"phrame", "curve/1"},
                      {"basis", "bernstein"},
                      {"quaternions", {example["A0"], example["A1"]}}};
  const Json values =
      json(read_curve(curve.dump()), {.at = {Rational(1, 4), Rational(1, 2), 1}})["values"];
  const char* const keys[] = {"0.25", "0.5", "1"};
  for (std::size_t k = 0; k < 3; ++k)
    test::check_rounded(values[k]["theta"], values[k]["radius"], example["theta"][keys[k]], 50, 50);
}

// Farouki 2003, (15)–(17): θ′ = −a/σ to the ERF, −a/σ − b/ρ = −triple/(σρ) to Frenet.
TEST_CASE("angle report: the integrand is that of the paper") {
  const Json& truth = test::farouki_2003()["quintic"];
  const Polynomial sigma = test::polynomial(truth["sigma"]);
  const Polynomial rho = test::polynomial(truth["rho"]);
  const Json erf = json(test::farouki_quintic(), {})["integrand"];
  CHECK(test::polynomial(erf["numerator"]) * sigma ==
        -(test::polynomial(truth["a"]) * test::polynomial(erf["denominator"])));
  const Json frenet = json(test::farouki_quintic(), {.reference = Reference::frenet})["integrand"];
  CHECK(test::polynomial(frenet["numerator"]) * sigma * rho ==
        -(test::polynomial(truth["triple"]) * test::polynomial(frenet["denominator"])));
}

TEST_CASE("angle report: the printed antiderivative differentiates to the printed integrand") {
  for (const NamedCurve& named : {test::farouki_quintic(), test::rational_angle_curve()})
    for (const Reference reference : references)
      for (const Form form : forms) {
        const Json report = json(named, {reference, form});
        CHECK(differentiate(antiderivative_of(report["antiderivative"])) ==
              test::rational_function(report["integrand"]));
      }
}

// The reference lists the poles z of a/σ and their residues c; those of −a/σ are −c.
TEST_CASE("angle report: index and residue are the paper's poles and residues") {
  const Json& truth = test::farouki_2003()["quintic"];
  const Json F = json(test::farouki_quintic(), {.form = Form::partial_fractions})["antiderivative"];
  CHECK(F["form"] == "partial-fractions");
  REQUIRE(F["logs"].size() == 1);
  for (std::size_t k = 0; k < 2; ++k) {
    const auto complex = [](const Json& z) {
      return Complex{test::rational(z["re"]), test::rational(z["im"])};
    };
    const Complex z = complex(truth["z_upper"][k]);
    const Complex c = complex(truth["c_at_z_upper"][k]);
    CHECK(is_small(evaluate(test::polynomial(F["logs"][0]["index"]), z), 45));
    const Complex residue = evaluate(test::polynomial(F["logs"][0]["residue"]), z);
    CHECK(is_small({residue.re + c.re, residue.im + c.im}, 45));
  }
}

TEST_CASE("angle report: the form is named") {
  const auto name = [](const NamedCurve& named, Form form) {
    return json(named, {.form = form})["antiderivative"]["form"];
  };
  CHECK(name(test::farouki_quintic(), Form::automatic) == "partial-fractions");
  CHECK(name(test::farouki_quintic(), Form::rothstein_trager) == "rothstein-trager");
  CHECK(name(test::rational_angle_curve(), Form::automatic) == "rational");
}

// Its logarithm is arg g, Σ x·log v over x = ±i/2, which is not over poles.
TEST_CASE("angle report: the form of a Frenet angle is that of all its logarithms") {
  const auto name = [](const NamedCurve& named, Form form) {
    return json(named, {.reference = Reference::frenet, .form = form})["antiderivative"]["form"];
  };
  CHECK(name(test::rational_angle_curve(), Form::automatic) == "rothstein-trager");
  CHECK(name(test::farouki_quintic(), Form::automatic) == "mixed");
  CHECK(name(test::farouki_quintic(), Form::rothstein_trager) == "rothstein-trager");
}

TEST_CASE("angle report: the angle at 0 is in JSON, and in LaTeX unless it is 0") {
  const auto report = [](Printer print, const Rational& start) {
    return printed(print, test::farouki_quintic(), {.start_angle = start});
  };
  CHECK(Json::parse(report(to_json, Rational(-1, 3)))["theta0"] == "-1/3");
  CHECK(Json::parse(report(to_json, 0))["theta0"] == "0");
  CHECK(contains(report(to_latex, Rational(-1, 3)),
                 " + C \\\\\n\\theta(0) &= -\\frac{1}{3}\n\\end{align*}"));
  CHECK_FALSE(contains(report(to_latex, 0), "theta(0)"));
}

// A = 1 + (t² − t)k: g = 2t − 1; with its square for f, r′ = 0 at 1/2.
TEST_CASE("angle report: inflections where n and b flip are listed to the Frenet frame only") {
  const QuaternionPolynomial a{{1}, {}, {}, {0, -1, 1}};
  const std::string line =
      "  inflection at t = 1/2: (n, b) flip there, the angle is continued through\n";
  CHECK(contains(printed(to_text, {"", Curve(a)}, {.reference = Reference::frenet}), line));
  CHECK_FALSE(contains(printed(to_text, {"", Curve(a)}, {}), "inflection"));
  CHECK_FALSE(contains(printed(to_text, test::farouki_quintic(), {.reference = Reference::frenet}),
                       "inflection"));
}

TEST_CASE("angle report: where f is negative, the text says which way the tangent points") {
  const auto text = [](const Polynomial& f) {
    return printed(to_text, {"", Curve(test::farouki_quintic().curve.preimage(), f)}, {});
  };
  CHECK_FALSE(contains(text({-1}), "f < 0"));  // it is turned over
  CHECK(contains(text({1, -3}), "  f < 0 in a part of [0, 1]: there e₁"));
  CHECK_FALSE(contains(text({1, -1}), "f < 0"));
}

TEST_CASE("angle report: the text holds the closed form, the poles and the table") {
  const std::string text =
      printed(to_text, test::farouki_quintic(), {.at = {0, Rational(1, 2), 1}, .digits = 12});
  CHECK(text.starts_with("quintic: PH quintic, degree 5 (preimage of degree 2)\n"));
  CHECK(contains(text, "σ = 37t⁴ − 72t³ + 46t² − 12t + 6\n"));
  CHECK(contains(text, "h = 4t(t − 1)\n"));
  CHECK(contains(text, "θ′ = −2h/σ = −8t(t − 1)/(37t⁴ − 72t³ + 46t² − 12t + 6)\n"));
  CHECK(contains(text, "Σ c(z)·log(t − z) over the 4 roots z of 37z⁴ − 72z³ + 46z² − 12z + 6\n"));
  CHECK(contains(text, "Checked: the derivative of this θ is θ′, exactly."));
  CHECK(contains(text, "0.960954584954 ± 0.343344423853i"));
  CHECK(contains(text, "0.0961") == false);  // digits are not cut short
  CHECK(contains(text, "  1/2   0.135162160830\n"));
  CHECK(contains(text, "  1     0.285856530098\n"));
}

TEST_CASE("angle report: the text to the Frenet frame shows g and its argument") {
  const std::string text =
      printed(to_text, test::farouki_quintic(), {.reference = Reference::frenet});
  CHECK(contains(text, "g = (4t² − 24t + 12) + (2t² + 14t − 6)i\n"));
  CHECK(contains(text, "+ arg g(t), continuous\n"));
  CHECK(contains(text, "f₂ = cos θ n + sin θ b,  f₃ = −sin θ n + cos θ b"));
}

// Residues of 8t(1 − t)/σ: the roots of 1669067x⁴ − 28952x² + 224x + 160, by the reference's
// resultant of a and σ (there for −θ′, so with −224).
TEST_CASE("angle report: the text in Rothstein–Trager's form shows the residue polynomial") {
  const std::string text =
      printed(to_text, test::farouki_quintic(), {.form = Form::rothstein_trager});
  CHECK(contains(text, "Σ x·log v(x, t) over the 4 roots x of 1669067x⁴ − 28952x² + 224x + 160\n"));
}

// A = t² − 6/5 + (8/5)i + (13/5)t j + (4/5)t k: σ = (t² + 1)(t² + 4), h = −(16/5)t.
TEST_CASE("angle report: a sum over one root is written as its only term") {
  const NamedCurve named{
      "",
      Curve(
          {{Rational(-6, 5), 0, 1}, {Rational(8, 5)}, {0, Rational(13, 5)}, {0, Rational(4, 5)}})};
  CHECK(contains(printed(to_text, named, {}),
                 "θ  = 16/15·log(t² + 1)\n      − 16/15·log(t² + 4)\n      + constant\n"));
  CHECK(contains(printed(to_latex, named, {}),
                 "= \\frac{16}{15} \\log\\left(t^{2} + 1\\right) - "
                 "\\frac{16}{15} \\log\\left(t^{2} + 4\\right) + C\n"));
}

TEST_CASE("angle report: a rational angle is written without logarithms") {
  const std::string text = printed(to_text, test::rational_angle_curve(), {});
  CHECK(contains(text, "θ  = −2t/(t² + 1)\n"));
  CHECK(contains(printed(to_latex, test::rational_angle_curve(), {}),
                 "\\theta(t) &= \\frac{-2t}{t^{2} + 1} + C\n"));
}

TEST_CASE("angle report: of a straight line, θ is 0 to the ERF") {
  const std::string text = printed(to_text, test::straight_line(), {.at = {1}});
  CHECK(contains(text, "line: line segment, degree 1 (preimage of degree 0)"));
  CHECK(contains(text, "θ  = 0\n"));
  // One that is constant is what it is at the start.
  const Options from_third{.start_angle = Rational(1, 3)};
  CHECK(contains(printed(to_text, test::straight_line(), from_third), "θ  = 1/3\n"));
  CHECK(contains(printed(to_latex, test::straight_line(), from_third), "\\theta(t) &= C \\\\\n"));
  CHECK(json(test::straight_line(), {.at = {7}})["values"][0]["theta"] == "0");
}

TEST_CASE("angle report: cusps are announced") {
  // r′ = (2t − 1)·i
  const NamedCurve cusp{
      "", Curve({Polynomial{1}, Polynomial(), Polynomial(), Polynomial()}, Polynomial{-1, 2})};
  CHECK(contains(printed(to_text, cusp, {}), "  r′ = 0 at t = 1/2: frames and angle"));
  CHECK_FALSE(contains(printed(to_text, test::farouki_quintic(), {}), "r′ = 0"));
}

TEST_CASE("angle report: LaTeX has balanced braces, the closed form and the table") {
  for (const Reference reference : references) {
    const std::string text =
        printed(to_latex, test::farouki_quintic(),
                {.reference = reference, .at = {Rational(1, 2), power_of_ten(-30)}, .digits = 5});
    CHECK(std::count(text.begin(), text.end(), '{') == std::count(text.begin(), text.end(), '}'));
    CHECK(contains(text, "\\sum_{37z^{4} - 72z^{3} + 46z^{2} - 12z + 6 = 0}"));
    CHECK(contains(text, "\\frac{602064}{1669067}z^{3}"));
    CHECK(contains(text, "$\\frac{1}{2}$ & $"));
    CHECK(contains(text, "\\arg") == (reference == Reference::frenet));
    CHECK_FALSE(contains(text, "−"));
    CHECK_FALSE(contains(text, "e-"));  // 1.5e-12 is no mathematics
  }
  // θ ≈ (2/3)·10⁻⁶⁰, as θ′ = 8t/6 + O(t²) at 0.
  const std::string erf =
      printed(to_latex, test::farouki_quintic(), {.at = {power_of_ten(-30)}, .digits = 5});
  CHECK(contains(erf, "$6.6667 \\cdot 10^{-61}$"));
}

TEST_CASE("angle report: a long t does not widen the text, JSON keeps it") {
  const Rational t = power_of_ten(500);
  const std::string text =
      abridged(printed(to_text, test::farouki_quintic(), {.at = {t}, .digits = 5}));
  CHECK(contains(text, "  10000000…00000000 (501 digits)   0.0"));
  CHECK(json(test::farouki_quintic(), {.at = {t}})["values"][0]["t"] ==
        "1" + std::string(500, '0'));
}

TEST_CASE("angle report: headings name the curve and its kind, without control characters") {
  NamedCurve named = test::straight_line();
  named.name =
      "a\x1b[31m\n\xC2\x9B"
      "b";
  CHECK(heading(named.name, named.curve) ==
        "a\\u001b[31m\\u000a\\u009bb: line segment, degree 1 (preimage of degree 0)");
  named.name = "";
  CHECK(heading(named.name, named.curve) == "line segment, degree 1 (preimage of degree 0)");
  const auto kind = [](long m) {
    const Curve curve({Polynomial::monomial(1, m), Polynomial{1}, Polynomial(), Polynomial()});
    return heading("", curve);
  };
  CHECK(kind(1) == "PH cubic, degree 3 (preimage of degree 1)");
  CHECK(kind(3) == "PH septic, degree 7 (preimage of degree 3)");
  CHECK(kind(4) == "PH curve, degree 9 (preimage of degree 4)");
}
