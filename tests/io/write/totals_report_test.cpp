#include "phrame/io/write/totals_report.hpp"

#include "io/reference.hpp"

using namespace phrame;
using test::Json;

namespace {

Json totals(const NamedCurve& curve, long digits = 17) {
  return Json::parse(to_json(totals_report(curve, digits)));
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
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
  CHECK(out["curvature"]["value"].is_null());
  CHECK(out["rotation_index"]["reason"] == "not a plane curve");
  const std::string text = to_text(totals_report(test::farouki_quintic(), 5));
  CHECK(contains(text, "  bending energy ∫ κ² ds = F(1) − F(0) with\n"));
  CHECK(contains(text, "    ≈ 2.2530\n"));
  CHECK(contains(text, "  total curvature ∫ κ ds: κ is not rational"));
}

// A = (1 + (t − t²)(i − k))(1 + k): j, turned about i − k, whose length is √2.
TEST_CASE("totals report: a square root before the integral, and a sign that changes") {
  const NamedCurve curve{"", Curve({{1, 1, -1}, {0, 1, -1}, {0, -1, 1}, {1, -1, 1}})};
  const Json out = totals(curve);
  CHECK(out["curvature"]["turns"] == Json{"1/2"});
  CHECK(out["curvature"]["radicand"] == "2");
  CHECK(out["torsion"]["exact"] == "0");
  const std::string text = to_text(totals_report(curve, 5));
  CHECK(contains(text, "  total curvature ∫ κ ds = √2·(∫₀¹ ±F′ dt) with\n"));
  CHECK(contains(text, "the sign is + from 0 on and changes at t = 1/2\n"));
}

TEST_CASE("totals report: what is infinite or undefined says so") {
  const NamedCurve cusp{"", Curve({{1}, {}, {0, 1}, {}}, {Rational(-1, 2), 1})};
  const Json out = totals(cusp);
  CHECK(out["bending_energy"] == Json{{"value", "inf"}, {"pole", "1/2"}});
  CHECK(contains(to_text(totals_report(cusp, 5)),
                 "bending energy ∫ κ² ds = ∞, the pole is at t = 1/2\n"));
  const Json line = totals(test::straight_line());
  CHECK(line["torsion"]["reason"] == "a straight line has no torsion");
  CHECK(line["frenet_energy"]["value"].is_null());
  CHECK(line["rotation_index"]["value"] == "0");
}
