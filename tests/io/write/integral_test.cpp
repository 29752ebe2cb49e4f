#include <algorithm>

#include "io/reference.hpp"
#include "phrame/answer/integral.hpp"
#include "phrame/integrate/integrate.hpp"
#include "phrame/io/read/expression.hpp"
#include "phrame/io/write/answers.hpp"
#include "support/text.hpp"

using namespace phrame;
using test::contains;
using test::Json;

namespace {

IntegralAnswer report(const std::string& text, Form form = Form::automatic) {
  const Expression f = parse_expression(text);
  IntegralQuery query{f.value, f.variable};
  query.form = form;
  query.style = form == Form::automatic ? Style::textbook : Style::logarithms;
  query.most_poles = 24;
  return answer(query);
}

IntegralAnswer real_report(const std::string& text) {
  const Expression f = parse_expression(text);
  IntegralQuery query{f.value, f.variable};
  query.style = Style::real;
  return answer(query);
}

const ExactValue quarter_turn{0, Rational(1, 4), {}, {}};

IntegralAnswer with_value(bool principal_value = false) {
  IntegralAnswer result = report("1/(x^2+1)");
  result.definite = {
      Rational(0), Rational(1), principal_value, {"0.785398", "1.7e-7"}, quarter_turn};
  result.digits = 6;
  return result;
}

}  // namespace

TEST_CASE("integral report: the text shows f in factors, its integral and what was checked") {
  CHECK(to_text(report("(x^3+x)/(x^4-x^2)")) ==
        "  f  = (x² + 1)/(x(x − 1)(x + 1))\n"
        "  ∫f = −log|x|\n"
        "      + log|x² − 1|\n"
        "      + constant\n"
        "  Checked: the derivative of this ∫f is f, exactly.\n"
        "  Form: logarithms of polynomials over ℚ, since every residue is rational.\n");
  IntegralAnswer silent = report("x");
  silent.other = {};
  CHECK(to_text(silent, false) == "  f  = x\n  ∫f = (1/2)x²\n      + constant\n");
}

TEST_CASE("integral report: the text says why the logarithms have their form") {
  const auto reason = [](const std::string& f) {
    const std::string text = to_text(report(f));
    const auto at = text.find("  Form: ");
    REQUIRE(at != std::string::npos);
    return text.substr(at + 8, text.find('\n', at) - at - 8);
  };
  CHECK(reason("1/x^2") == "no logarithms, since every residue is 0.");
  CHECK(reason("1/(x^4+x+1)") == "a sum over poles, since the residues are distinct.");
  CHECK(reason("1/(x^2+1)") == "real functions, since residues or poles lie in quadratic fields.");
  CHECK(reason("1/(x^4+1)") == "real functions, since residues or poles lie in quadratic fields.");
  CHECK(reason("1/(x^2-2)") == "real logarithms, since residues or poles lie in quadratic fields.");
  CHECK(reason("1/(x^12+1)") ==
        "real functions, since residues or poles lie in quadratic or biquadratic fields.");
  CHECK(reason("1/(x^8-40*x^6+352*x^4-960*x^2+576)") ==
        "real logarithms, since residues or poles lie in quadratic or biquadratic fields.");
  // d/dx log(x³ − x − 2α) over α³ = 2: three poles to each residue α.
  CHECK(reason("24*(3*x^2-1)/((x^3-x)^3-16)") == "a sum over residues, since residues repeat.");
  CHECK(
      reason("1/(x^2+1)+1/(x^5+x+3)") ==
      "real functions as far as quadratic fields reach; else a sum over poles, since the residues "
      "are distinct.");
  CHECK(contains(reason("24*(3*x^2-1)/((x^3-x)^3-16)+1/(x^3+x+1)"),
                 "over residues where they repeat"));
}

TEST_CASE("integral report: a value is shown exactly, where it is known, and as a decimal") {
  const std::string text = to_text(with_value());
  CHECK(contains(text,
                 "\n  ∫ f dx from 0 to 1\n"
                 "    = π/4\n"
                 "    ≈ 0.785398\n"
                 "    correctly rounded to 6 digits\n"));
  CHECK(contains(to_text(with_value(true)), "\n  principal value of ∫ f dx from 0 to 1\n"));
  IntegralAnswer rational = report("x");
  rational.definite = {Rational(0),
                       Infinity::positive,
                       false,
                       {"0.50000", "0"},
                       ExactValue{Rational(1, 2), 0, {}, {}}};
  rational.digits = 5;
  CHECK(contains(to_text(rational), "from 0 to ∞\n    = 1/2\n    = 0.50000\n"));
}

TEST_CASE("integral report: many digits are wrapped") {
  IntegralAnswer long_value = with_value();
  long_value.definite->value.value = "0." + std::string(250, '7');
  const std::string text = to_text(long_value);
  CHECK(contains(text, "≈ 0." + std::string(98, '7') + "\n      " + std::string(100, '7') +
                           "\n      " + std::string(52, '7') + "\n"));
}

TEST_CASE("integral report: a real form replaces the logarithms and the table of poles") {
  const std::string text = to_text(real_report("(x+1)/(x^2-2)"));
  CHECK(contains(text, "√2"));
  CHECK(contains(text, "log|"));
  CHECK_FALSE(contains(text, "pole"));
}

TEST_CASE("integral report: JSON has exactly the fields of integral/1") {
  const Json plain = Json::parse(to_json(report("1/(y^2+1)")));
  CHECK(plain["phrame"] == "integral/1");
  CHECK(plain["variable"] == "y");
  CHECK(plain["integrand"] == Json{{"numerator", {"1"}}, {"denominator", {"1", "0", "1"}}});
  for (const char* key : {"polynomial", "rational", "logs", "form", "checked"})
    CHECK(plain["antiderivative"].contains(key));
  CHECK_FALSE(plain.contains("real"));
  CHECK_FALSE(plain.contains("definite"));
  const Json definite = Json::parse(to_json(with_value()))["definite"];
  CHECK(definite == Json{{"from", "0"},
                         {"to", "1"},
                         {"principal_value", false},
                         {"value", "0.785398"},
                         {"radius", "1.7e-7"},
                         {"exact", "1/4*pi"}});
}

TEST_CASE("integral report: JSON has the real form, a + b√d in three fields") {
  const Json real = Json::parse(to_json(real_report("(x+1)/(x^2-2)+1/(x^2+1)")))["real"];
  for (const char* key :
       {"polynomial", "rational", "logarithms", "arctangents", "others", "checked"})
    CHECK(real.contains(key));
  REQUIRE(real["logarithms"].size() == 2);
  CHECK(real["logarithms"][0]["factor"]["d"] == "2");
  CHECK(real["logarithms"][0]["positive"] == false);
  REQUIRE(real["arctangents"].size() == 1);
  CHECK(real["arctangents"][0]["factor"] == Json{{"a", "1"}, {"b", "0"}, {"d", "1"}});
  CHECK(real["arctangents"][0]["of"]["a"] == Json{"0", "1"});
}

// The first logarithm of Φ₂₄: √6/24·log(x² + (√6 + √2)/2·x + 1), with a factor in a quadratic
// field.
TEST_CASE("integral report: JSON lists the roots where a number has several") {
  const Json real = Json::parse(to_json(real_report("1/(x^8-x^4+1)")))["real"];
  CHECK(real["others"].empty());
  REQUIRE(real["logarithms"].size() == 4);
  const Json& first = real["logarithms"][0];
  CHECK(first["factor"] == Json{{"a", "0"}, {"b", "1/24"}, {"d", "6"}});
  CHECK(first["of"] ==
        Json{{"a", {"1", "0", "1"}},
             {"roots", {{{"b", {"0", "1/2"}}, {"d", "2"}}, {{"b", {"0", "1/2"}}, {"d", "6"}}}}});
  REQUIRE(real["arctangents"].size() == 4);
  CHECK(real["arctangents"][0]["radicand"] == Json{{"a", "1/2"}, {"b", "-1/4"}, {"d", "3"}});
}

TEST_CASE("integral report: JSON has ends that are infinite or algebraic") {
  IntegralAnswer some = with_value();
  some.definite->from = Infinity::negative;
  some.definite->to = real_root({-2, 0, 1}, closed_interval(1, 2));
  some.definite->exact.reset();
  const Json definite = Json::parse(to_json(some))["definite"];
  CHECK(definite["from"] == "-inf");
  CHECK(definite["to"]["polynomial"] == Json{"-2", "0", "1"});
  CHECK(definite["to"]["value"] == "1.4142135623730950");
  CHECK_FALSE(definite.contains("exact"));
  CHECK(contains(to_text(some), "from −∞ to √2\n"));
}

TEST_CASE("integral report: an irrational multiple of π, in radicals or as a root") {
  const auto with_multiple = [](const RealAlgebraic& x) {
    IntegralAnswer some = with_value();
    some.definite->exact = ExactValue{0, 0, {}, {}, x};
    return some;
  };
  const auto shown_as = [&](const RealAlgebraic& x, std::string_view text, std::string_view plain) {
    CHECK(contains(to_text(with_multiple(x)), text));
    const Json definite = Json::parse(to_json(with_multiple(x)))["definite"];
    CHECK(definite["exact"] == plain);
    CHECK(definite["multiple_of_pi"]["polynomial"].size() ==
          static_cast<std::size_t>(x.polynomial().degree() + 1));
  };
  // √2/4, −√2/4, (1 + √5)/4, ∛2 and the three real roots of a cubic, which radicals need i for.
  const Interval positive{Rational(0), std::nullopt};
  const Interval negative{std::nullopt, Rational(0)};
  shown_as(real_root({-1, 0, 8}, positive), "    = √2/4·π\n", "sqrt(2)/4*pi");
  shown_as(real_root({-1, 0, 8}, negative), "    = −√2/4·π\n", "-sqrt(2)/4*pi");
  shown_as(real_root({-1, -2, 4}, positive), "    = (1 + √5)/4·π\n", "(1 + sqrt(5))/4*pi");
  shown_as(real_root({-2, 0, 0, 1}, positive), "    = ∛2·π\n", "2^(1/3)*pi");
  const RealAlgebraic casus = real_root({1, -3, 0, 1}, closed_interval(0, 1));
  shown_as(casus, "    = π·(the root of x³ − 3x + 1 in (0, 1))\n", "root(x^3 - 3*x + 1, 0, 1)*pi");
  CHECK(contains(to_latex(with_multiple(real_root({-1, 0, 8}, positive))),
                 "\\frac{\\sqrt{2}}{4} \\pi"));
}

TEST_CASE("integral report: LaTeX has balanced braces, the integral and the value") {
  const std::string text = to_latex(with_value());
  CHECK(text.starts_with("\\begin{align*}\n\\int \\frac{1}{x^{2} + 1} \\,dx &= "));
  CHECK(contains(text,
                 " \\\\\n\\int_{0}^{1} \\frac{1}{x^{2} + 1} \\,dx &= "
                 "\\frac{\\pi }{4} \\approx 0.785398\n\\end{align*}\n"));
  CHECK(std::count(text.begin(), text.end(), '{') == std::count(text.begin(), text.end(), '}'));
  CHECK(contains(to_latex(with_value(true)), "\\operatorname{p.v.} \\int_{0}^{1}"));
}
