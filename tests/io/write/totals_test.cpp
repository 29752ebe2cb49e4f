
#include "phrame/answer/totals.hpp"
#include "io/reference.hpp"
#include "phrame/io/write/answers.hpp"
#include "phrame/io/write/passage.hpp"
#include "phrame/ph/along/arc_length.hpp"
#include "support/paths.hpp"
#include "support/text.hpp"

using namespace phrame;
using test::contains;
using test::Json;

namespace {

Json totals(const NamedCurve& curve, long digits = 17) {
  return Json::parse(to_json(answer(curve, TotalsQuery{digits})));
}

}  // namespace

TEST_CASE("totals report: of the quintic, its integrands and values") {
  const Json out = totals(test::farouki_quintic(), 50);
  CHECK(out["phrame"] == "totals/1");
  CHECK(out["length"]["exact"] == "71/15");
  CHECK(out["length"]["integrand"]["numerator"] == test::farouki_2003()["quintic"]["sigma"]);
  const std::string theta = test::farouki_2003()["quintic"]["theta_RMF_rel_Frenet"]["1"];
  test::check_rounded(out["torsion"]["value"], out["torsion"]["radius"], "-" + theta, 50, 50);
  CHECK(out["torsion"]["antiderivative"]["checked"] == true);
  // ∫ |r′ × r″|/|r′|² dt by mpmath's quad.
  const std::string curvature = "2.91201846746774099264840440758955575501200361901449358974";
  test::check_rounded(out["curvature"]["value"], out["curvature"]["radius"], curvature, 50, 50);
  CHECK(out["rotation_index"]["reason"] == "not a plane curve");
  const std::string text = to_text(answer(test::farouki_quintic(), TotalsQuery{5}));
  CHECK(contains(text, "  bending energy ∫ κ² ds = F(1) − F(0) with\n"));
  CHECK(contains(text, "    ≈ 2.2530\n"));
  CHECK(contains(text, "  total curvature ∫ κ ds\n    ≈ 2.9120\n"));
}

TEST_CASE("totals report: numbers before the decimals are abridged, in full on demand") {
  const Rational x(pow(Integer(10), 77) + 1, 7919);
  const NamedCurve curve{"", Curve({{Rational(1, 3), x}, {1 / x}, {3}, {1 / (x + 2)}})};
  const std::string text = to_text(answer(curve, TotalsQuery{5}));
  std::istringstream lines(abridged(text));
  for (std::string line; std::getline(lines, line);) CHECK(text_width(line) < 300);
  const std::string length = to_string(*arc_length(curve.curve, 0, 1));
  CHECK(length.size() > 300);
  CHECK(contains(for_reading(text, true), "    = " + length + "\n"));
  CHECK_FALSE(contains(abridged(text), length));
}

// A = (1 + (t − t²)(i − k))(1 + k): j, turned about i − k, whose length is √2.
TEST_CASE("totals report: a square root before the integral, and a sign that changes") {
  const NamedCurve curve{"", Curve({{1, 1, -1}, {0, 1, -1}, {0, -1, 1}, {1, -1, 1}})};
  const Json out = totals(curve);
  CHECK(out["curvature"]["turns"] == Json{"1/2"});
  CHECK(out["curvature"]["radicand"] == "2");
  CHECK(out["torsion"]["exact"] == "0");
  const std::string text = to_text(answer(curve, TotalsQuery{5}));
  CHECK(contains(text, "  total curvature ∫ κ ds = √2·(∫₀¹ ±F′ dt) with\n"));
  CHECK(contains(text, "the sign is + from 0 on and changes at t = 1/2\n"));
}

TEST_CASE("totals report: what is infinite or undefined says so") {
  const NamedCurve cusp{"", Curve({{1}, {}, {0, 1}, {}}, {Rational(-1, 2), 1})};
  const Json out = totals(cusp);
  CHECK(out["bending_energy"] == Json{{"value", "inf"}, {"pole", "1/2"}});
  CHECK(contains(to_text(answer(cusp, TotalsQuery{5})),
                 "bending energy ∫ κ² ds = ∞, the pole is at t = 1/2\n"));
  const Json line = totals(test::straight_line());
  CHECK(line["torsion"]["reason"] == "a straight line has no torsion");
  CHECK(line["frenet_energy"]["value"].is_null());
  CHECK(line["rotation_index"]["value"] == "0");
}

TEST_CASE("totals report: of a spline, sums without formulas") {
  const NamedPhPath loop{"loop", test::closed_loop()};
  const Json out = Json::parse(to_json(answer(loop, TotalsQuery{10})));
  CHECK(out["phrame"] == "spline-totals/1");
  CHECK(out["length"] ==
        Json{{"value", "5.333333333"}, {"radius", out["length"]["radius"]}, {"exact", "16/3"}});
  CHECK(out["curvature"]["exact"] == "2*pi");
  CHECK(out["rotation_index"] == Json{{"value", "1.000000000"}, {"radius", "0"}, {"exact", "1"}});
  CHECK(out["bending_energy"]["exact"] == "4 + 3/2*pi");
  const std::string text = to_text(answer(loop, TotalsQuery{5}));
  CHECK(text.starts_with("loop: PH spline of 4 segments, closed\n\n  length ∫ ds\n    = 16/3\n"));
  CHECK(contains(text, "  total curvature ∫ κ ds\n    = 2π\n    ≈ 6.2832\n"));
  CHECK(
      text.ends_with("From t = 0 to 4, the sums over the segments; decimals are correctly rounded "
                     "to 5 digits.\n"));
}

TEST_CASE("totals report: of a spline, why there is no number, and on which segment") {
  const Curve cusp({{1}, {}, {0, 1}, {}}, {-1, 2});
  const NamedPhPath path{"", test::chain({Curve({{1}, {}, {}, {}}, {-1}), cusp})};
  const Json out = Json::parse(to_json(answer(path, TotalsQuery{10})));
  CHECK(out["torsion"] ==
        Json{{"value", nullptr}, {"reason", "segment 1 is a straight line, which has no torsion"}});
  CHECK(out["bending_energy"] == Json{{"value", "inf"}, {"pole", "3/2"}, {"segment", 2}});
  CHECK(contains(to_text(answer(path, TotalsQuery{10})),
                 "bending energy ∫ κ² ds = ∞, the pole is at t = 3/2\n"));
  const NamedPhPath quintic{"", test::cut(test::farouki_quintic().curve, {Rational(1, 2)})};
  const Json cut = Json::parse(to_json(answer(quintic, TotalsQuery{50})));
  CHECK(cut["curvature"] == totals(test::farouki_quintic(), 50)["curvature"]);
  CHECK(cut["rotation_index"]["reason"] == "not in one plane");
  const std::string theta = test::farouki_2003()["quintic"]["theta_RMF_rel_Frenet"]["1"];
  test::check_rounded(cut["torsion"]["value"], cut["torsion"]["radius"], "-" + theta, 50, 50);
}

// The length is 4/3 + π/2.
TEST_CASE("totals report: of segments of several kinds, where there is a closed form") {
  const NamedPath path{
      "", joined({PhSegment(Curve({{1}, {}, {}, {0, 1}})),
                  bezier_curve(
                      {{Rational(2, 3), 1, 0}, {Rational(2, 3), 2, 0}, {Rational(-1, 3), 2, 0}},
                      {1, 1, 2})})};
  const TotalsAnswer found = answer(path, TotalsQuery{10});
  const Json out = Json::parse(to_json(found));
  CHECK(out["length"]["value"] == "2.904129660");
  CHECK(out["length"]["closed_forms"] == Json{1});
  CHECK_FALSE(out["up_twist"].contains("closed_forms"));
  CHECK(out["rotation_index"]["exact"] == "1/2");
  const std::string text = to_text(found);
  CHECK(
      contains(text, "length ∫ ds\n    ≈ 2.904129660\n    in closed form on 1 of 2 segments: 1\n"));
}

// A = 1 + tk: r′ = (1 − t², 2t, 0), σ = 1 + t², κ = 2/σ², so that κ ds = 2 dt/(1 + t²) and
// κ² ds = 4 dt/(1 + t²)³; ∫₀¹ dt/(1 + t²)³ = 1/4 + 3π/32. At the poles z = ±i of 2/(1 + t²) the
// residues are 1/z = −z.
TEST_CASE("totals report: the LaTeX of a plane cubic") {
  const std::string latex =
      to_latex(answer(NamedCurve{"", Curve({{1}, {}, {}, {0, 1}})}, TotalsQuery{5}));
  CHECK(contains(latex, R"(\begin{align*}
\text{length $\int ds$} &= F(1) - F(0) = \frac{4}{3} \approx 1.3333 \\
F' &= t^{2} + 1 \\
F &= \frac{1}{3}t^{3} + t
\end{align*}
)"));
  CHECK(contains(latex, R"(\begin{align*}
\text{total curvature $\int \kappa\, ds$} &= F(1) - F(0) = \frac{\pi }{2} \approx 1.5708 \\
F' &= \frac{2}{t^{2} + 1} \\
F &= \sum_{z^{2} + 1 = 0} \left(-z\right) \log(t - z)
\end{align*}
)"));
  CHECK(contains(latex,
                 "\\text{bending energy $\\int \\kappa^2\\, ds$} &= F(1) - F(0) = "
                 "1 + \\frac{3\\pi }{8} \\approx 2.1781 \\\\\n"));
  CHECK(contains(latex,
                 "\\text{absolute rotation index $\\int \\kappa\\, ds/2\\pi$} &= "
                 "\\frac{1}{4} = 0.25"));
}

TEST_CASE("totals report: in LaTeX a square root, a sign that changes, a pole, and a reason") {
  const auto latex = [](const NamedCurve& curve) {
    return to_latex(answer(curve, TotalsQuery{5}));
  };
  // The curves of the tests above.
  const std::string turning = latex({"", Curve({{1, 1, -1}, {0, 1, -1}, {0, -1, 1}, {1, -1, 1}})});
  CHECK(contains(turning, "= \\sqrt{2} \\left(\\int_0^1 \\pm F'\\, dt\\right)"));
  CHECK(contains(
      turning, "\n\\text{the sign is $+$ from $0$ on and changes at $t$} &= \\frac{1}{2} \\\\\n"));
  CHECK(contains(latex({"", Curve({{1}, {}, {0, 1}, {}}, {Rational(-1, 2), 1})}),
                 "&\\quad \\text{$\\infty$, the pole is at $t = \\frac{1}{2}$}\n"));
  CHECK(contains(latex(test::farouki_quintic()),
                 "\\text{absolute rotation index $\\int \\kappa\\, ds/2\\pi$} &\\quad "
                 "\\text{not a plane curve}\n"));
}

// A quarter of a turn is all that the tangent of two edges of a square turns by.
TEST_CASE("totals report: with corners, it is said what counts their angles and what does not") {
  Path path(bezier_curve({{0, 0, 0}, {1, 0, 0}}));
  path.append(bezier_curve({{1, 0, 0}, {1, 1, 0}}));
  const TotalsAnswer totals = answer(NamedPath{"", path}, TotalsQuery{5});
  const std::string text = to_text(totals);
  CHECK(contains(text, "total curvature ∫ κ ds, with the angles of the corners\n    = π/2\n"));
  CHECK(contains(text, "∫ κ ds/2π, with the angles of the corners\n    = 1/4\n"));
  CHECK(contains(text, "∫ κ² ds, without the corners, where it is infinite\n    = 0\n"));
  CHECK(contains(to_latex(totals), "$, with the angles of the corners} &= \\frac{\\pi }{2}"));
}
