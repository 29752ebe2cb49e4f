#include "cli/workshop.hpp"

using namespace phrame;
using namespace phrame::test;

namespace {

Json json(const Run& run) {
  check_success(run);
  return Json::parse(run.out);
}

const std::vector<std::string> languages{"sympy", "mathematica", "maple", "maxima", "pari"};

}  // namespace

// ∫₁² (3x² + x + 1)/(x³ + x) dx = log 5 + arctan 2 − π/4.
TEST_CASE("integrate: the integral and its value") {
  const Workshop here;
  const Run run = here.run("integrate '(3*x^2+x+1)/(x^3+x)' --from 1 --to 2 --digits 30");
  check_success(run);
  CHECK(run.out.starts_with("  f  = (3x² + x + 1)/(x(x² + 1))\n  ∫f = log|x|\n"));
  CHECK(contains(run.out, "  Checked: the derivative of this ∫f is f, exactly.\n"));
  CHECK(contains(run.out, "  ∫ f dx from 1 to 2\n"));
  CHECK(contains(run.out, "≈ 1.93118846683074256800216394758\n"));
  const Json definite =
      json(here.run("integrate '2*x' --from=-1 --to 1/2 --digits 3 --print json"))["definite"];
  CHECK(definite["value"] == "-0.750");
  CHECK(definite["radius"] == "0");
}

// Gradshteyn, Ryzhik 2.132; for x⁶ + 1 the sum over its twelfth roots of unity; Rioboo 1991.
TEST_CASE("integrate: --form auto is what a book prints") {
  const Workshop here;
  const auto integral = [&](const std::string& f) {
    const Run run = here.run("integrate '" + f + "'");
    check_success(run);
    const auto begin = run.out.find("∫f = ") + std::string("∫f = ").size();
    return run.out.substr(begin, run.out.find("\n      + constant") - begin);
  };
  CHECK(integral("1/(x^2+1)") == "arctan(x)");
  CHECK(integral("1/(x^4+1)") ==
        "√2/8·log(x² + √2·x + 1)\n      − √2/8·log(x² − √2·x + 1)\n"
        "      + √2/4·arctan(√2·x + 1)\n      + √2/4·arctan(√2·x − 1)");
  CHECK(integral("1/(x^6+1)") ==
        "√3/12·log(x² + √3·x + 1)\n      − √3/12·log(x² − √3·x + 1)\n"
        "      + 1/3·arctan(x)\n      + 1/6·arctan(2x + √3)\n      + 1/6·arctan(2x − √3)");
  CHECK(integral("(x^4-3*x^2+6)/(x^6-5*x^4+5*x^2+4)") ==
        "arctan((1/2)x⁵ − (3/2)x³ + (1/2)x)\n      + arctan(x³)\n      + arctan(x)");
  // The twelfth roots of −1: 2·cos(π/12) = (√6 + √2)/2, 2·cos(5π/12) = (√6 − √2)/2 [2.146].
  CHECK(integral("12/(x^12+1)") ==
        "√2/2·log(x² + √2·x + 1)\n      − √2/2·log(x² − √2·x + 1)\n"
        "      + (√6 + √2)/4·log(x² + (√6 + √2)/2·x + 1)\n"
        "      − (√6 + √2)/4·log(x² − (√6 + √2)/2·x + 1)\n"
        "      + (√6 − √2)/4·log(x² + (√6 − √2)/2·x + 1)\n"
        "      − (√6 − √2)/4·log(x² − (√6 − √2)/2·x + 1)\n"
        "      + √2·arctan(√2·x + 1)\n      + √2·arctan(√2·x − 1)\n"
        "      + (√6 − √2)/2·arctan((√6 + √2)·x + 2 + √3)\n"
        "      + (√6 − √2)/2·arctan((√6 + √2)·x − 2 − √3)\n"
        "      + (√6 + √2)/2·arctan((√6 − √2)·x + 2 − √3)\n"
        "      + (√6 + √2)/2·arctan((√6 − √2)·x − 2 + √3)");
  // x⁴ + x³ + x² + x + 1 = (x² + φx + 1)(x² − x/φ + 1), and cos 72° = (√5 − 1)/4.
  CHECK(contains(integral("1/(x^4+x^3+x^2+x+1)"), "arctan((4x + 1 + √5)/√(10 − 2√5))"));
  CHECK(integral("1/(x^8+1)").starts_with("Σ c(z)·log(x − z) over the 8 roots z of z⁸ + 1"));
  // The forms by name are what they were.
  CHECK(contains(here.run("integrate '1/(x^2+1)' --form rothstein-trager").out,
                 "Σ y·log v(y, x) over the 2 roots y of 4y² + 1"));
  CHECK(contains(here.run("integrate '1/(x^4+1)' --form partial-fractions").out,
                 "Σ c(z)·log(x − z) over the 4 roots z of z⁴ + 1"));
}

TEST_CASE(
    "integrate, angle: what is printed for other systems is continuous, or says that it is not") {
  const Workshop here;
  const std::string rioboo = "integrate '(x^4-3*x^2+6)/(x^6-5*x^4+5*x^2+4)' ";
  CHECK(contains(here.run(rioboo + "--print sympy").out,
                 "antiderivative = atan(Rational(1, 2)*x**5 - Rational(3, 2)*x**3 + "
                 "Rational(1, 2)*x) + atan(x**3) + atan(x)\n"));
  for (const std::string& language : languages) {
    constexpr auto warning = "the logarithms may cross their cut";
    CHECK_FALSE(contains(here.run(rioboo + "--print " + language).out, warning));
    CHECK(contains(here.run(rioboo + "--form rothstein-trager --print " + language).out, warning));
    const Run frenet = here.run("angle quintic.json --frame frenet --print " + language);
    check_success(frenet);
    CHECK_FALSE(contains(frenet.out, warning));
  }
}

TEST_CASE("integrate: ends are pi, square roots and oo, too") {
  const Workshop here;
  const auto value = [&](const std::string& f, const std::string& from, const std::string& to) {
    return json(here.run("integrate '" + f + "' --from='" + from + "' --to '" + to +
                         "' --print json --digits 30"))["definite"]["value"];
  };
  CHECK(value("2*x", "0", "pi") == "9.86960440108935861883449099988");  // π²
  CHECK(value("2*x", "0", "sqrt(2)") == "2.00000000000000000000000000000");
  CHECK(value("1/x", "pi", "2*π") == "0.693147180559945309417232121458");     // log 2
  CHECK(value("1/(x^2+1)", "0", "√3") == "1.04719755119659774615421446109");  // π/3
  CHECK(value("1/(x^2+1)", "-oo", "oo") == "3.14159265358979323846264338328");
  CHECK(value("x/(x^4+1)", "-pi", "pi") == "0");
  CHECK(value("2*x", "pi/2", "pi/2") == "0");
  // arctan π, with mpmath.
  CHECK(value("1/(x^2+1)", "0", "pi") == "1.26262725567891168344432208361");
  // log(π − 3), as a principal value minus log 3: mpmath.
  check_failure(here.run("integrate '1/(x-3)' --from 0 --to pi"), 3, "pole at 3");
  CHECK(contains(here.run("integrate '1/(x-3)' --from 0 --to pi --principal-value").out,
                 "principal value of ∫ f dx from 0 to π\n    ≈ −3.0534132691645290\n"));
  CHECK(contains(here.run("integrate x --from 0 --to 'pi/4'").out, "from 0 to π/4\n"));
  check_failure(here.run("integrate x --from 0 --to 'sqrt(2)+sqrt(3)'"), 2,
                "--to, column 9: square roots of two numbers");
  check_failure(here.run("integrate x --from 0 --to 'sqrt(x)'"), 2, "--to, column 6: ");
}

TEST_CASE("integrate: the letters e, i and pi are alike, and --var makes them variables") {
  const Workshop here;
  for (const std::string letter : {"e", "i", "pi"}) {
    check_failure(here.run("integrate '1/(" + letter + "^2+1)'"), 2,
                  "EXPR, column 4: \"" + letter + "\" is not a rational number; --var " + letter +
                      " makes it the variable");
    check_failure(here.run("integrate 'x*" + letter + "' --var x"), 2,
                  "EXPR, column 3: \"" + letter + "\" is not a rational number\n");
    CHECK(json(here.run("integrate '1/(" + letter + "^2+1)' --print json --var " +
                        letter))["variable"] == letter);
  }
  check_failure(here.run("integrate 'x*y'"), 2, "write a number for one of them (--var ");
  check_failure(here.run("integrate '(x+1)(x-1)'"), 2, "a product needs its sign, (…)*(…)");
}

TEST_CASE("integrate: the expression may come from standard input, and begin with a minus sign") {
  const Workshop here;
  CHECK(here.run("integrate -", "1/(x^2+1)\n").out == here.run("integrate '1/(x^2+1)'").out);
  check_failure(here.run("integrate -", "1/(x^2+"), 2, "standard input, column 8: ");
  CHECK(here.run("integrate -- '-x/(x^2+1)'").out == here.run("integrate '(-x)/(x^2+1)'").out);
  CHECK(here.run("integrate '-x/(x^2+1)'").out == here.run("integrate '(-x)/(x^2+1)'").out);
  check_failure(here.run("integrate '-x/(x^2+'"), 2, "EXPR, column 9: ");
  CHECK(here.run("integrate -2 --from -1 --to -.5 -h").out == here.run("integrate -h").out);
  CHECK(here.run("integrate x --from -inf --to -1y").err.find("--to, column 3") !=
        std::string::npos);
  CHECK(here.run("integrate --print json -- -2").out == here.run("integrate --print json 0-2").out);
}

TEST_CASE("integrate: the variable is the one that occurs, the one given, or x") {
  const Workshop here;
  CHECK(json(here.run("integrate '1/(theta+1)' --print json"))["variable"] == "theta");
  CHECK(json(here.run("integrate 3 --print json"))["variable"] == "x");
  CHECK(json(here.run("integrate 3 --var s --print json"))["variable"] == "s");
  check_failure(here.run("integrate x*y"), 2, "EXPR, column 3: a second variable, \"y\"");
  check_failure(here.run("integrate x --var y"), 2, "EXPR, column 1: ");
}

TEST_CASE("integrate: what is typed wrongly is refused by name") {
  const Workshop here;
  check_failure(here.run("integrate"), 2, "EXPR is required");
  check_failure(here.run("integrate 2x"), 2, "EXPR, column 2: ");
  check_failure(here.run("integrate 1/0"), 2, "EXPR, column 3: division by zero");
  check_failure(here.run("integrate x --from 1"), 2, "--from and --to go together");
  check_failure(here.run("integrate x --to 1"), 2, "--from and --to go together");
  check_failure(here.run("integrate x --from 1 --to 2y"), 2, "--to, column 2: ");
  check_failure(here.run("integrate x --from 'root(x^2-2,3,4)' --to 2"), 2,
                "--from, column 1: x² − 2 has no real roots");
  check_failure(here.run("integrate x --principal-value"), 2,
                "--principal-value: needs --from and --to");
  check_failure(here.run("integrate x --form best"), 2, "--form: \"best\" is not one of auto,");
  check_failure(here.run("integrate x --print npy"), 2, "--print: \"npy\" is not one of text,");
  check_failure(here.run("integrate x --digits 0"), 2, "--digits");
  check_failure(here.run("integrate '1/(x^9+1)' --max-degree 8"), 2, "EXPR, column ");
}

TEST_CASE("integrate: a pole on the path has status 3") {
  const Workshop here;
  check_failure(here.run("integrate 1/x --from=-1 --to 1"), 3, "pole");
}

TEST_CASE("integrate: every form has the same value, and is checked") {
  const Workshop here;
  const std::string common =
      "integrate '(x^3+1)/((x^2-2)*(x^2+1)^2)' --from 2 --to 3 --print json --form ";
  const Json first = json(here.run(common + "auto"));
  for (const std::string form : {"partial-fractions", "rothstein-trager", "real"}) {
    const Json other = json(here.run(common + form));
    CHECK(other["definite"] == first["definite"]);
    CHECK(other["antiderivative"]["checked"] == true);
    CHECK(other.contains("real") == (form == "real"));
  }
}

TEST_CASE("integrate: --no-derivative-check leaves the line out") {
  const Workshop here;
  const std::string text = here.run("integrate 1/x --no-derivative-check").out;
  CHECK_FALSE(contains(text, "Checked"));
  CHECK(contains(here.run("integrate 1/x --derivative-check").out, "Checked"));
}

TEST_CASE("integrate: -o writes what standard output would get") {
  const Workshop here;
  CHECK(here.run("integrate 1/x -o out").status == 0);
  CHECK(bytes_of(here.file("out")) == here.run("integrate 1/x").out);
}

TEST_CASE("integrate, angle: every language of --print is written in one statement a line") {
  const Workshop here;
  for (const std::string& language : languages) {
    CAPTURE(language);
    const Run integral = here.run("integrate '1/(x^4+1)' --from 0 --to 1 --print " + language);
    check_success(integral);
    for (const char* name : {"integrand", "antiderivative", "definite"})
      CHECK(contains("\n" + integral.out, "\n" + std::string(name)));
    for (const std::string frame : {"erf", "frenet"}) {
      const Run angle = here.run("angle quintic.json --print " + language + " --frame " + frame);
      check_success(angle);
      CHECK(contains("\n" + angle.out, "\nantiderivative"));
      CHECK_FALSE(contains(angle.out, "arg"));
    }
    check_failure(here.run("angle quintic.json --at 1 --print " + language), 2,
                  "--at: does not apply with --print " + language);
  }
}

TEST_CASE("angle: the real form of a Frenet angle has arctangents for arg g") {
  const Workshop here;
  const Run run = here.run("angle quintic.json --frame frenet --form real --at 1");
  check_success(run);
  CHECK(contains(run.out, "θ  = arctan("));
  CHECK_FALSE(contains(run.out, "arg g"));
  const Json report = json(here.run("angle quintic.json --frame frenet --form real --print json"));
  CHECK(report["real"]["arctangents"].size() == 2);
}

TEST_CASE("integrate: radicals, in text, JSON and scripts; what is not solvable so is refused") {
  const Workshop here;
  const Run text = here.run("integrate '1/(x^3-2)' --form radicals");
  check_success(text);
  CHECK(contains(text.out, "z₁ = ∛2   (real, with log|·|)"));
  const Json sum =
      json(here.run("integrate '1/(x^2-2)' --form radicals --print json"))["radicals"]["logs"][0];
  CHECK(sum["roots"] == Json{"-sqrt(2)", "sqrt(2)"});
  CHECK(sum["real_roots"] == 2);
  CHECK(sum["index"] == Json{"-2", "0", "1"});
  CHECK(sum["argument"] == Json{{"0", "-1"}, {"1"}});
  const Run latex = here.run("integrate '1/(x^3-2)' --form radicals --print latex");
  CHECK(contains(latex.out, "\\right) + C,\\quad z_{11} = \\sqrt[3]{2},"));
  check_failure(here.run("integrate '1/(i^2-2)' --var i --form radicals"), 2, "--form radicals");
  for (const std::string& language : languages)
    check_success(here.run("integrate 'x+1/(x^3-2)' --form radicals --print " + language));
  check_failure(here.run("integrate '1/(x^5+x+3)' --form radicals"), 3, "t^5 + t + 3");
}

TEST_CASE("integrate: errors name the option that is wrong") {
  const Workshop here;
  for (const std::string name : {"1x", "''", "x-y"})
    check_failure(here.run("integrate 1/x --var " + name), 2, "--var: ");
  check_failure(here.run("integrate x --from 0 --to 'root(x^2-2, 2, 1)'"), 2,
                "the first end of the interval is greater");
  check_failure(here.run("integrate 1/x --from 1e-30000 --to=-1"), 3, "pole at 0");
}

TEST_CASE("integrate: scripts are read as they are meant") {
  const Workshop here;
  // log|x| is differentiated by SymPy only for a real x; Maxima reads as many digits as it is told.
  CHECK(contains(here.run("integrate '5/(x^2-5*x+4)' --form real --print sympy").out,
                 "x = symbols('x', real=True)"));
  CHECK(here.run("integrate '1/(x^3+x+1)' --from 0 --to 1 --digits 40 --print maxima")
            .out.starts_with("fpprec: 40$\n"));
  CHECK(here.run("integrate '1/(x^3+x+1)' --from 0 --to 1 --digits 40 --print pari")
            .out.starts_with("\\\\ default(realprecision, 40) shows all digits of definite"));
  CHECK(here.run("integrate '1/(x^3+x+1)' --from 0 --to 1 --print pari")
            .out.starts_with("integrand"));
  CHECK(contains(here.run("integrate 'x-1/x^2' --print maple").out, "(x^3 - 1)/(x^2)"));
  CHECK(
      contains(here.run("integrate '1+1/x^2' --print maple").out, "antiderivative := x - 1/(x):"));
  // What is lost in an argument with numbers of 20 digits counts relative to the leading
  // coefficient: the 38 digits of PARI are enough.
  const std::string sextic = "integrate '1/(97*x^6-83*x^2+71*x-53)' --form rothstein-trager";
  CHECK(here.run(sextic + " --print pari").out.starts_with("integrand"));
  // In LaTeX a rounded value is not said to be equal.
  CHECK(contains(here.run("integrate '1/(x^3+x+1)' --from 0 --to 1 --print latex").out,
                 "\\approx 0."));
  CHECK(
      contains(here.run("integrate x --from 0 --to 1 --print latex").out, "= \\frac{1}{2} = 0.5"));
}

TEST_CASE("integrate: Python reads integers of more than 4300 digits in hexadecimal") {
  const Workshop here;
  // 2^14284 has 4300 digits, 2^14285 one more.
  const std::string power = "0x2" + std::string(3571, '0');
  CHECK(here.run("integrate '1/(x+2^14285)' --print sympy").out ==
        "from sympy import *\nx, z = symbols('x z')\nintegrand = 1/(x + " + power +
            ")\nantiderivative = log(x + " + power + ")\n");
  CHECK(!contains(here.run("integrate '1/(x+2^14284)' --print sympy").out, "0x"));
  CHECK(!contains(here.run("integrate '1/(x+2^14285)' --print pari").out, "0x"));
}

TEST_CASE("integrate: a value may be as small as the input is") {
  const Workshop here;
  const Run run = here.run("integrate '1e-100000*1e-50000' --from 0 --to 1 --digits 5");
  check_success(run);
  CHECK(contains(run.out, "= 1.0000e-150000"));
  check_success(here.run("integrate 1/x --from 1 --to 1e-30000"));
}
