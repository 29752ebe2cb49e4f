
#include "phrame/answer/identification.hpp"
#include "io/reference.hpp"
#include "phrame/io/write/answers.hpp"
#include "phrame/io/write/curve_file.hpp"
#include "phrame/ph/curve/invariants.hpp"
#include "support/text.hpp"

using namespace phrame;
using test::contains;
using test::Json;

namespace {

IdentificationAnswer report(const std::string& name, const Vector<Polynomial>& r1) {
  return {name, identify(r1, {1, 0, Rational(1, 2)})};
}

/// 3r′ = B i B* with B = (3t − t³) − 3t² i + 3k [Beltran, Monterde 2007].
const Vector<Polynomial> septic{Polynomial{-3, 0, 3, 0, 1, 0, Rational(1, 3)},
                                Polynomial{0, 6, 0, -2}, Polynomial{0, 0, -6}};

}  // namespace

TEST_CASE("identify report: the JSON of a PH curve") {
  const Json json = Json::parse(to_json(report("septic", septic)));
  CHECK(json["phrame"] == "identify/1");
  CHECK(json["name"] == "septic");
  CHECK(json["ph"] == true);
  CHECK(json["degree"] == 7);
  CHECK(json["multiplier"] == Json{"3"});
  CHECK(json["preimage"]["u"] == Json{"0", "1", "0", "-1/3"});
  CHECK(json["preimage"]["v"] == Json{"0", "0", "-1"});
  CHECK(json["preimage"]["p"] == Json::array());
  CHECK(json["preimage"]["q"] == Json{"1"});
  CHECK(json["start"] == Json{"1", "0", "1/2"});
  CHECK(json["speed"] == Json{"3", "0", "3", "0", "1", "0", "1/3"});
}

TEST_CASE("identify report: the JSON of other curves has the reason") {
  const Json parabola = Json::parse(to_json(report("", {Polynomial{1}, Polynomial{0, 2}, {}})));
  CHECK(parabola["ph"] == false);
  CHECK(parabola["odd_factor"] == Json{"1", "0", "4"});
  CHECK(parabola["radicand"] == "1");
  CHECK(contains(parabola["reason"].get<std::string>(), "4*t^2 + 1 to an odd power"));
  CHECK_FALSE(parabola.contains("preimage"));
  const Json diagonal = Json::parse(to_json(report("", {Polynomial{1}, Polynomial{1}, {}})));
  CHECK(diagonal["odd_factor"] == Json{"1"});
  CHECK(diagonal["radicand"] == "2");
}

TEST_CASE("identify report: the text says what f and A are, or why there are none") {
  const std::string text = to_text(report("septic", septic));
  CHECK(text.starts_with("septic: PH septic, degree 7 (preimage of degree 3)\n"));
  CHECK(contains(text,
                 "\n  f      3\n  u      −(1/3)t³ + t\n  v      −t²\n  p      0\n  q      1\n"));
  CHECK(contains(text, "\n  f|A|²  (1/3)(t⁶ + 3t⁴ + 9t² + 9)\n"));
  CHECK(to_text(report("a\nb", {Polynomial{1}, Polynomial{0, 2}, {}})) ==
        "a\\u000ab: not a PH curve over ℚ\n\n"
        "  |r′| is no polynomial: |r′|² has these factors to an odd power:\n    4t² + 1\n");
  CHECK(contains(to_text(report("", {Polynomial{1}, Polynomial{1}, {}})),
                 "|r′| is √2 times a polynomial: the curve is PH over ℝ"));
}

// Degrees up to 81, coefficients up to 100 digits, repeated and common factors, lines.
TEST_CASE("identify report: every curve of the corpus is identified from r′ alone") {
  std::istringstream lines(test::read_data("curves.jsonl"));
  long count = 0;
  for (std::string line; std::getline(lines, line); ++count) {
    const NamedHodograph named = read_hodograph(line);
    CAPTURE(named.name);
    const auto result = identify(named.hodograph, named.start);
    REQUIRE(std::holds_alternative<Curve>(result));
    const Curve& found = std::get<Curve>(result);
    const Curve given = read_curve(line).curve;
    CHECK(hodograph(found) == hodograph(given));
    CHECK(preimage_degree(found) <= preimage_degree(given));
    // The speed is that of the curve, up to the sign of f.
    const Polynomial speed = found.multiplier() * sigma(found.preimage());
    const Polynomial expected = given.multiplier() * sigma(given.preimage());
    CHECK((speed == expected || speed == -expected));
    CHECK(read_curve(write_curve({named.name, found})).curve == found);
  }
  CHECK(count == 132);
}

TEST_CASE("identify report: LaTeX has f and A, or why there are none") {
  CHECK(to_latex(report("septic", septic)) ==
        R"($r' = f \cdot A i A^*$ with $A = u + v i + p j + q k$:
\begin{align*}
f &= 3 \\
u &= -\frac{1}{3}t^{3} + t \\
v &= -t^{2} \\
p &= 0 \\
q &= 1 \\
f|A|^2 &= \frac{1}{3}(t^{6} + 3t^{4} + 9t^{2} + 9)
\end{align*}
)");
  CHECK(contains(to_latex(report("", {Polynomial{1}, Polynomial{0, 2}, {}})),
                 "$|r'|$ is no polynomial: $|r'|^2$ has these factors to an odd power:\n"
                 "    $4t^{2} + 1$\n"));
  CHECK(contains(to_latex(report("", {Polynomial{1}, Polynomial{1}, {}})),
                 "$|r'|$ is $\\sqrt{2}$ times a polynomial: the curve is PH over $\\mathbb{R}$"));
}
