#include "phrame/ph/along/path_totals.hpp"

#include <doctest/doctest.h>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/io/read/formula.hpp"
#include "phrame/io/read/number.hpp"
#include "phrame/ph/along/arc_length.hpp"
#include "phrame/ph/along/curvature.hpp"
#include "phrame/ph/along/path_angle.hpp"
#include "phrame/ph/along/path_length.hpp"
#include "phrame/ph/curve/bspline.hpp"
#include "phrame/ph/curve/end_point.hpp"
#include "phrame/ph/curve/identify.hpp"
#include "phrame/ph/curve/real_vector.hpp"
#include "phrame/ph/curve/shape.hpp"
#include "phrame/ph/curve/vector.hpp"
#include "support/curves.hpp"
#include "support/farouki_moon.hpp"
#include "support/paths.hpp"
#include "support/random.hpp"

namespace path_totals_test {

using namespace phrame;
using test::chain;
using test::cut;
using test::for_samples;
using test::Random;
using Terms = std::vector<PathTotal::Term>;

namespace {

/// Half of a screw: the tangent has a constant angle to an axis.
const Curve screw({{1}, {0, 1}, {0, 1}, {}});
/// √2 stands before its total curvature, whose value is known from the tests of totals.
const Curve oblique({{1, 1, -1}, {0, 1, -1}, {0, -1, 1}, {1, -1, 1}});

Path twisted_cubic() { return Path(RationalCurve({Polynomial{0, 1}, {0, 0, 1}, {0, 0, 0, 1}})); }

RationalCurve quarter(const Vector<Rational>& a, const Vector<Rational>& b) {
  return bezier_curve({a, {a[0] + b[0], a[1] + b[1], 0}, b}, {1, 1, 2});
}

Path circle() {
  return joined({quarter({1, 0, 0}, {0, 1, 0}), quarter({0, 1, 0}, {-1, 0, 0}),
                 quarter({-1, 0, 0}, {0, -1, 0}), quarter({0, -1, 0}, {1, 0, 0})});
}

std::string digits(const Real& x, long count = 25) { return round_to_decimal(x, count).value; }

const PathTotal& finite(const std::variant<PathTotal, Infinite>& total) {
  return std::get<PathTotal>(total);
}

void check_equal(const PathTotal& pieces, const Real& whole) {
  CHECK(digits(pieces.value, 50) == digits(whole, 50));
}

}  // namespace

TEST_CASE("path totals: pieces of a curve have the totals of the whole") {
  const auto check = [](const Curve& curve, const std::vector<Rational>& at) {
    const Path pieces(cut(curve, at));
    CHECK(pieces.segments().size() == at.size() + 1);
    check_equal(total_length(pieces), total_length(curve).value);
    check_equal(erf_twist(cut(curve, at)), erf_twist(curve).value);
    check_equal(total_torsion(pieces), total_torsion(curve).value);
    const auto energy = bending_energy(curve);
    check_equal(finite(bending_energy(pieces)), std::get<CurveTotal>(energy).value);
    const auto frenet = frenet_energy(curve);
    check_equal(finite(frenet_energy(pieces)), std::get<CurveTotal>(frenet).value);
    if (const auto curvature = total_curvature(curve))
      check_equal(total_curvature(pieces), curvature->value);
  };
  check(test::quintic, {Rational(1, 3)});
  check(test::quintic, {Rational(1, 7), Rational(1, 2), Rational(9, 10)});
  check(screw, {Rational(1, 3), Rational(1, 2)});
  check(oblique, {Rational(1, 3)});  // its curvature changes sign at 1/2
  check(Curve({{0, 3, 0, -1}, {0, 0, -3}, {}, {3}}, {Rational(1, 3)}), {Rational(2, 5)});
}

// κ ds = 2/(1 + t²) dt and κ² ds = 4/(1 + t²)³ dt on each of four segments: π/2 and 1 + 3π/8, those
// of f = 1/2 scaled alike.
TEST_CASE("path totals: of a closed plane curve, by hand") {
  const Path loop(test::closed_loop());
  CHECK(total_length(loop).value.exact() == Rational(16, 3));
  CHECK(erf_twist(test::closed_loop()).value.exact() == Rational(0));
  CHECK(total_torsion(loop).value.exact() == Rational(0));
  CHECK(total_curvature(loop).exact == Terms{{1, {0, 2, {}, {}}}});
  CHECK(absolute_rotation_index(loop).value().exact() == Rational(1));
  CHECK(finite(bending_energy(loop)).exact == Terms{{1, {4, Rational(3, 2), {}, {}}}});
}

// 3·2·arctan(√2t/(1 − t)) from 0 to 3π, about i − k, cut where the parts are no multiples of π.
TEST_CASE("path totals: the index of a path that turns one way is exact in any plane") {
  const QuaternionPolynomial turn{{1, -1}, {0, 1}, {}, {0, -1}};
  const Curve curve(turn * turn * turn * QuaternionPolynomial{{1}, {}, {}, {1}});
  const Path pieces(cut(curve, {Rational(1, 3), Rational(3, 4)}));
  CHECK(closed_form(total_curvature(pieces).segments[0])->radicand == 2);
  CHECK_FALSE(absolute_rotation_index(Path(pieces.segments()[0])).value().exact());
  CHECK(absolute_rotation_index(pieces).value().exact() == Rational(3, 2));
  // With a straight line between, which turns neither way.
  const Curve line({{1}, {}, {}, {}});
  const Curve left({{1}, {}, {}, {0, 1}});
  const Curve right({{1}, {}, {}, {0, -1}});
  const auto index = [](const std::vector<Curve>& curves) {
    return absolute_rotation_index(Path(chain(curves))).value();
  };
  CHECK(index({reversed(rotated(reversed(left), {1, 0, 0, 0})), rotated(line, {1, 0, 0, 1})})
            .exact() == Rational(1, 4));
  CHECK(index({line, left}).exact() == Rational(1, 4));
  CHECK(index({line, left, rotated(line, {1, 0, 0, 1}), rotated(right, {1, 0, 0, 1})}).exact() ==
        Rational(1, 2));
  CHECK(index({line, line}).exact() == Rational(0));
  CHECK_FALSE(absolute_rotation_index(Path(cut(test::quintic, {Rational(1, 2)}))));
}

// 2·arctan(1/2) and then 2·arctan(1/3) to the other side.
TEST_CASE("path totals: the index of a path that turns back is that of its parts") {
  const Curve left({{2}, {}, {}, {0, 1}});
  const Curve right =
      Curve(QuaternionPolynomial{{3}, {}, {}, {0, -1}} * QuaternionPolynomial{{2}, {}, {}, {1}});
  const Path path(chain({left, right}));
  CHECK(total_curvature(path).exact == Terms{{1, {0, Rational(1, 2), {}, {}}}});
  CHECK(absolute_rotation_index(path).value().exact() == Rational(1, 4));
}

// In a plane with the normal i − k and then in that of x and y: the tangent starts as j each time.
// 1.359347637816487748385570 + π/2.
TEST_CASE("path totals: the roots before the integrals of different segments may differ") {
  const Curve flat({{1, -1}, {}, {}, {1, 1}});
  const PathTotal total = total_curvature(Path(chain({oblique, flat})));
  CHECK(closed_form(total.segments[0])->radicand == 2);
  CHECK(closed_form(total.segments[1])->radicand == 1);
  CHECK(digits(total.value) == "2.930143964611384367616892");
}

TEST_CASE("path totals: an energy is infinite where that of a segment is") {
  const Curve cusp({{1}, {}, {0, 1}, {}}, {-1, 2});
  const Path path(
      chain({Curve({{1}, {}, {0, 1}, {}}, {-1}), Curve({{1}, {}, {1, 1}, {}}, {-2, 1})}));
  CHECK(std::holds_alternative<PathTotal>(bending_energy(path)));
  const Path stopped(cut(Curve({{1}, {}, {0, 1}, {}}, {-2, 4}), {Rational(1, 3)}));
  const auto energy = bending_energy(stopped);
  // 1/2 is at (1/2 − 1/3)/(2/3) = 1/4 of the second segment.
  CHECK(std::get<Infinite>(energy) == Infinite{Rational(5, 4), 1});
  CHECK(std::holds_alternative<Infinite>(frenet_energy(stopped)));
  CHECK(std::holds_alternative<Infinite>(bending_energy(cusp)));
  CHECK_THROWS_AS(total_torsion(Path(chain({Curve({{1}, {}, {}, {}}), screw}))), DomainError);
}

// ∫ |r′ × r″|/|r′|² dt by mpmath's quad.
TEST_CASE("path totals: the total curvature of a PH curve is known where κ is no rational one") {
  const Path path(cut(test::quintic, {Rational(1, 3)}));
  const PathTotal total = total_curvature(path);
  CHECK_FALSE(total.exact);
  CHECK(digits(total.value, 50) == "2.9120184674677409926484044075895557550120036190145");
  CHECK(digits(total_curvature(test::by_positions(cut(test::quintic, {}))).value, 50) ==
        digits(total.value, 50));
}

// A PH curve with κ ds = 2/(1 + t²) dt, a line and a quarter of a circle of radius 1, all turning
// left in one plane, as x(t), y(t) go from (0, 0) by (2/3, 1) and (2/3, 4) to (−1/3, 5).
TEST_CASE("path totals: segments of several kinds add up, exactly where they are known") {
  const Curve bend({{1}, {}, {}, {0, 1}});
  const Rational x(2, 3);
  std::vector<Segment> segments{PhSegment(bend), bezier_curve({{x, 1, 0}, {x, 4, 0}})};
  const Path two = joined(segments);
  CHECK(total_length(two).value.exact() == Rational(13, 3));
  CHECK(total_curvature(two).exact == Terms{{1, {0, Rational(1, 2), {}, {}}}});
  CHECK(absolute_rotation_index(two).value().exact() == Rational(1, 4));
  CHECK(finite(bending_energy(two)).exact == Terms{{1, {1, Rational(3, 8), {}, {}}}});
  CHECK_THROWS_AS(total_torsion(two), DomainError);
  segments.emplace_back(bezier_curve({{x, 4, 0}, {x, 5, 0}, {x - 1, 5, 0}}, {1, 1, 2}));
  const Path path = joined(segments);
  CHECK(closed_form(total_length(path).segments[0]) != nullptr);
  CHECK(std::get<Surd>(total_length(path).segments[1]) == Surd(3));
  CHECK(std::holds_alternative<Real>(total_length(path).segments[2]));
  CHECK_FALSE(total_length(path).exact);
  const Real quarter([](long bits) { return times_power_of_two(pi(bits), -1); });
  check_equal(total_length(path), quarter + Real(Rational(13, 3)));
  check_equal(total_curvature(path), quarter + quarter);
  CHECK(digits(finite(bending_energy(path)).value, 40) ==
        "3.748893571891069083654812960369565023673");  // 1 + 7π/8
  CHECK(absolute_rotation_index(path).value().exact() == Rational(1, 2));
}

// (t², t³) has the length (13√13 − 8)/27 up to t = 1, where its tangent is (2, 3)/√13.
TEST_CASE("path totals: lengths that are sums of square roots are added up as such") {
  const RationalCurve cubic({Polynomial{0, 0, 1}, {0, 0, 0, 1}, {}});
  const Path path = joined({cubic, bezier_curve({{1, 1, 0}, {3, 4, 0}})});
  CHECK(total_length(path).exact ==
        Terms{{1, {Rational(-8, 27), 0, {}, {}}}, {13, {Rational(40, 27), 0, {}, {}}}});
  CHECK(total_length(path).value.origin().is_irrational);
}

// An arc of parabola through (0, 0), (1, 0) and (2, 1) turns by π/4, and then back.
TEST_CASE("path totals: the index of a rational curve is exact where it turns one way") {
  const auto index = [](const std::vector<Segment>& segments) {
    return absolute_rotation_index(joined(segments)).value();
  };
  const RationalCurve left = bezier_curve({{0, 0, 0}, {1, 0, 0}, {2, 1, 0}});
  CHECK(index({left}).exact() == Rational(1, 8));
  const Real there_and_back = index({left, bezier_curve({{2, 1, 0}, {3, 2, 0}, {4, 2, 0}})});
  CHECK_FALSE(there_and_back.exact());
  CHECK(digits(there_and_back, 5) == "0.25000");
  const Real other = index({bezier_curve({{0, 0, 0}, {1, 0, 0}, {3, 1, 0}})});  // arctan 1/2
  CHECK(other.origin().is_irrational);
  CHECK(digits(other, 20) == "0.073791808825216637088");
  CHECK_FALSE(absolute_rotation_index(twisted_cubic()));
}

TEST_CASE("path totals: law: pieces of random curves have the totals of the whole") {
  for_samples(15, [](Random& random) {
    const Curve curve(random.quaternion_polynomial(2));
    if (line_direction(curve.preimage())) return;
    const PhPath cut_curve = cut(curve, {Rational(random.integer(1, 6), 7)});
    const Path pieces(cut_curve);
    check_equal(total_length(pieces), total_length(curve).value);
    check_equal(erf_twist(cut_curve), erf_twist(curve).value);
    check_equal(total_torsion(pieces), total_torsion(curve).value);
    const auto whole = bending_energy(curve);
    const auto energy = bending_energy(pieces);
    REQUIRE(whole.index() == energy.index());
    if (whole.index() == 0) check_equal(finite(energy), std::get<CurveTotal>(whole).value);
  });
}

TEST_CASE(
    "path totals: closed forms of a spline are found where they tell whether the sum is known") {
  const Path random = Path(cut(test::quintic, {Rational(1, 3), Rational(1, 2)}));
  for (const PathTotal& sum :
       {finite(bending_energy(random)), finite(frenet_energy(random)), total_torsion(random)}) {
    CHECK(closed_form(sum.segments[1]) == nullptr);
    CHECK(sum.value.origin().is_irrational);
    CHECK_FALSE(sum.exact);
    Real parts = Rational(0);
    for (const auto& of : sum.segments) parts = parts + value_of(of);
    CHECK(digits(parts, 40) == digits(sum.value, 40));
  }
  // Of a curve and its mirror image the torsions cancel.
  const Vector<Polynomial> h = hodograph(test::quintic);
  Path both(test::quintic);
  both.append(PhSegment(std::get<Curve>(identify({h[0], h[1], -h[2]}, end_point(test::quintic)))));
  const PathTotal none = total_torsion(both);
  CHECK(none.value.exact() == Rational(0));
  CHECK(closed_form(none.segments[0]) != nullptr);
}

TEST_CASE("path totals: the twisted cubic [mpmath: quad of the definitions]") {
  const Path path = twisted_cubic();
  CHECK(digits(total_length(path).value, 40) == "1.863022982512251394374780595207168197138");
  CHECK(digits(total_curvature(path).value, 40) == "1.450910899864031275661649070608977192011");
  CHECK(digits(total_torsion(path).value, 40) == "1.507278500292393126918601351905495484273");
  CHECK(digits(finite(bending_energy(path)).value, 40) ==
        "1.828426963311391191731029359327983399300");
  CHECK(digits(finite(frenet_energy(path)).value, 40) ==
        "4.277343296518597175317471301064697099343");
  // κ and τ at 1/2: |r′ × r″|/|r′|³ and det/|r′ × r″|².
  CHECK(digits(curvature(path, {0, Rational(1, 2)}), 30) == "0.952004740039499345894030721134");
  CHECK(torsion(path, {0, Rational(1, 2)}).exact() == Rational(12, 1) / Rational(61, 4));
}

TEST_CASE("path totals: a circle of four arcs") {
  const Path path = circle();
  const RealBall whole = times_power_of_two(pi(200), 1);
  CHECK(total_length(path).value.enclose(150).overlaps(whole));
  CHECK(total_curvature(path).value.enclose(150).overlaps(whole));
  CHECK(finite(bending_energy(path)).value.enclose(150).overlaps(whole));
  CHECK(total_torsion(path).value.exact() == Rational(0));
  CHECK(PathAngle(path).holonomy()->exact() == Rational(0));
  CHECK(curvature(path, {2, Rational(1, 3)}).exact() == Rational(1));
  // An eighth of the way: s = π/4 is no rational number; s = 1 is at the angle 1.
  const Place at = PathLength(path).point(2);
  CHECK(at.segment == 1);
  const Vector<Real> r = position(path, at);
  CHECK(r[0].enclose(100).overlaps(cos_sin(RealBall(2, 120), 120).cos));
  CHECK(r[1].enclose(100).overlaps(cos_sin(RealBall(2, 120), 120).sin));
  CHECK(r[1].enclose(100).is_accurate(80));
}

TEST_CASE("path totals: a closed path whose frame comes back turned [holonomy of its pieces]") {
  // Any closed path: θ from another up vector is the same up to whole turns.
  const RationalCurve loop =
      bezier_curve({{0, 0, 0}, {3, 1, 2}, {2, 4, -3}, {-2, 1, 4}, {-3, -1, -2}, {0, 0, 0}});
  const Path path(loop);
  REQUIRE(path.is_closed());
  const Real one = *PathAngle(path).holonomy();
  const Real other = *PathAngle(path, {5, -9, 11}).holonomy();
  CHECK(one.enclose(120).overlaps(other.enclose(120)));
  CHECK(one.enclose(120).is_accurate(110));
  CHECK_FALSE(PathAngle(twisted_cubic()).holonomy());
}

TEST_CASE("path totals: PH curves have the exact lengths of theirs") {
  for (const Curve& curve : {test::quintic, Curve({{1}, {0, 1}, {0, 1}, {}}, {-1, 2})}) {
    const Path path = test::by_positions(PhPath(curve));
    const PathLength length(path);
    const Real there = length.value({0, Rational(2, 3)});
    const Rational exact = *arc_length(curve, 0, Rational(1, 4)) +
                           (arc_length(curve, Rational(1, 4), Rational(1, 2)).value()) +
                           *arc_length(curve, Rational(1, 2), Rational(2, 3));
    CHECK(there.exact() == exact);
    const Place at = length.point(exact);
    CHECK(at.t.enclose(100).overlaps(RealBall(Rational(2, 3), 120)));
    CHECK(at.t.enclose(100).is_accurate(90));
  }
}

TEST_CASE("path totals: at a cusp the length goes on, the bending energy does not end") {
  // (t², t³) from −1/2 to 1/2: s = 2·((1 + 9/16)^{3/2} − 1)·8/27.
  const Polynomial t{Rational(-1, 2), 1};
  const Path path(RationalCurve({t * t, t * t * t, {}}));
  const Rational root = Rational(5, 4);
  CHECK(total_length(path).value.enclose(100).overlaps(
      RealBall(Rational(16, 27) * (root * root * root - 1), 120)));
  const auto energy = bending_energy(path);
  REQUIRE(std::holds_alternative<Infinite>(energy));
  CHECK(std::get<Infinite>(energy).pole == RealAlgebraic(Rational(1, 2)));
  CHECK_THROWS_AS(curvature(path, {0, Rational(1, 2)}), DomainError);
  CHECK_THROWS_AS(PathLength(path).point(2), DomainError);
}

TEST_CASE("path totals: an inflection adds to the curvature, whatever its side") {
  // y = x³ from −1 to 1: 2·arctan 3.
  const Polynomial x{-1, 2};
  const Path path(RationalCurve({x, x * x * x, {}}));
  const RealBall exact = multiply(RealBall(2, 130), argument(1, 3, 130), 130);
  CHECK(total_curvature(path).value.enclose(100).overlaps(exact));
  CHECK(total_curvature(path).value.enclose(100).is_accurate(90));
}

// mpmath: quad of |r′ × r″|/|r′|², with 30 digits; a quarter of an eight that starts at an
// inflection, and a curve with one in space, at s = 0.
TEST_CASE("path totals: curves by formulas bend through inflections") {
  const auto f = [](const char* text) { return parse_formula(text, "s").value; };
  const Path eight(ExpressionCurve({f("sin(s)"), f("sin(2*s)"), f("0")}, f("0"), f("2*pi")));
  CHECK(digits(total_curvature(eight).value, 8) == "10.711780");
  CHECK(total_torsion(eight).value.enclose(60).is_zero());
  CHECK(digits(finite(frenet_energy(eight)).value, 12) ==
        digits(finite(bending_energy(eight)).value, 12));
  const Path space(
      ExpressionCurve({f("s"), f("sin(s)^3"), f("sin(s)^3*cos(s) + s^4")}, f("-1"), f("1")));
  CHECK(digits(total_curvature(space).value, 7) == "3.274031");
  CHECK_THROWS_WITH_AS(total_torsion(space), doctest::Contains("0 at s = 0"), DomainError);
}

// An inflection, a line, and joints in the plane that turn on, or the other way, or out of it.
TEST_CASE("curvature: where the Frenet frame is continuous") {
  CHECK(has_continuous_frenet_frame(circle()));
  CHECK(has_continuous_frenet_frame(twisted_cubic()));
  CHECK_FALSE(has_continuous_frenet_frame(
      Path(bezier_curve({{0, 0, 0}, {1, 1, 0}, {2, -1, 0}, {3, 0, 0}}))));
  CHECK_FALSE(has_continuous_frenet_frame(Path(bezier_curve({{0, 0, 0}, {1, 1, 0}}))));
  const RationalCurve bend = bezier_curve({{0, 0, 0}, {1, 0, 0}, {2, 1, 0}});
  CHECK(
      has_continuous_frenet_frame(joined({bend, bezier_curve({{2, 1, 0}, {3, 2, 0}, {3, 4, 0}})})));
  CHECK_FALSE(
      has_continuous_frenet_frame(joined({bend, bezier_curve({{2, 1, 0}, {3, 2, 0}, {5, 3, 0}})})));
  CHECK_FALSE(
      has_continuous_frenet_frame(joined({bend, bezier_curve({{2, 1, 0}, {3, 2, 0}, {3, 4, 1}})})));
  // Where it closes, too: this loop's curvature jumps there.
  CHECK_FALSE(has_continuous_frenet_frame(
      Path(bezier_curve({{0, 0, 0}, {3, 1, 2}, {2, 4, -3}, {-2, 1, 4}, {-3, -1, -2}, {0, 0, 0}}))));
}

TEST_CASE("path totals: sums of many numbers are exact or as narrow as asked") {
  CHECK(sum_of(std::vector<Real>()).exact() == Rational(0));
  CHECK(sum_of(std::vector<Real>{Rational(1, 3), Rational(2, 3)}).exact() == Rational(1));
  const Real root = square_root_of(2);
  const Real sum = sum_of(std::vector<Real>(1000, root));
  const Real mixed = sum_of(std::vector<Real>{root, Rational(-1), root});
  CHECK(digits(sum, 30) == "1414.21356237309504880168872421");    // 1000√2
  CHECK(digits(mixed, 30) == "1.82842712474619009760337744842");  // 2√2 − 1
  // The joints of 300 lines of length √2: none is a rational length.
  std::vector<Segment> lines;
  for (long k = 0; k < 300; ++k) lines.emplace_back(bezier_curve({{k, k, 0}, {k + 1, k + 1, 0}}));
  const PathLength length(joined(lines));
  CHECK(total_length(joined(lines)).exact == Terms{{2, {300, 0, {}, {}}}});
  CHECK(digits(length.total(), 30) == "424.264068711928514640506617263");  // 300√2
  CHECK(length.point(200).segment == 141);
}

// mpmath's quad(), 45 digits. The Taylor series of one part ends much later than its first terms
// let expect, so that the part is halved once more.
TEST_CASE("path totals: a B-spline of degree 12 with a series that ends late") {
  const auto R = [](const char* number) { return parse_rational(number); };
  BSpline spline;
  spline.degree = 12;
  for (int k = 0; k < 13; ++k) spline.knots.emplace_back(0);
  spline.knots.emplace_back(19);
  for (int k = 0; k < 13; ++k) spline.knots.emplace_back(21);
  spline.points = {
      {R("-356/7"), R("-877/100"), R("570")},    {R("591"), R("-127/2"), R("-87/2")},
      {R("11/7"), R("-302/5"), R("-431/2")},     {R("147"), R("-128"), R("-33/4")},
      {R("354"), R("365/2"), R("-596/7")},       {R("-41/25"), R("-714"), R("-223/5")},
      {R("901"), R("135/2"), R("177")},          {R("-154"), R("-257"), R("117/50")},
      {R("-795/2"), R("-229/10"), R("-653/10")}, {R("-373/50"), R("39/10"), R("987/100")},
      {R("-309/10"), R("-166"), R("57/50")},     {R("-491/50"), R("298/7"), R("-27")},
      {R("-833"), R("-504"), R("678/7")},        {R("-755/2"), R("671"), R("849/10")}};
  Path path(bezier_curve(bezier_pieces(spline)[0].curve.points));
  path.append(bezier_curve(bezier_pieces(spline)[1].curve.points));
  const Real wanted = parse_rational("8.978687444597755580189025748377711");
  for (long bits = 96; bits <= 160; bits += 8) {
    const RealBall off =
        subtract(total_curvature(path).value.enclose(bits), wanted.enclose(200), 200);
    CHECK(absolute(off).upper() < power_of_two(8 - bits) + parse_rational("1e-33"));
  }
}

// Of long paths terms are kept as balls of few bits, and integrals are made again.
TEST_CASE("path totals: law: a long path of translated pieces has many times those of one") {
  const long count = test::everyday(300, 1100);
  const auto piece = [](long k) {
    const Vector<Rational> shift{3 * k, k, k};
    return bezier_curve({shift, shift + Vector<Rational>{1, 0, 0},
                         shift + Vector<Rational>{2, 1, 1}, shift + Vector<Rational>{3, 1, 1}});
  };
  Path path(piece(0), count);
  for (long k = 1; k < count; ++k) path.append(piece(k));
  const Path one(piece(0));
  const auto agrees = [&](const Real& sum, const Real& part) {
    for (const long bits : {60, 160}) {
      const RealBall expected = multiply(RealBall(Rational(count), 220), part.enclose(200), 220);
      CHECK(sum.enclose(bits).overlaps(expected));
      CHECK(sum.enclose(bits).is_accurate(bits - 16));
    }
  };
  agrees(total_curvature(path).value, total_curvature(one).value);
  agrees(finite(bending_energy(path)).value, finite(bending_energy(one)).value);
  agrees(total_length(path).value, total_length(one).value);
  const PathAngle angle(path, {0, 1, 2});
  const PathAngle part(one, {0, 1, 2});
  agrees(reference_twist(angle), reference_twist(part));
  for (const long k : {count - 1, 3L, 200L}) {
    const Real expected =
        Rational(k) * part.value({0, Rational(1)}) + part.value({0, Rational(1, 3)});
    CHECK(angle.enclose({static_cast<std::size_t>(k), Rational(1, 3)}, 80)
              .overlaps(expected.enclose(90)));
  }
}

}  // namespace path_totals_test
