#include <doctest/doctest.h>

#include "phrame/algebra/rounding.hpp"
#include "phrame/integrate/definite_integral.hpp"
#include "phrame/ph/along/path_angle.hpp"
#include "phrame/ph/along/path_length.hpp"
#include "phrame/ph/along/path_totals.hpp"
#include "phrame/ph/along/rmf_angle.hpp"
#include "phrame/ph/curve/end_point.hpp"
#include "phrame/ph/curve/identify.hpp"
#include "phrame/ph/curve/rational_ph.hpp"
#include "phrame/ph/curve/transform.hpp"
#include "support/expression_curves.hpp"
#include "support/random.hpp"
#include "support/rational_curves.hpp"
#include "support/refusal.hpp"

namespace whole_line_test {
namespace {

using namespace phrame;
using test::for_samples;
using test::Random;

const Polynomial one_and_square{1, 0, 1};

/// Closed curves without cusps, but for the last, which has four, and f(−1) < 0: without
/// logarithms, since n was solved for that. m = 2, 3 and 2, deg W = 4, 10 and 8.
Curve quartic() {
  return rational_ph_curve({{1}, {-1, -1, 1}, {-1, 1}, {0, 1, -1}},
                           {Polynomial{1}, pow(one_and_square, 3)});
}
Curve of_degree_10() {
  return rational_ph_curve({{1, -2, 1}, {-1, 1, -1, 1}, {-1, 0, 1, -2}, {1, 2, 1}},
                           {Polynomial{25, -56, 42, 58, 21}, pow(one_and_square, 6)}, {1, 2, 3});
}
Curve with_cusps() {
  return rational_ph_curve({{1}, {0, 1}, {}, {0, 0, 1}},
                           {Polynomial{3, 0, -10, 0, 3}, pow(one_and_square, 5)});
}

bool agree(const Real& a, const Real& b) { return a.enclose(192).overlaps(b.enclose(192)); }

double holonomy(const Path& path) { return round_to_double(PathAngle(path).holonomy().value()); }

/// ∫ −2h/σ dt over all t, by residues.
DefiniteIntegral turn_of_line(const Curve& curve) {
  return definite_integral(rate_to_erf(curve.preimage()), Infinity::negative, Infinity::positive);
}

Vector<Rational> point_at(const Path& path, std::size_t k, const Rational& s) {
  return point(*rational_curve(path.segments()[k]), s);
}

}  // namespace

TEST_CASE("whole line: the points are those of all t, and ∞ is in the middle of the second half") {
  const Curve curve = of_degree_10();
  const Path whole = whole_line(Path(curve));
  REQUIRE(whole.segments().size() == 2);
  CHECK(whole.is_closed());
  CHECK(whole.has_erf());
  CHECK(whole.corners().empty());
  const Vector<Polynomial> X = numerator(curve);
  for (const Rational& s : {Rational(0), Rational(1, 3), Rational(3, 4), Rational(1)}) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Rational t = 2 * s - 1;
      const Rational far = 1 / (1 - 2 * s);
      CHECK(point_at(whole, 0, s)[k] == X[k](t) / curve.weight()(t));
      CHECK(point_at(whole, 1, s)[k] == X[k](far) / curve.weight()(far));
    }
  }
  for (std::size_t k = 0; k < 3; ++k)
    CHECK(point_at(whole, 1, Rational(1, 2))[k] ==
          X[k].coefficient(10) / curve.weight().coefficient(10));
}

// The astroid (cos³φ, sin³φ), t = tan(φ/2), has cusps at t = 0, ±1 and ∞, and is 6 long.
TEST_CASE("whole line: it is cut where there is no cusp") {
  const RationalCurve astroid({Polynomial{1, 0, -3, 0, 3, 0, -1}, Polynomial{0, 0, 0, 8}, {}},
                              {1, 0, 3, 0, 3, 0, 1});
  const Path whole = whole_line(Path(std::get<Curve>(identify(astroid))));
  CHECK(point_at(whole, 0, 0)[0] == Rational(-27, 125));  // cos φ = −3/5 at t = −2
  CHECK(point_at(whole, 0, Rational(3, 4)) == Vector<Rational>{0, 1, 0});
  CHECK(point_at(whole, 1, Rational(1, 2)) == Vector<Rational>{-1, 0, 0});
  CHECK(*total_length(whole).value.exact() == 6);
}

TEST_CASE("whole line: the Euler–Rodrigues frame goes on and comes back as it was") {
  for (const Curve& curve : {quartic(), of_degree_10(), with_cusps(), test::quarter_circle()}) {
    const Path whole = whole_line(Path(curve));
    REQUIRE(whole.closing_turn());
    CHECK(whole.closing_turn()->im == 0);
    const Curve& first = *ph_curve(whole.segments()[0]);
    const Curve& second = *ph_curve(whole.segments()[1]);
    CHECK(evaluate(first.preimage(), 1) == evaluate(second.preimage(), 0));
    // dr/ds is continuous: the multiplier over W² at both ends.
    const auto rate = [](const Curve& of, long t) {
      return Rational(of.multiplier()(t) / (of.weight()(t) * of.weight()(t)));
    };
    CHECK(rate(first, 1) == rate(second, 0));
    CHECK(rate(first, 0) == rate(second, 1));
  }
}

// The values: parallel transport of a normal by the least rotations between 20 000 and 40 000
// tangents e₁(tan s), in doubles, and Richardson's extrapolation, to 12 digits. The lengths are
// ∫ n·σ/(1 + t²)ᵏ dt by the trapezoidal rule for t = tan s, which is exact for them.
TEST_CASE("whole line: holonomy by parallel transport, and length") {
  CHECK(holonomy(whole_line(Path(quartic()))) == doctest::Approx(2.48851339537653).epsilon(1e-12));
  CHECK(holonomy(whole_line(Path(of_degree_10()))) ==
        doctest::Approx(0.87994829653681).epsilon(1e-12));
  // Here e₁ = r′/|r′| is −A i A*/σ at the start: the turn about A i A* is 2π − 2√3/3·π.
  CHECK(holonomy(whole_line(Path(with_cusps()))) ==
        doctest::Approx(-2.65558657871110).epsilon(1e-12));
  const auto pi_multiple = [](const Curve& curve) {
    return total_length(whole_line(Path(curve))).exact.value().front().of.pi;
  };
  CHECK(pi_multiple(quartic()) == 2);
  CHECK(pi_multiple(of_degree_10()) == 86);  // 270.1769682087222 by that rule
}

TEST_CASE("whole line: holonomy is the sum of residues, and total torsion that of the line") {
  for (const Curve& curve : {quartic(), of_degree_10()}) {
    const Path whole = whole_line(Path(curve));
    const PathAngle to_erf(whole, Reference::euler_rodrigues);
    CHECK(agree(to_erf.value(2), turn_of_line(curve).value));
  }

  const Path whole = whole_line(Path(quartic()));
  const Path turned = whole_line(Path(segment(quartic(), -5, 7)));
  CHECK(agree(total_torsion(whole).value, total_torsion(turned).value));
}

TEST_CASE("whole line: it is the same from any part of the curve, in either direction") {
  const Path whole = whole_line(Path(quartic()));
  const double turn = holonomy(whole);
  const Real energy = std::get<PathTotal>(bending_energy(whole)).value;
  for_samples(4, [&](Random& random) {
    const Rational a = random.rational();
    const Rational b = a + random.integer(1, 3) * (random.integer(0, 1) == 0 ? 1 : -1);
    const Path other = whole_line(Path(segment(quartic(), a, b)));
    CHECK(holonomy(other) == doctest::Approx(turn).epsilon(1e-14));
    CHECK(agree(total_length(other).value, total_length(whole).value));
    CHECK(agree(std::get<PathTotal>(bending_energy(other)).value, energy));
  });
}

TEST_CASE("whole line: an arc is a part of a circle, whatever factor its weight has") {
  for (const Curve& arc :
       {test::quarter_circle(), test::with_factor(test::quarter_circle(), Polynomial{1, 1})}) {
    const Path circle = whole_line(Path(arc));
    CHECK(circle.is_closed());
    CHECK(total_length(circle).exact.value().front().of.pi == 2);
    CHECK(PathAngle(circle).holonomy().value().exact() == Rational(0));
  }
}

TEST_CASE("whole line: of curves that are not PH, too") {
  // 2(1 − t²), 2t over 1 + t²: half axes 2 and 1.
  const RationalCurve arc({Polynomial{2, 0, -2}, Polynomial{0, 2}, {}}, one_and_square);
  const Path ellipse = whole_line(Path(Segment(arc)));
  CHECK(ellipse.is_closed());
  CHECK(!ellipse.has_erf());
  // 8·E(√3/2), by tables.
  CHECK(round_to_double(total_length(ellipse).value) == doctest::Approx(9.688448220547676));
  // One cusp, at t = 0: the side of e₁ changes once.
  const RationalCurve odd({Polynomial{0, 0, 2}, Polynomial{0, 0, 0, 1}, {}},
                          pow(one_and_square, 2));
  const Path cusp = whole_line(Path(Segment(odd)));
  CHECK(cusp.ends_meet());
  CHECK(!cusp.is_closed());
}

TEST_CASE("whole line: what goes to infinity is refused, saying where") {
  const auto refusal = [](const Path& path) {
    return test::refusal_of<DomainError>([&] { whole_line(path); });
  };
  CHECK(refusal(Path(Curve({{1}, {}, {}, {0, 1}}))) ==
        "whole line: the curve is polynomial: it goes to infinity and does not come back");
  CHECK(refusal(Path(
            Segment(RationalCurve({Polynomial{1}, Polynomial{0, 1}, {}}, Polynomial{2, 1})))) ==
        "whole line: the curve goes to infinity at t = -2");
  CHECK(
      refusal(Path(Segment(
          RationalCurve({Polynomial{0, 0, 0, 1}, Polynomial{0, 1}, {}}, one_and_square)))) ==
      "whole line: the curve goes to infinity at t = infinity: degree 3 over a weight of degree 2");
  CHECK(refusal(whole_line(Path(quartic()))) ==
        "whole line: a path of 2 curves is not one for all t");
  CHECK(refusal(Path(Segment(test::torus_knot(2, 3)))) ==
        "whole line: a curve by formulas is on its interval alone");
}

}  // namespace whole_line_test
