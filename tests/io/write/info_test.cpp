#include <algorithm>

#include "io/reference.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/answer/angle.hpp"
#include "phrame/answer/info.hpp"
#include "phrame/io/write/answers.hpp"
#include "phrame/io/write/text.hpp"
#include "support/farouki_moon.hpp"
#include "support/paths.hpp"
#include "support/random.hpp"
#include "support/text.hpp"

using namespace phrame;
using test::contains;
using test::Json;

namespace {

Json info(const NamedCurve& named, long digits = 50) {
  return Json::parse(to_json(answer(named, InfoQuery{digits})));
}

/// r′ = f·i.
NamedCurve on_a_line(const Polynomial& f) {
  return {"", Curve({Polynomial{1}, Polynomial(), Polynomial(), Polynomial()}, f)};
}

/// The reference curves whose preimage has at most that degree.
std::vector<Json> reference_curves(std::size_t max_degree) {
  std::istringstream lines(test::read_data("curves.jsonl"));
  std::vector<Json> curves;
  for (std::string line; std::getline(lines, line);) {
    Json curve = Json::parse(line);
    std::size_t length = 0;
    for (const Json& list : curve["preimage"]) length = std::max(length, list.size());
    if (length <= max_degree + 1) curves.push_back(std::move(curve));
  }
  return curves;
}

}  // namespace

TEST_CASE("curve info: the 2003 paper's quintic, exactly") {
  const Json& truth = test::farouki_2003()["quintic"];
  const Json out = info(test::farouki_quintic());
  CHECK(out["phrame"] == "info/1");
  CHECK(out["name"] == "quintic");
  CHECK(out["degree"] == 5);
  CHECK(out["preimage_degree"] == 2);
  CHECK(out["multiplier"] == Json{"1"});
  CHECK(out["sigma"] == truth["sigma"]);
  CHECK(out["h"] == truth["h"]);
  CHECK(out["rho"] == truth["rho"]);
  CHECK(out["triple_product"] == truth["triple"]);
  CHECK(out["split"] == Json{{"a", truth["a"]}, {"b", truth["b"]}});
  CHECK(out["arc_length"] == truth["arc_length"]);
  CHECK(out["end_point"] == truth["end_point"]);
  CHECK(out["cusps"].empty());
  // ρ = 4|g|² and the paper's W is g.
  CHECK(out["g"] == Json{{"re", truth["W_re"]}, {"im", truth["W_im"]}});
}

TEST_CASE("curve info: the preimage is printed in the power basis") {
  // By hand from the Bernstein coefficients, see curve_file_test.cpp.
  CHECK(info(test::farouki_quintic())["preimage"] ==
        Json::parse(R"({"u": ["2", "-4", "4"], "v": ["1", "0", "-1"], "p": ["0", "-4", "4"],
                        "q": ["1", "2", "-2"]})"));
}

TEST_CASE("curve info: the control polygon starts with A₀ i A₀*/5 and ends in the end point") {
  const Json points = info(test::farouki_quintic())["control_points"];
  REQUIRE(points.size() == 6);
  CHECK(points[0] == Json{"0", "0", "0"});
  // A₀ = 2 + i + k: u² + v² − p² − q² = 4, 2(uq + vp) = 4, 2(vq − up) = 2.
  CHECK(points[1] == Json{"4/5", "4/5", "2/5"});
  CHECK(points[5] == test::farouki_2003()["quintic"]["end_point"]);
}

TEST_CASE("curve info: the twist is minus the angle at 1, to 50 digits") {
  const std::string theta = test::farouki_2003()["quintic"]["theta_RMF_rel_ERF"]["1"];
  const Json twist = info(test::farouki_quintic())["twist_erf"];
  test::check_rounded(twist["value"], twist["radius"], "-" + theta, 50, 50);
}

TEST_CASE("curve info: a cusp is located, and the length of a curve that turns back is ∫|f|") {
  // r′ = (2t − 1)·i: f changes sign, ∫₀¹ f = 0 is not the length.
  const Json changing = info(on_a_line({-1, 2}));
  REQUIRE(changing["cusps"].size() == 1);
  CHECK(test::rational(changing["cusps"][0][0]) <= Rational(1, 2));
  CHECK(test::rational(changing["cusps"][0][1]) >= Rational(1, 2));
  CHECK(changing["bending_energy"]["value"] == "0");  // a line, there and back
  CHECK(changing["arc_length"] == "1/2");
  // r′ = (2t − 1)²·i: a cusp without a change of sign, ∫₀¹ (2t − 1)² = 1/3.
  const Json touching = info(on_a_line({1, -4, 4}));
  CHECK(touching["cusps"].size() == 1);
  CHECK(touching["arc_length"] == "1/3");
  // r′ = −i: no cusp, length 1.
  const Json backwards = info(on_a_line({-1}));
  CHECK(backwards["cusps"].empty());
  CHECK(backwards["arc_length"] == "1");
  CHECK(backwards["bending_energy"] == Json{{"value", "0"}, {"radius", "0"}});
  const std::string text = to_text(answer(on_a_line({-1, 2}), InfoQuery{5}));
  CHECK(contains(text, "cusp, r′ = 0        t = 1/2\n"));
  CHECK(contains(text, "length ∫₀¹ |f|σ     1/2\n"));
  // ∫₀¹ |t² − 1/2| = √2/3 − 1/6.
  const NamedCurve irrational = on_a_line({Rational(-1, 2), 0, 1});
  CHECK(info(irrational)["arc_length"]["value"].get<std::string>().starts_with("0.30473785412"));
  CHECK(contains(to_text(answer(irrational, InfoQuery{5})), "length ∫₀¹ |f|σ     0.30474\n"));
}

TEST_CASE("curve info: the energy does not depend on the direction of travel") {
  const NamedCurve quintic = test::farouki_quintic();
  const NamedCurve reversed{"", Curve(quintic.curve.preimage(), Polynomial{-1})};
  CHECK(info(reversed)["bending_energy"] == info(quintic)["bending_energy"]);
}

TEST_CASE("curve info: where f is negative, the text says which way the tangent points") {
  const auto text = [](const Polynomial& f) { return to_text(answer(on_a_line(f), InfoQuery{5})); };
  CHECK_FALSE(contains(text({-1}), "f < 0"));  // it is turned over
  CHECK(contains(text({-1, 2}), "f < 0 in a part of [0, 1]: there e₁"));
  CHECK_FALSE(contains(text({1, -4, 4}), "f < 0"));
}

TEST_CASE("curve info: the text abbreviates what is long, JSON does not") {
  const Rational cusp = 1 / (1 + power_of_ten(1000));
  const NamedCurve named = on_a_line({-cusp, 1});
  std::istringstream lines(abridged(to_text(answer(named, InfoQuery{5}))));
  for (std::string line; std::getline(lines, line);) CHECK(line.size() < 900);
  CHECK(info(named)["cusps"][0][0] == to_string(cusp));
  CHECK(info(on_a_line({power_of_ten(1000)}))["arc_length"].get<std::string>().size() == 1001);
}

TEST_CASE("curve info: a report outlives the curve it was made of") {
  const auto report = [] { return answer(test::farouki_quintic(), InfoQuery{5}); };
  CHECK(to_text(report()).starts_with("quintic: "));
}

TEST_CASE("curve info: the start moves the curve") {
  const NamedCurve moved{
      "", Curve(test::farouki_quintic().curve.preimage(), Polynomial{1}, {Rational(-1, 15), 0, 1})};
  CHECK(info(moved)["end_point"] == Json{"0", "38/15", "22/5"});
}

TEST_CASE("curve info: the text shows what JSON does, factored") {
  const std::string text = to_text(answer(test::farouki_quintic(), InfoQuery{12}));
  CHECK(text.starts_with("quintic: PH quintic, degree 5 (preimage of degree 2)\n"));
  CHECK(contains(text, "  u                   4t² − 4t + 2\n"));
  CHECK(contains(text, "  σ = |A|²            37t⁴ − 72t³ + 46t² − 12t + 6\n"));
  CHECK(contains(text, "  h                   4t(t − 1)\n"));
  CHECK(contains(text, "  ρ = 4|g|²           16(5t⁴ − 34t³ + 211t² − 186t + 45)\n"));
  CHECK(contains(text, "  r(1)                (1/15, 38/15, 17/5)\n"));
  CHECK(contains(text, "  length ∫₀¹ |f|σ     71/15\n"));
  CHECK(contains(text, "  twist ∫₀¹ 2h/σ      −0.285856530098\n"));
}

// The expected values were computed with more than 60 digits, independently (tests/data).
TEST_CASE("reports: angles and energies of all reference curves of low degree") {
  const auto curves = reference_curves(static_cast<std::size_t>(test::everyday(4, 20)));
  CHECK(curves.size() > 40);
  long number = 0;
  for (const Json& line : curves) {
    if (number++ % test::everyday(2, 1) != 0) continue;  // every other one is enough for every day
    CAPTURE(line["name"].get<std::string>());
    const NamedCurve named = read_curve(line.dump());
    const auto theta = [&](Reference reference) {
      AngleQuery query;
      query.reference = reference;
      query.at = {1};
      query.digits = 50;
      return Json::parse(to_json(answer(named, query)))["values"][0];
    };
    const Json& expected = line["expected"];
    const Json erf = theta(Reference::euler_rodrigues);
    test::check_rounded(erf["theta"], erf["radius"], expected["theta_erf_1"], 50, 60);
    if (expected.contains("theta_frenet_1")) {
      const Json frenet = theta(Reference::frenet);
      test::check_rounded(frenet["theta"], frenet["radius"], expected["theta_frenet_1"], 50, 60);
    } else {
      CHECK_THROWS_AS(theta(Reference::frenet), DomainError);  // a straight line
    }
    const Json energy = info(named)["bending_energy"];
    test::check_rounded(energy["value"], energy["radius"], expected["energy"], 50, 60);
  }
}

TEST_CASE("curve info: where the Euler-Rodrigues frame turns back, and the extrema of its rate") {
  const auto& example = test::farouki_moon()["example3"];
  const Json out = info({"", test::curve_of(example)}, 20);
  for (const auto& [key, known] : {std::pair("erf_inflections", "ERF_inflections"),
                                   std::pair("erf_extrema", "ERF_omega1_extrema")}) {
    const auto& expected = example["consistent"][known];
    REQUIRE(out[key].size() == expected.size());
    for (std::size_t k = 0; k < expected.size(); ++k)
      CHECK(abs(test::number(out[key][k]) - test::number(expected[k])) < power_of_ten(-19));
  }
}

// A = 1 + ti + tj: α = 1 + it, β = it, σ = 1 + 2t², h = uv′ − u′v − pq′ + p′q = 1, g = αβ′ − α′β =
// i, ρ = 4, a = 2h, b = −4 Im(g′ḡ) = 0. r′ = (1, 2t², −2t), r′ × r″ = (4t², 2, 4t), r‴ = (0, 4, 0).
// ∫₀¹ 2/(1 + 2t²) dt = √2·arctan √2, and with κ = 2/σ², ∫ κ² ds = ∫₀¹ 4/(1 + 2t²)³ dt = 1/9 + 1/2 +
// (3/4)√2·arctan √2, where arctan √2 = 0.955316618….
TEST_CASE("curve info: the LaTeX of a helix") {
  const NamedCurve helix{"", Curve({{1}, {0, 1}, {0, 1}, {}})};
  CHECK(to_latex(answer(helix, InfoQuery{5})) ==
        R"(\begin{align*}
u &= 1 \\
v &= t \\
p &= t \\
q &= 0 \\
\sigma = |A|^2 &= 2t^{2} + 1 \\
h &= 1 \\
g &= i \\
\rho = 4|g|^2 &= 4 \\
(r' \times r'')\cdot r''' &= 8 \\
\text{split $a$} &= 2 \\
\text{split $b$} &= 0 \\
r(0) &= \left(0, 0, 0\right) \\
r(1) &= \left(1, \frac{2}{3}, -1\right) \\
\text{length $\int_0^1 |f|\sigma$} &= \frac{5}{3} \\
\text{twist $\int_0^1 2h/\sigma$} &\approx 1.3510 \\
\text{energy $\int_0^1 \kappa^2\, ds$} &\approx 1.6244
\end{align*}
)");
}

TEST_CASE("curve info: text, JSON and LaTeX name the same fields") {
  const InfoAnswer quintic = answer(test::farouki_quintic(), InfoQuery{12});
  const std::string text = to_text(quintic);
  const std::string latex = to_latex(quintic);
  const Json json = Json::parse(to_json(quintic));
  struct Names {
    const char* key;
    const char* label;
    const char* latex;
  };
  for (const Names& names :
       {Names{"/preimage/u", "u", "u"}, Names{"/sigma", "σ = |A|²", "\\sigma = |A|^2"},
        Names{"/h", "h", "h"}, Names{"/g", "g", "g"}, Names{"/rho", "ρ = 4|g|²", "\\rho = 4|g|^2"},
        Names{"/triple_product", "(r′ × r″)·r‴", "(r' \\times r'')\\cdot r'''"},
        Names{"/split/b", "  split b", "\\text{split $b$}"},
        Names{"/control_points/0", "r(0)", "r(0)"}, Names{"/end_point", "r(1)", "r(1)"},
        Names{"/arc_length", "length ∫₀¹ |f|σ", "\\text{length $\\int_0^1 |f|\\sigma$}"},
        Names{"/twist_erf", "twist ∫₀¹ 2h/σ", "\\text{twist $\\int_0^1 2h/\\sigma$}"},
        Names{"/erf_extrema/0", "extremum of ω₁", "\\text{extremum of $\\omega_1$}"},
        Names{"/bending_energy", "energy ∫₀¹ κ² ds",
              "\\text{energy $\\int_0^1 \\kappa^2\\, ds$}"}}) {
    CAPTURE(names.key);
    CHECK(json.contains(Json::json_pointer(names.key)));
    CHECK(contains(text, std::string("\n  ") + names.label + "  "));
    CHECK(contains(latex, std::string("\n") + names.latex + " &"));
  }
}

TEST_CASE("spline info: LaTeX has the segments in a table") {
  // Two segments of a straight line, of the lengths 1/3 and 2/3.
  const std::string latex = to_latex(answer(
      NamedPhPath{"", test::cut(test::straight_line().curve, {Rational(1, 3)})}, InfoQuery{5}));
  CHECK(latex ==
        R"(\begin{align*}
\text{length $\int |f|\sigma$} &= 1 \\
\text{twist $\int 2h/\sigma$} &= 0 \\
\text{energy $\int \kappa^2\, ds$} &= 0
\end{align*}
\begin{tabular}{rrl}
segment & degree & length \\
1 & 1 & $\frac{1}{3}$ \\
2 & 1 & $\frac{2}{3}$ \\
\end{tabular}
)");
}
