
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "phrame/answer/classification.hpp"
#include "phrame/io/read/any_path.hpp"
#include "phrame/io/write/answers.hpp"
#include "support/paths.hpp"
#include "support/text.hpp"

using namespace phrame;
using test::contains;
using Json = nlohmann::json;

namespace {

ClassificationAnswer report(const QuaternionPolynomial& a, const Polynomial& f = {1}) {
  return answer(NamedPhPath{"", Curve(a, f)}, ClassificationQuery{});
}

}  // namespace

TEST_CASE("classify report: a helix, in text and JSON") {
  // x = 1, y = 2t², z = −2t, σ = 1 + 2t²: x + y = σ.
  const ClassificationAnswer cubic = report({{1}, {0, 1}, {0, 1}, {}});
  CHECK(contains(to_text(cubic),
                 "helix                 yes: axis (1, 1, 0), cos²ψ = 1/2, monotone\n"));
  const Json json = Json::parse(to_json(cubic));
  CHECK(json["phrame"] == "classify/1");
  CHECK(json["helical"] == Json{{"answer", true},
                                {"axis", {"1", "1", "0"}},
                                {"cos_squared", "1/2"},
                                {"monotone", true},
                                {"map_degree", 1}});
  CHECK(json["regular"] == Json{{"answer", true}, {"cusps", Json::array()}});
  CHECK(json["planar"] == Json{{"answer", false}});
  CHECK(json["rrmf"]["answer"] == false);
  // 2h/σ = 2/(1 + 2t²).
  CHECK(json["rrmf"]["residue_factor"] == Json{"1", "0", "2"});
  // At t = 0 r′ × r″ = (1, 0, 0) × (0, 0, −2), so that ρ = 4.
  CHECK(json["double_ph"]["constant"] == "4");
  CHECK(json["double_ph"]["omega"] == Json{"1"});
}

TEST_CASE("classify report: points are exact or have an interval, and an order") {
  const ClassificationAnswer cusps =
      report({{1, 1}, {}, {}, {0, 1}}, Polynomial{-1, 0, 2} * Polynomial{-1, 3});
  CHECK(contains(to_text(cusps), "no: r′ = 0 at t = 1/3, 0.707106781186…"));
  const Json list = Json::parse(to_json(cusps))["regular"]["cusps"];
  REQUIRE(list.size() == 2);
  CHECK(list[0] == Json{{"t", "1/3"}, {"order", 1}});
  CHECK(list[1]["t"]["polynomial"] == Json{"-1", "0", "2"});
  CHECK(list[1]["t"]["value"] == "0.70710678118654752");
  CHECK(list[1]["order"] == 1);
  const ClassificationAnswer twice = report({{1, 1}, {}, {}, {0, 1}}, pow(Polynomial{-1, 3}, 2));
  CHECK(contains(to_text(twice), "t = 1/3 (twice)"));
}

TEST_CASE("classify report: why there is no rational frame, or which there is") {
  const std::string poles = to_text(report({{0, 0, 1}, {0, 1}, {0, 1}, {1}}));
  CHECK(contains(poles, "no: 2h/σ has multiple poles, the zeros of t² + 1"));
  const std::string line = to_text(report({{1}, {0, 1}, {}, {}}));
  CHECK(contains(line, "straight line         yes: direction (1, 0, 0)"));
  CHECK(contains(line, "rational RMF          yes"));
  CHECK(contains(line, "double PH             yes: ρ = 0"));
  CHECK(contains(line, "primitive             no: gcd(x′, y′, z′) = t² + 1"));
  const Json json = Json::parse(to_json(report({{1}, {0, 1}, {}, {}})));
  CHECK(json["rrmf"]["answer"] == true);
  CHECK(json["line"]["direction"] == Json{"1", "0", "0"});
}

TEST_CASE("classify report: of a spline, the whole and its segments") {
  const ClassificationAnswer loop =
      answer(NamedPhPath{"loop", test::closed_loop()}, ClassificationQuery{});
  const std::string text = to_text(loop);
  CHECK(text.starts_with("loop: PH spline of 4 segments, closed\n\n  regular               yes\n"));
  CHECK(contains(text, "  in one plane          yes: normal (0, 0, 1)\n"));
  CHECK(contains(text, "\nSegment 4: PH cubic, degree 3 (preimage of degree 1)\n\n  regular"));
  CHECK(
      text.ends_with("\nPoints are those on [0, 1] of the segment. The witnesses were checked, "
                     "exactly.\n"));
  const Json json = Json::parse(to_json(loop));
  CHECK(json["phrame"] == "spline-classify/1");
  CHECK(json["name"] == "loop");
  CHECK(json["planar"] == Json{{"answer", true}, {"normal", {"0", "0", "1"}}});
  CHECK(json["line"] == Json{{"answer", false}});
  CHECK(json["erf_is_rmf"] == Json{{"answer", true}});
  REQUIRE(json["segments"].size() == 4);
  Json of_curve = Json::parse(to_json(
      answer(NamedPhPath{"", *ph_curve(loop.path.path.segments()[2])}, ClassificationQuery{})));
  of_curve.erase("phrame");
  of_curve.erase("name");
  CHECK(json["segments"][2] == of_curve);
}

TEST_CASE("classify report: of a spline, where one segment makes the difference") {
  const Curve screw({{1}, {0, 1}, {0, 1}, {}});
  const auto report = [](const PhPath& path) {
    return Json::parse(to_json(answer(NamedPhPath{"", path}, ClassificationQuery{})));
  };
  const Json pieces = report(test::cut(screw, {Rational(1, 2)}));
  CHECK(pieces["helical"] ==
        Json{{"answer", true}, {"axis", {"1", "1", "0"}}, {"cos_squared", "1/2"}});
  CHECK(pieces["regular"] == Json{{"answer", true}});
  CHECK(pieces["erf_is_rmf"] == Json{{"answer", false}});
  const Curve stopping({{1}, {}, {}, {}}, {1, -1});
  const Curve starting({{1}, {}, {}, {}}, {0, 1});
  const Json line = report(test::chain({stopping, starting}));
  CHECK(line["regular"] == Json{{"answer", false}});
  CHECK(line["line"] == Json{{"answer", true}, {"direction", {"1", "0", "0"}}});
}

TEST_CASE("classify report: the LaTeX of a helix") {
  // As above; ω₁ = 2h/σ² = 2/(1 + 2t²)² has its maximum at 0, and ρ = 4.
  CHECK(to_latex(report({{1}, {0, 1}, {0, 1}, {}})) ==
        R"(\begin{align*}
\text{regular} &\quad \text{yes} \\
\text{inflections} &\quad \text{none} \\
\text{straight line} &\quad \text{no} \\
\text{plane curve} &\quad \text{no} \\
\text{helix} &\quad \text{yes: axis $\left(1, 1, 0\right)$, $\cos^2\psi = \frac{1}{2}$, monotone} \\
\text{control polygon} &\quad \text{$L_0$ and $L_2$ on a cone around $L_1$, $\cos^2\vartheta = \frac{1}{2}$, $\cos \varphi = -\frac{1}{3}$} \\
\text{double PH} &\quad \text{yes: $\rho = 4\cdot\omega^2$, $\omega = 1$} \\
\text{primitive} &\quad \text{yes} \\
\text{ERF is an RMF} &\quad \text{no} \\
\text{rational RMF} &\quad \text{no: $2h/\sigma$ has residues that are not in $i\mathbb{Z}$, the roots of
    $2x^{2} + 1$} \\
\text{ERF turns one way} &\quad \text{yes} \\
\text{extrema of $\omega_1$} &\quad t = 0
\end{align*}
)");
}

// A line, a quarter of an ellipse in its plane, and a curve that leaves it.
TEST_CASE("classify report: of a path of several kinds, what all are, and the PH segments") {
  const auto report_of = [](const std::string& segments) {
    return answer(
        read_any_path(R"json({"phrame": "spline/1", "segments": [)json" + segments + "]}"),
        ClassificationQuery{});
  };
  const std::string flat = R"json({"control_points": [[0, 0, 0], [1, 0, 0]]},
      {"control_points": [[1, 0, 0], [2, 0, 0], [2, 2, 0]], "weights": [1, 1, 2]})json";
  const Json plane = Json::parse(to_json(report_of(flat)));
  CHECK(plane["planar"]["answer"] == true);
  CHECK(plane["line"]["answer"] == false);
  CHECK(plane["regular"]["answer"] == true);
  CHECK_FALSE(plane.contains("helical"));
  CHECK(plane["segments"][0]["line"]["answer"] == true);
  CHECK(plane["segments"][1] == Json{{"ph", false}});
  const ClassificationAnswer out = report_of(flat + R"json(,
      {"expressions": {"x": "2 + s^3", "y": "2 + sin(s)", "z": "s^2"}, "from": 0, "to": 1})json");
  CHECK(Json::parse(to_json(out))["planar"]["answer"] == false);
  CHECK(contains(to_text(out), "Segment 2: rational curve of degree 2, not Pythagorean-hodograph"));
  CHECK(contains(to_text(out), "Segment 3: curve by formulas, not Pythagorean-hodograph"));
  // r = (t³, t⁴, 0) stops at t = 0.
  const ClassificationAnswer cusp =
      answer(read_any_path(R"json({"phrame": "curve/1", "basis": "power",
          "position": {"x": [0, 0, 0, 1], "y": [0, 0, 0, 0, 1], "z": [0]}})json"),
             ClassificationQuery{});
  CHECK(Json::parse(to_json(cusp))["regular"]["answer"] == false);
}
