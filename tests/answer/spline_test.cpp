#include <algorithm>

#include "io/reference.hpp"
#include "phrame/answer/angle.hpp"
#include "phrame/answer/frame_table.hpp"
#include "phrame/answer/info.hpp"
#include "phrame/io/write/answers.hpp"
#include "phrame/io/write/frame_table.hpp"
#include "support/text.hpp"

namespace spline_test {

using namespace phrame;
using test::contains;
using test::Json;

namespace {

/// r′ = (1 − t², 2t, 0) and three copies, each turned by a quarter: a closed plane curve.
NamedPhPath loop(std::size_t segments = 4) {
  const std::vector<QuaternionPolynomial> preimages{{{1}, {}, {}, {0, 1}},
                                                    {{1, -1}, {}, {}, {1, 1}},
                                                    {{0, -1}, {}, {}, {1}},
                                                    {{-1, -1}, {}, {}, {1, -1}}};
  PhPath path{Curve(preimages[0])};
  for (std::size_t k = 1; k < segments; ++k)
    path.append(Curve(preimages[k], {k % 2 == 0 ? Rational(1) : Rational(1, 2)},
                      evaluate(position(path.segments().back()), 1)));
  return {"loop", path};
}

/// The quintic of 2003, cut at 1/3.
NamedPhPath cut_quintic() {
  const Curve quintic = test::farouki_quintic().curve;
  const auto affine = [&](const Polynomial& t, const Rational& speed, const Vector<Rational>& at) {
    const QuaternionPolynomial& a = quintic.preimage();
    return Curve({compose(a.u, t), compose(a.v, t), compose(a.p, t), compose(a.q, t)},
                 Polynomial{speed}, at);
  };
  const Rational third(1, 3);
  PhPath path{affine({0, third}, third, {})};
  path.append(affine({third, 2 * third}, 2 * third, evaluate(position(quintic), third)));
  return {"cut", path};
}

Place at(std::size_t segment, const Rational& t) { return {segment, t}; }

const TableColumns columns{{TabulatedFrame::rmf}, {TabulatedScalar::arc_length}};

}  // namespace

TEST_CASE("spline report: the angle of the quintic in two pieces") {
  AngleQuery query;
  query.at = {Rational(1, 10) * 3, Rational(7, 4)};
  query.digits = 40;
  const Json out = Json::parse(to_json(answer(cut_quintic(), query)));
  CHECK(out["phrame"] == "spline-angle/1");
  CHECK(out["segments"].size() == 2);
  CHECK(out["closed"] == false);
  CHECK(out["holonomy"].is_null());
  const Json& theta = test::farouki_2003()["quintic"]["theta_RMF_rel_ERF"];
  test::check_rounded(out["total"]["value"], out["total"]["radius"], theta["1"], 40, 50);
  // t = 3/10 is 1/10 of the whole, and 7/4 is 1/3 + 3/4·2/3 = 5/6.
  test::check_rounded(out["values"][0]["theta"], out["values"][0]["radius"], theta["1/10"], 40, 50);
}

TEST_CASE("spline report: a closed plane curve in text") {
  const NamedPhPath named = loop();
  AngleQuery query;
  query.at = {4};
  const std::string text = to_text(answer(named, query));
  CHECK(text.starts_with("loop: PH spline of 4 segments, closed\n"));
  CHECK(contains(text, "  holonomy = 0"));
  CHECK(contains(text, "  total angle = 0\n"));
  const std::string info = to_text(answer(named, InfoQuery{10}));
  CHECK(contains(info, "  length ∫ |f|σ       16/3\n"));
  CHECK(contains(info, "  energy ∫ κ² ds      8.712388980\n"));  // 4 + 3π/2, by hand
  CHECK(contains(to_text(answer(loop(3), InfoQuery{10})), "PH spline of 3 segments, open\n"));
  const Json json = Json::parse(to_json(answer(named, InfoQuery{10})));
  CHECK(json["arc_length"] == "16/3");
  CHECK(json["closed"] == true);
  CHECK(json["segments"][3]["end"] == Json{"0", "0", "0"});
}

TEST_CASE("frame table: of a spline, in equal steps of t and at its joints") {
  const NamedPhPath named = loop();
  const FrameTable table = frame_table(PathAngle(named.path), columns,
                                       {at(0, 0), at(1, 0), at(1, Rational(1, 2)), at(3, 1)});
  REQUIRE(table.rows.size() == 4);
  CHECK(table.rows[1] ==
        std::vector<double>{1, 2.0 / 3, 1, 0, 0, 1, 0, -1, 0, 0, 0, 0, 1, 4.0 / 3});
  CHECK(table.rows[2][0] == 1.5);
  CHECK(table.rows[2].back() == 4.0 / 3 + 13.0 / 24);
  CHECK(table.rows[3] == std::vector<double>{4, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 16.0 / 3});
}

TEST_CASE("frame table: pieces have the frames of the whole, at algebraic t as well") {
  const NamedPhPath cut = cut_quintic();
  const Curve whole = test::farouki_quintic().curve;
  const RealAlgebraic root = real_root({-1, 0, 2}, closed_interval(0, 1));       // √2/2
  const RealAlgebraic on_whole = real_root({-1, -6, 9}, closed_interval(0, 1));  // 1/3 + 2/3·√2/2
  const auto pieces = frame_table(PathAngle(cut.path), columns, {Place{1, root}});
  const auto row = frame_table(whole, columns, std::vector<RealAlgebraic>{on_whole});
  for (std::size_t k = 1; k < row.columns.size(); ++k) CHECK(pieces.rows[0][k] == row.rows[0][k]);
}

TEST_CASE("spline report: every form and LaTeX are those of the segments") {
  const NamedPhPath named = cut_quintic();
  AngleQuery query;
  query.style = Style::real;
  const AngleAnswer real = answer(named, query);
  REQUIRE(real.formulas.size() == 2);
  for (std::size_t k = 0; k < 2; ++k)
    CHECK(differentiate(std::get<RealForm>(real.formulas[k]->other)) ==
          rate_to_erf(named.path.segments()[k].preimage()));
  CHECK(Json::parse(to_json(real))["segments"][1]["real"]["checked"] == true);
  CHECK(contains(to_text(real), "Segment 2\n"));
  const std::string latex = to_latex(real);
  CHECK(contains(latex, "\\theta_{1}'(t) &= "));
  CHECK(contains(latex, " + C_{1} \\\\\n\\theta_{2}'(t) &= "));
  CHECK(std::count(latex.begin(), latex.end(), '{') == std::count(latex.begin(), latex.end(), '}'));
}

}  // namespace spline_test
