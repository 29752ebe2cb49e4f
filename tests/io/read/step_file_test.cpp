#include "phrame/io/read/step_file.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "phrame/algebra/error.hpp"
#include "phrame/io/read/any_path.hpp"
#include "phrame/io/read/iges_file.hpp"
#include "phrame/io/read/plane_conic.hpp"
#include "support/data.hpp"
#include "support/refusal.hpp"
#include "support/text.hpp"

// What Open CASCADE writes is in programs_test.cpp; here is what it does not write, by hand.
namespace step_file_test {

using namespace phrame;

namespace {

std::string step(const std::string& data) {
  return "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION((''),'2;1');\nENDSEC;\nDATA;\n" + data +
         "ENDSEC;\nEND-ISO-10303-21;\n";
}

/// Four points and a placement, in the line 6 and the next.
const std::string points =
    "#1=CARTESIAN_POINT('',(0.,0.,0.));#2=CARTESIAN_POINT('',(1.,2.,0.));\n"
    "#3=CARTESIAN_POINT('',(3.,2.,1.));#4=CARTESIAN_POINT('it''s; /*',(4.,0.,2.5E-1));\n";

NamedPath read(const std::string& text, const std::string& pick = "") {
  FileReading reading;
  reading.pick = pick;
  return read_any_path(text, {}, reading);
}

std::string refusal(const std::string& data, const std::string& pick = "") {
  return test::refusal_of<InputError>([&] { read(step(points + data), pick); });
}

const RationalCurve& curve_of(const NamedPath& named, std::size_t k = 0) {
  return *rational_curve(named.path.segments()[k]);
}

/// A line of an IGES file: text up to column 72, letter, number.
std::string iges_line(std::string text, char section, int number) {
  text.resize(72, ' ');
  return text + section + std::string(7 - std::to_string(number).size(), ' ') +
         std::to_string(number) + "\n";
}

/// One free entity, with one line of parameters.
std::string iges(const std::string& type, const std::string& parameters,
                 const std::string& form = "0") {
  const auto field = [](const std::string& x) { return std::string(8 - x.size(), ' ') + x; };
  return iges_line("", 'S', 1) + iges_line("1H//1H!/", 'G', 1) +
         iges_line(field(type) + field("1") + field("0") + field("0") + field("0") + field("0") +
                       field("0") + field("0") + "00000000",
                   'D', 1) +
         iges_line(field(type) + field("0") + field("0") + field("1") + field(form), 'D', 2) +
         iges_line(parameters, 'P', 1) + iges_line("S      1G      1D      2P      1", 'T', 1);
}

}  // namespace

TEST_CASE("step: splines are exact, with comments, texts and blanks anywhere") {
  const NamedPath named =
      read(step(points + "#10 = /* ; */ B_SPLINE_CURVE_WITH_KNOTS('rail',3,(#1,#2,\n#3,"
                         "#4),.UNSPECIFIED.,.F.,.F.,(4,4),(0.,2.),.UNSPECIFIED.) ;\n"));
  CHECK(named.name == "rail");
  CHECK(curve_of(named) == bezier_curve({{0, 0, 0}, {1, 2, 0}, {3, 2, 1}, {4, 0, Rational(1, 4)}}));
  REQUIRE(named.parameters.size() == 2);
  CHECK(named.parameters[1].exact() == Rational(2));
}

/// Is c(x, y) = 0 on it, as a polynomial in t? For all t, then, z is this.
bool is_on(const RationalCurve& curve, const PlaneConic& c, const Rational& z = 0) {
  const auto [x, y, z_times_w] = curve.numerator();
  const Polynomial& w = curve.weight();
  return z_times_w == z * w &&
         (c[0] * x * x + c[1] * x * y + c[2] * y * y + c[3] * x * w + c[4] * y * w + c[5] * w * w)
             .is_zero();
}

// x = y²/4 + 1 and (x − 1)²/4 − (y − 2)²/9 = 1, by ISO 10303-42.
TEST_CASE("step: parabolas and hyperbolas between places and parameters") {
  const auto conic = [](const std::string& kind, const std::string& trims) {
    return read(
        step(points + "#5=CARTESIAN_POINT('',(1.,0.,0.));#6=AXIS2_PLACEMENT_3D('',#" +
             (kind.starts_with("P") ? "5" : "2") + ",$,$);#7=" + kind +
             ";#8=CARTESIAN_POINT('',(2.,2.,0.));#9=CARTESIAN_POINT('',(5.,-4.,0.));\n"
             "#11=CARTESIAN_POINT('',(-1.,2.,0.));#12=CARTESIAN_POINT('',(-1.5,4.25,0.));\n" +
             "#10=TRIMMED_CURVE('',#7," + trims + ",.T.,.CARTESIAN.);\n"));
  };
  const PlaneConic parabola{0, 0, 1, -4, 0, 4};
  const NamedPath by_places = conic("PARABOLA('',#6,1.)", "(#8),(#9)");
  CHECK(is_on(curve_of(by_places), parabola));
  CHECK(point(curve_of(by_places), 0) == Vector<Rational>{2, 2, 0});
  CHECK(point(curve_of(by_places), 1) == Vector<Rational>{5, -4, 0});
  CHECK(curve_of(conic("PARABOLA('',#6,1.)", "(PARAMETER_VALUE(1.)),(PARAMETER_VALUE(-2.))")) ==
        curve_of(by_places));

  const PlaneConic hyperbola{9, 0, -4, -18, 16, -43};
  const RationalCurve branch =
      curve_of(conic("HYPERBOLA('',#6,2.,3.)", "(PARAMETER_VALUE(-0.5)),(PARAMETER_VALUE(1.5))"));
  CHECK(is_on(branch, hyperbola));
  for (const auto& [t, u] : {std::pair{0, -0.5}, {1, 1.5}}) {
    CHECK(static_cast<double>(point(branch, t)[0]) ==
          doctest::Approx(1 + 2 * std::cosh(u)).epsilon(1e-15));
    CHECK(static_cast<double>(point(branch, t)[1]) ==
          doctest::Approx(2 + 3 * std::sinh(u)).epsilon(1e-15));
  }
  const auto refused = [&](const std::string& kind, const std::string& trims) {
    return test::refusal_of<InputError>([&] { conic(kind, trims); });
  };
  CHECK(test::contains(refused("HYPERBOLA('',#6,2.,3.)", "(#8),(#9)"),
                       "#7=HYPERBOLA: an end is not on the curve"));
  CHECK(test::contains(refused("HYPERBOLA('',#6,2.,3.)", "(#11),(#12)"),  // the other branch
                       "an end is not on the curve"));
  CHECK(test::contains(refused("PARABOLA('',#6,1.)", "(#8),(#8)"), "its ends are one"));
  CHECK(test::contains(
      refused("HYPERBOLA('',#6,2.,3.)", "(PARAMETER_VALUE(0.)),(PARAMETER_VALUE(2000.))"),
      "beyond 1000"));
}

// Half of the spline above; by de Casteljau's algorithm the ends are those of its middle.
TEST_CASE("step: parts of splines are cut at parameters, and may run backwards") {
  const std::string spline =
      "#10=B_SPLINE_CURVE_WITH_KNOTS('',3,(#1,#2,#3,#4),.U.,.F.,.F.,(4,4),(0.,2.),.U.);\n";
  const auto part = [&](const std::string& trims, const std::string& sense) {
    return read(step(points + spline +
                     "#11=TRIMMED_CURVE('',"
                     "#10," +
                     trims + "," + sense + ",.PARAMETER.);\n"));
  };
  const RationalCurve whole =
      bezier_curve({{0, 0, 0}, {1, 2, 0}, {3, 2, 1}, {4, 0, Rational(1, 4)}});
  const NamedPath half = part("(PARAMETER_VALUE(0.5)),(PARAMETER_VALUE(1.5))", ".T.");
  const NamedPath back = part("(PARAMETER_VALUE(1.5)),(PARAMETER_VALUE(0.5))", ".F.");
  for (const Rational& t : {Rational(0), Rational(1, 3), Rational(1)}) {
    CHECK(point(curve_of(half), t) == point(whole, Rational(1, 4) + t / 2));
    CHECK(point(curve_of(back), t) == point(whole, Rational(3, 4) - t / 2));
  }
  CHECK(test::contains(
      refusal(spline + "#11=TRIMMED_CURVE('',#10,(PARAMETER_VALUE(0.5)),(PARAMETER_VALUE(2.5)),.T.,"
                       ".PARAMETER.);"),
      "from 1/2 to 5/2 is not between its knots 0 and 2"));
}

TEST_CASE("step: angles are radians, or degrees where the file says so") {
  const std::string arc =
      "#5=DIRECTION('',(0.,0.,2.));#6=AXIS2_PLACEMENT_3D('',#2,#5,$);#7=CIRCLE('',#6,3.);\n"
      "#8=TRIMMED_CURVE('',#7,(PARAMETER_VALUE(90.)),(PARAMETER_VALUE(180.)),.T.,.PARAMETER.);\n";
  const NamedPath degrees =
      read(step(points + arc +
                "#9=(CONVERSION_BASED_UNIT('DEGREE',#99)NAMED_UNIT(#98)PLANE_ANGLE_UNIT());\n"));
  CHECK(degrees.path.segments().size() == 1);
  CHECK(point(curve_of(degrees), 0) == Vector<Rational>{1, 5, 0});
  CHECK(point(curve_of(degrees), 1) == Vector<Rational>{-2, 2, 0});
  // 180 − 90 radians are 90 − 14·2π = 2.0354…, one quarter and a part of another.
  CHECK(read(step(points + arc)).path.segments().size() == 2);
}

TEST_CASE("step: composite curves, sets, edges") {
  const std::string lines = "#10=POLYLINE('a',(#1,#2));#11=POLYLINE('b',(#3,#2));\n";
  const std::string composite =
      lines +
      "#12=COMPOSITE_CURVE_SEGMENT(.CONTINUOUS.,.T.,#10);\n"
      "#13=COMPOSITE_CURVE_SEGMENT(.CONTINUOUS.,.F.,#11);#14=COMPOSITE_CURVE('way',(#12,"
      "#13),.F.);\n";
  for (const std::string& data :
       {composite, lines + "#15=GEOMETRIC_CURVE_SET('way',(#10,#11));\n"}) {
    const NamedPath named = read(step(points + data));
    REQUIRE(named.path.segments().size() == 2);
    CHECK(point(curve_of(named, 1), 1) == Vector<Rational>{3, 2, 1});
  }
  CHECK(read(step(points + lines), "b").path.segments().size() == 1);
  CHECK(test::contains(refusal(lines), "there are 2 curves, and --pick names one: a, b"));
  const std::string edges =
      "#20=VERTEX_POINT('',#1);#21=VERTEX_POINT('',#2);#22=LINE('',#1,$);\n"
      "#23=EDGE_CURVE('',#20,#21,#22,.T.);#24=EDGE_CURVE('',#21,#20,#22,.F.);\n";
  CHECK(point(curve_of(read(step(points + edges), "#24")), 0) == Vector<Rational>{1, 2, 0});
}

TEST_CASE("step: what is not read is named, with its line") {
  CHECK(refusal("#10=CLOTHOID('',#1,2.);#11=GEOMETRIC_CURVE_SET('',(#10));\n") ==
        "line 8: #10=CLOTHOID: this is not read; curves are B-splines of all kinds, POLYLINE, "
        "and LINE, CIRCLE, ELLIPSE, PARABOLA or HYPERBOLA between ends");
  CHECK(
      test::contains(refusal("#10=POLYLINE('',(#1,#77));\n"), "line 8: #10=POLYLINE: there is no"));
  CHECK(test::contains(refusal("#10=POLYLINE('',(#1,5));\n"), "a list of points is expected"));
  CHECK(test::contains(refusal("#10=POLYLINE('',(#1,#2);\n"), "\",\" or \")\" is expected"));
  CHECK(test::contains(refusal("#10=POLYLINE('',(#1,#2))\n"), "line 8"));
  CHECK(test::contains(refusal("#1=POLYLINE('',(#1,#2));\n"), "#1 is there twice"));
  CHECK(test::contains(refusal(""), "line 1: there is no curve in the STEP file"));
  CHECK(test::contains(
      refusal("#10=B_SPLINE_CURVE_WITH_KNOTS('',3,(#1,#2,#3,#4),.U.,.F.,.F.,(4,3),(0.,2.),.U.);"),
      "line 8: #10=B_SPLINE_CURVE_WITH_KNOTS: "));
  CHECK(test::contains(refusal("#10=COMPOSITE_CURVE_SEGMENT(.C.,.T.,#11);\n"
                               "#11=COMPOSITE_CURVE('',(#10),.F.);\n"
                               "#12=GEOMETRIC_CURVE_SET('',(#11));\n"),
                       "more than 32 deep"));
}

// The points by hand: those of a spline with the knots that ISO 10303-42 says.
TEST_CASE("step: Bézier and uniform splines have the knots of their kind") {
  const auto kind = [](const std::string& name, const std::string& degree) {
    return read(
        step(points + "#10=" + name + "('rail'," + degree + ",(#1,#2,#3,#4),.U.,.F.,.F.);\n"));
  };
  const RationalCurve whole =
      bezier_curve({{0, 0, 0}, {1, 2, 0}, {3, 2, 1}, {4, 0, Rational(1, 4)}});
  CHECK(curve_of(kind("BEZIER_CURVE", "3")) == whole);
  CHECK(curve_of(kind("QUASI_UNIFORM_CURVE", "3")) == whole);
  // The middle of p₁ and p₂ is where two parabolas meet.
  const NamedPath two = kind("QUASI_UNIFORM_CURVE", "2");
  REQUIRE(two.path.segments().size() == 2);
  CHECK(two.parameters[2].exact() == Rational(2));
  // (p₀ + 4p₁ + p₂)/6 and (p₁ + 4p₂ + p₃)/6, by the uniform cubic B-spline.
  const RationalCurve uniform = curve_of(kind("UNIFORM_CURVE", "3"));
  CHECK(point(uniform, 0) == Vector<Rational>{Rational(7, 6), Rational(5, 3), Rational(1, 6)});
  CHECK(point(uniform, 1) == Vector<Rational>{Rational(17, 6), Rational(5, 3), Rational(17, 24)});
  const std::string rational =
      "#10=(BEZIER_CURVE()BOUNDED_CURVE()B_SPLINE_CURVE(3,(#1,#2,#3,#4),.U.,.F.,.F.)CURVE()"
      "GEOMETRIC_REPRESENTATION_ITEM()RATIONAL_B_SPLINE_CURVE((1.,2.,2.,1.))"
      "REPRESENTATION_ITEM('rail'));\n";
  CHECK(curve_of(read(step(points + rational))) ==
        bezier_curve({{0, 0, 0}, {1, 2, 0}, {3, 2, 1}, {4, 0, Rational(1, 4)}}, {1, 2, 2, 1}));
  CHECK(test::contains(test::refusal_of<InputError>([&] { kind("BEZIER_CURVE", "2"); }),
                       "4 points are none of Bézier curves of degree 2"));
}

TEST_CASE("iges: lines through points, and piecewise cubics") {
  const auto corners = [](const NamedPath& named) {
    std::vector<Vector<Rational>> list;
    for (std::size_t k = 0; k < named.path.segments().size(); ++k)
      list.push_back(point(curve_of(named, k), 0));
    return list;
  };
  const std::vector<Vector<Rational>> square{{0, 0, 5}, {1, 0, 5}, {1, 1, 5}};
  const NamedPath closed = read(iges("106", "106/1/3/5/0/0/1/0/1/1!", "63"));
  CHECK(corners(closed) == square);
  CHECK(closed.path.ends_meet());
  CHECK(corners(read(iges("106", "106/2/3/0/0/5/1/0/5/1/1/5!", "12"))) ==
        std::vector<Vector<Rational>>{{0, 0, 5}, {1, 0, 5}});
  CHECK(corners(read(iges("106", "106/3/2/0/0/5/7/7/7/1/0/5/7/7/7!", "13"))) ==
        std::vector<Vector<Rational>>{{0, 0, 5}});
  const auto refused = [](const std::string& form) {
    return test::refusal_of<InputError>([&] { read(iges("106", "106/2/2/1/1/1/1/1/1!", form)); });
  };
  CHECK(test::contains(refused("2"), "there is no curve"));  // points
  CHECK(test::contains(refused("12"), "its points are one point"));
  // (s, s², 1 + s³) from 1 to 3, which begins with s = 0.
  const NamedPath cubic = read(iges("112", "112/3/1/3/1/1/3/0/1/0/0/0/0/1/0/1/0/0/1/0/0/0/0!"));
  CHECK(curve_of(cubic) ==
        RationalCurve({Polynomial{0, 2}, Polynomial{0, 0, 4}, Polynomial{1, 0, 0, 8}}, {1}));
  CHECK(cubic.parameters[0].exact() == Rational(1));
}

// The conics by hand, as ellipses and parabolas that are turned, too.
TEST_CASE("iges: conics are exact but for the lengths of ellipses") {
  const auto conic = [](const std::string& parameters, const std::string& form) {
    return read(iges("104", "104/" + parameters + "!", form));
  };
  // x² + xy + y² = 3 from (1, 1) to (−1, −1), which is half of it; all of it.
  const PlaneConic turned{1, 1, 1, 0, 0, -3};
  for (const char* form : {"0", "1"}) {
    const NamedPath half = conic("1/1/1/0/0/-3/7/1/1/-1/-1", form);
    REQUIRE(half.path.segments().size() == 2);
    for (std::size_t k = 0; k < 2; ++k) {
      const auto at = point(curve_of(half, k), Rational(1, 3));
      CHECK(std::abs(static_cast<double>(at[0] * at[0] + at[0] * at[1] + at[1] * at[1]) - 3) <
            1e-15);
      CHECK(at[2] == 7);
      CHECK(at[0] < at[1]);  // counterclockwise
    }
    CHECK(point(curve_of(half, 1), 1) == Vector<Rational>{-1, -1, 7});
  }
  CHECK(conic("1/1/1/0/0/-3/7/1/1/1/1", "1").path.segments().size() == 4);
  CHECK(is_on(curve_of(conic("4/0/9/0/0/-36/0/3/0/0/2", "1")), {4, 0, 9, 0, 0, -36}));
  // (x + y)² = 4(x − y), and xy = 1.
  CHECK(is_on(curve_of(conic("1/2/1/-4/4/0/7/0/0/4/0", "3")), {1, 2, 1, -4, 4, 0}, 7));
  CHECK(curve_of(conic("1/2/1/-4/4/0/7/4/0/0.3888888889/0.2777777778", "3")).weight().degree() ==
        0);
  CHECK(is_on(curve_of(conic("0/1/0/0/0/-1/7/1/1/3/0.3333333333333333", "0")), {0, 1, 0, 0, 0, -1},
              7) == false);  // the end is rounded, and kept
  CHECK(is_on(curve_of(conic("0/1/0/0/0/-1/7/4/0.25/0.5/2", "2")), {0, 1, 0, 0, 0, -1}, 7));
  const auto refused = [&](const std::string& parameters, const std::string& form) {
    return test::refusal_of<InputError>([&] { conic(parameters, form); });
  };
  CHECK(test::contains(refused("0/1/0/0/0/-1/7/1/1/-2/-0.5", "2"), "not on one branch"));
  CHECK(test::contains(refused("0/1/0/0/0/-1/7/1/1/-2/-0.5", "1"), "it is no ellipse"));
  CHECK(test::contains(refused("0/1/0/0/0/-1/7/1/1.01/2/0.5", "2"), "an end is not on the curve"));
  CHECK(test::contains(refused("0/1/0/0/0/-1/7/1/1/2/0.5", "4"), "the form of a conic is 0 to 3"));
}

TEST_CASE("iges: other delimiters, exponents with D, parts, and what is not read") {
  const auto read_one = [](const std::string& type, const std::string& parameters) {
    return read(iges(type, parameters));
  };
  CHECK(curve_of(read_one("110", "110/0./1.5D0/0./3./4./0.!")) ==
        bezier_curve({{0, Rational(3, 2), 0}, {3, 4, 0}}));
  const NamedPath part =
      read_one("126", "126/2/2/0/0/1/0/0/0/0/2/2/2/1/1/1/0/0/0/1/2/0/4/0/0/1/2!");
  CHECK(point(curve_of(part), 0) == Vector<Rational>{Rational(3, 2), 1, 0});
  CHECK(point(curve_of(part), 1) == Vector<Rational>{4, 0, 0});
  const auto refused = [&](const std::string& type, const std::string& parameters) {
    return test::refusal_of<InputError>([&] { read_one(type, parameters); });
  };
  CHECK(refused("108", "108/1./0./1./0./0!") ==
        "line 1: there is no curve (126, 112, 110, 106, 104, 102, 100) by itself in the IGES file: "
        "it has 108");
  CHECK(refused("110", "110/0./1.5!") == "line 3: entity 110 (D1): there are too few parameters");
  CHECK(test::contains(refused("100", "100/0./0./0./1./0./0./2.!"), "an end is not on the curve"));
  CHECK(test::contains(refused("102", "102/1/1!"), "more than 32 deep"));
  CHECK(test::contains(refused("102", "102/1/5!"), "there is no D5"));
  CHECK(test::contains(refused("126", "126/2/2/0/0/1/0/0/0/0/2/2/2/1/1/1/0/0/0/1/2/0/4/0/0/1/3!"),
                       "from 1 to 3 is not between its knots"));
}

}  // namespace step_file_test
