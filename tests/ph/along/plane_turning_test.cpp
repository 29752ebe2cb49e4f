#include "phrame/ph/along/plane_turning.hpp"

#include <cmath>

#include "phrame/algebra/argument.hpp"
#include "phrame/io/read/any_path.hpp"
#include "phrame/ph/curve/complex_form.hpp"
#include "phrame/ph/curve/invariants.hpp"
#include "phrame/ph/curve/special_points.hpp"
#include "support/curves.hpp"
#include "support/random.hpp"

namespace plane_turning_test {

using namespace phrame;
using test::for_samples;
using test::Random;
using Kind = CurvaturePlace::Kind;

namespace {

const Vector<Rational> up{0, 0, 1};

std::vector<CurvaturePlace> places_of(const Vector<Polynomial>& r) {
  return curvature_places(RationalCurve(r), up);
}

double number(const CurvaturePlace& place) { return approximate(place.curvature.enclose(64)); }

std::optional<Real> index_of(const std::string& file) {
  return rotation_index(read_any_path(file).path);
}

std::optional<Rational> index_of_formulas(const std::string& x, const std::string& y,
                                          const std::string& to) {
  return index_of(R"({"phrame": "curve/1", "expressions": {"x": ")" + x + R"(", "y": ")" + y +
                  R"(", "variable": "s"}, "from": 0, "to": ")" + to + R"("})")
      .value()
      .exact();
}

}  // namespace

// y = x³ with x = 2t − 1 has κ = 6x/(1 + 9x⁴)^{3/2}, with extrema at 45x⁴ = 1; y = x⁴ has κ ≥ 0,
// and 0 at x = 0 only; the greatest curvature of y = x² is 2.
TEST_CASE("curvature places: extrema and inflections of y = x², x³, x⁴") {
  const Polynomial x{-1, 2};
  const auto cubic = places_of({x, pow(x, 3), {}});
  REQUIRE(cubic.size() == 3);
  CHECK(cubic[0].kind == Kind::least);
  CHECK(cubic[1].kind == Kind::inflection);
  CHECK(cubic[1].t == RealAlgebraic(Rational(1, 2)));
  CHECK(cubic[2].kind == Kind::greatest);
  const double at = std::pow(45, -0.25);
  CHECK(number(cubic[2]) == doctest::Approx(6 * at / std::pow(1.2, 1.5)));
  CHECK(number(cubic[0]) == doctest::Approx(-6 * at / std::pow(1.2, 1.5)));
  const auto parabola = places_of({x, x * x, {}});
  REQUIRE(parabola.size() == 1);
  CHECK(parabola[0].kind == Kind::greatest);
  CHECK(parabola[0].curvature.exact() == Rational(2));
  const auto downwards = places_of({x, -x * x, {}});
  REQUIRE(downwards.size() == 1);
  CHECK(downwards[0].kind == Kind::least);
  const auto flat = places_of({x, pow(x, 4), {}});
  REQUIRE(flat.size() == 3);
  CHECK(flat[0].kind == Kind::greatest);
  CHECK(flat[1].kind == Kind::least);
  CHECK(flat[1].curvature.exact() == Rational(0));
  CHECK(places_of({x * x, x * x * x, {}}).empty());    // a cusp
  CHECK(places_of({x, Rational(2) * x, {}}).empty());  // a line
  CHECK(curvature_places(RationalCurve({Polynomial{1, 0, -1}, Polynomial{0, 2}, Polynomial()},
                                       Polynomial{1, 0, 1}),
                         up)
            .empty());
}

// By the other way, κ = 2ω/(fσ²) as a rational function.
TEST_CASE("curvature places: law: those of a PH curve are the zeros of κ and the turns of κ") {
  for_samples(15, [](Random& random) {
    const GaussianPolynomial w = random.gaussian_polynomial(1 + random.integer(0, 2));
    if (is_zero(w)) return;
    const Curve curve(from_complex_root(w));
    if (rho(curve.preimage()).is_zero()) return;
    const RationalFunction kappa = signed_curvature(curve);
    const RationalFunction slope = differentiate(kappa);
    std::size_t inflections = 0;
    std::size_t extrema = 0;
    for (const CurvaturePlace& place : curvature_places(PhSegment(curve), up)) {
      (place.kind == Kind::inflection ? inflections : extrema)++;
      const Polynomial& zero =
          place.kind == Kind::inflection ? kappa.numerator() : slope.numerator();
      CHECK(sign_at(zero, place.t) == 0);
      if (place.kind != Kind::inflection) {
        const Polynomial second = differentiate(slope).numerator();
        if (sign_at(second, place.t) != 0)
          CHECK((sign_at(second, place.t) * sign_at(differentiate(slope).denominator(), place.t) >
                 0) == (place.kind == Kind::least));
      }
      const RealBall value = evaluate(kappa, enclose(place.t, 200), 200);
      CHECK(value.overlaps(place.curvature.enclose(200)));
    }
    const auto count = [](const Polynomial& p) {
      return odd(real_roots(p, open_interval(0, 1))).size();
    };
    if (count_real_roots(sigma(curve.preimage()), closed_interval(0, 1)) > 0) return;
    CHECK(inflections == count(kappa.numerator()));
    CHECK(extrema == (slope.numerator().is_zero() ? 0 : count(slope.numerator())));
  });
}

TEST_CASE("rotation index: circles, loops, polygons, and what is in no plane") {
  CHECK(index_of_formulas("cos(s)", "sin(s)", "2*pi") == Rational(1));
  CHECK(index_of_formulas("cos(s)", "-sin(s)", "2*pi") == Rational(-1));
  CHECK(index_of_formulas("cos(s)", "sin(s)", "3*pi") == Rational(3, 2));
  CHECK(index_of_formulas("sin(2*s)", "sin(s)", "2*pi") == Rational(0));
  CHECK(index_of_formulas("(1+2*cos(s))*cos(s)", "(1+2*cos(s))*sin(s)", "2*pi") == Rational(2));
  CHECK(index_of("M0 0 L4 0 L4 3 Z")->exact() == Rational(1));
  CHECK(index_of("M0 0 L4 3 L4 0 Z")->exact() == Rational(-1));
  CHECK(index_of("M0 3 L2 -3 L-3 1 L3 1 L-2 -3 Z")->exact() == Rational(-2));  // a pentagram
  CHECK(index_of("M0 0 L4 0 L4 3")->exact() == Rational(1, 4));
  CHECK(index_of("M0 0 L4 0")->exact() == Rational(0));
  CHECK_FALSE(rotation_index(Path(test::quintic)));
  CHECK(upper_normal(Path(RationalCurve({Polynomial{0, 1}, Polynomial{0, 0, 1},
                                         Polynomial{0, -2}}))) == Vector<Rational>{2, 0, 1});
}

// φ = 2·arg w, whose whole turns are counted by Sturm's theorem there.
TEST_CASE("rotation index: law: of r′ = w² it is 2·(arg w(1) − arg w(0))/2π") {
  for_samples(25, [](Random& random) {
    const GaussianPolynomial w = random.gaussian_polynomial(1 + random.integer(0, 5));
    if (is_zero(w)) return;
    if (!gcd(w.re, w.im).is_constant()) return;
    const Real index = rotation_index(Path(Curve(from_complex_root(w)))).value();
    const RealBall turn = divide(ContinuousArgument(w).difference(1, 128), pi(128), 128);
    const RealBall difference = subtract(turn, index.enclose(128), 128);
    CHECK(difference.contains_zero());
    CHECK(upper_double(absolute(difference)) < 1e-20);
  });
}

}  // namespace plane_turning_test
