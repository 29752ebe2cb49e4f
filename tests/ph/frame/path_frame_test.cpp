#include "phrame/ph/frame/path_frame.hpp"
#include "phrame/algebra/algebraic_point.hpp"

#include "phrame/algebra/error.hpp"
#include "phrame/ph/along/arc_length.hpp"
#include "support/curves.hpp"
#include "support/expression_curves.hpp"
#include "support/paths.hpp"
#include "support/random.hpp"

using namespace phrame;
using test::for_samples;
using test::quintic;
using test::Random;

namespace {

/// A = 1 + tk: r′ = (1 − t², 2t, 0), tangent (1 − t², 2t, 0)/(1 + t²).
const Curve plane({{1}, {}, {}, {0, 1}});

Place root(const Polynomial& p, const Interval& in) { return {0, real_root(p, in)}; }

/// The frames of one PH curve.
struct OfCurve {
  Path path;
  PathAngle angle;

  explicit OfCurve(const Curve& curve) : path(curve), angle(path) {}
  Frame<Real> euler_rodrigues(const Place& t) const { return euler_rodrigues_frame(path, t); }
  Frame<Real> frenet(const Place& t) const { return frenet_frame(path, t); }
  Frame<Real> rotation_minimizing(const Place& t) const {
    return rotation_minimizing_frame(angle, t);
  }
};

/// Not seen to be rational.
Place hidden(const Rational& t) {
  Place place(0, Real([t](long bits) { return RealBall(t, bits); }));
  place.algebraic = std::make_shared<const AlgebraicPoint>(RealAlgebraic(t));
  return place;
}

void check_near(const Vector<Real>& a, const Vector<Real>& b, const Rational& distance) {
  for (std::size_t k = 0; k < 3; ++k) {
    const RealBall difference = subtract(a[k].enclose(200), b[k].enclose(200), 200);
    CHECK(abs(difference.lower()) < distance);
    CHECK(abs(difference.upper()) < distance);
  }
}

Vector<Real> real(const Vector<Rational>& v) { return {v[0], v[1], v[2]}; }

void check_frame(const Vector<Real>& v, const std::array<const char*, 3>& expected) {
  for (std::size_t k = 0; k < 3; ++k) CHECK(round_to_decimal(v[k], 25).value == expected[k]);
}

}  // namespace

// mpmath, 50 digits: t by its root finder from quadrature of |r′|, θ by quadrature of −e₂′·e₃, n
// and b from numerical derivatives of the hodograph.
TEST_CASE("path frame: half way along the quintic of Farouki 2003") {
  const Place t(0, ArcLength(quintic).algebraic_parameter(Rational(71, 30)));
  const OfCurve frames(quintic);
  const auto rmf = frames.rotation_minimizing(t);
  check_frame(rmf.e1, {"-0.3330403726291162579534344", "0.2991900353124652952079518",
                       "0.8941864643175858094998478"});
  check_frame(rmf.e2, {"-0.9248051913202022048992536", "-0.2886018189036763199816684",
                       "-0.2478797051650130834070122"});
  check_frame(rmf.e3, {"0.1839007022995387769941454", "-0.9095022335845115378977071",
                       "0.3728085551573636111281197"});
  const auto frenet = frames.frenet(t);
  check_frame(frenet.e2, {"-0.8434130617181720377099963", "0.3294860547741283852844979",
                          "-0.4243740649857846752157198"});
  check_frame(frenet.e3, {"-0.4215904618492196339185641", "-0.8955022403540405655741740",
                          "0.1426086252603812361722378"});
}

TEST_CASE("path frame: law: at a rational t given by its polynomial it is what Frames says") {
  for_samples(30, [](Random& random) {
    const Curve curve(random.quaternion_polynomial(3));
    const Rational t(random.integer(-8, 8), 5);
    const Place point = hidden(t);
    const OfCurve algebraic(curve);
    const Frames frames(curve);
    const Rational tiny = parse_rational("1e-40");
    const auto erf = frames.euler_rodrigues(t);
    CHECK(algebraic.euler_rodrigues(point).e2[1].exact() == erf.e2[1]);
    check_near(algebraic.euler_rodrigues(point).e3, real(erf.e3), tiny);
    RmfAngle angle(curve, Reference::euler_rodrigues);
    const auto rmf = frames.rotation_minimizing(angle, t);
    check_near(algebraic.rotation_minimizing(point).e2, rmf.e2, tiny);
    check_near(algebraic.rotation_minimizing(point).e3, rmf.e3, tiny);
    const GaussianPolynomial g = bend_numerator(curve.preimage());
    if (norm(g)(t) == 0) return;
    check_near(algebraic.frenet(point).e2, frames.frenet(t).e2, tiny);
    check_near(algebraic.frenet(point).e3, frames.frenet(t).e3, tiny);
  });
}

TEST_CASE("path frame: law: it is continuous: next to an irrational t it is nearly the same") {
  for_samples(20, [](Random& random) {
    const Curve curve(random.quaternion_polynomial(3));
    const Place point = root({-random.integer(2, 3), 0, 0, 1}, {Rational(0), {}});
    const Rational t = point.t.enclose(200).lower();
    if (norm(bend_numerator(curve.preimage()))(t) < Rational(1, 1000)) return;
    const OfCurve algebraic(curve);
    const Frames frames(curve);
    RmfAngle angle(curve, Reference::euler_rodrigues);
    const Rational small = parse_rational("1e-20");
    const auto rmf = frames.rotation_minimizing(angle, t);
    check_near(algebraic.rotation_minimizing(point).e1, rmf.e1, small);
    check_near(algebraic.rotation_minimizing(point).e2, rmf.e2, small);
    check_near(algebraic.rotation_minimizing(point).e3, rmf.e3, small);
    check_near(algebraic.frenet(point).e2, frames.frenet(t).e2, small);
    check_near(algebraic.frenet(point).e3, frames.frenet(t).e3, small);
  });
}

// At t = 1/√2 the tangent is (1/2, √2, 0)/(3/2).
TEST_CASE("path frame: components that are rational at an irrational t are exact") {
  const Place t = root({-1, 0, 2}, {Rational(0), {}});
  const OfCurve frames(plane);
  const auto erf = frames.euler_rodrigues(t);
  CHECK(erf.e1[0].exact() == Rational(1, 3));
  CHECK_FALSE(erf.e1[1].exact().has_value());
  CHECK(erf.e1[2].exact() == 0);
  // Its ERF is rotation-minimizing.
  CHECK(frames.rotation_minimizing(t).e2[1].exact() == Rational(1, 3));
  CHECK(frames.rotation_minimizing(t).e3[2].exact() == 1);
  // n is the tangent turned to the left, b = k.
  const auto frenet = frames.frenet(t);
  CHECK(frenet.e2[1].exact() == Rational(1, 3));
  CHECK(frenet.e2[0].enclose(64).upper() < 0);
  CHECK(frenet.e3[2].exact() == 1);
}

TEST_CASE("path frame: Frenet is refused on a line and at an irrational inflection") {
  const Place t = root({-1, 0, 2}, {Rational(0), {}});
  const OfCurve line(Curve({{1, 1}, {}, {}, {}}));
  CHECK_THROWS_WITH_AS(line.frenet(t), doctest::Contains("straight line"), DomainError);
  // A = 1 + (2t³/3 − t)k: g = 2t² − 1.
  const OfCurve inflected(Curve({{1}, {}, {}, {0, -1, 0, Rational(2, 3)}}));
  CHECK_THROWS_WITH_AS(inflected.frenet(t), doctest::Contains("inflection"), DomainError);
  CHECK_NOTHROW(inflected.rotation_minimizing(t));
}

TEST_CASE("path frame: through an irrational cusp by continuity") {
  const Polynomial c{-1, 0, 2};
  const Curve smooth({{1}, {0, 1}, {2}, {0, 0, 1}});
  const Curve cusped({c, c * Polynomial{0, 1}, Rational(2) * c, c * Polynomial{0, 0, 1}});
  const Place t = root(c, {Rational(0), {}});
  const OfCurve a(smooth);
  const OfCurve b(cusped);
  check_near(a.rotation_minimizing(t).e2, b.rotation_minimizing(t).e2, parse_rational("1e-40"));
  check_near(a.frenet(t).e3, b.frenet(t).e3, parse_rational("1e-40"));
}

namespace {

void check_equal(const Frame<Real>& a, const Frame<Real>& b) {
  CHECK(round_to_double(a.e1) == round_to_double(b.e1));
  CHECK(round_to_double(a.e2) == round_to_double(b.e2));
  CHECK(round_to_double(a.e3) == round_to_double(b.e3));
}

}  // namespace

// Other ways: the antiderivative itself at an algebraic number, and Frames at a rational one.
TEST_CASE("path frame: the rotation-minimizing one at t of any kind as other ways have it") {
  const OfCurve moving(quintic);
  const RmfAngle angle(quintic);
  const Evaluator antiderivative(angle.angle_to_erf(), angle.rate());
  for (const Polynomial& p : {Polynomial{-1, 0, 2}, Polynomial{-1, 0, 0, 3}}) {
    const RealAlgebraic t = real_root(p, Interval{0, 1});
    const Real theta([&](long bits) { return antiderivative.branch_difference(0, t, bits + 8); });
    const Frame<Real> expected = turned(moving.euler_rodrigues({0, t}), theta);
    check_equal(moving.rotation_minimizing({0, t}), expected);
    // The same number, as if it were transcendental.
    check_equal(moving.rotation_minimizing({0, to_real(t)}), expected);
    CHECK(round_to_double(tangent(moving.path, {0, to_real(t)})) == round_to_double(expected.e1));
  }
  const Rational third(1, 3);
  check_equal(moving.rotation_minimizing({0, third}),
              rotation_minimizing_frame(quintic, angle, third));
}

// f₂ = −e₂ where the angle is π.
TEST_CASE("path frame: the rotation-minimizing one starts as it is told") {
  const OfCurve moving(quintic);
  const Frame<Rational> erf = euler_rodrigues_frame(quintic, 0);
  const Frame<Real> start = rotation_minimizing_frame(moving.angle, {0, Rational(0)}, Angle(1, 0));
  for (std::size_t k = 0; k < 3; ++k) CHECK(start.e2[k].exact() == Rational(-erf.e2[k]));
}

// α = 1 + it, β = 2(1 − it): |α|² − |β|² = −3/5·σ.
TEST_CASE("path frame: a component of e1 that is constant is exact at any t") {
  const Path helix(Curve({{1}, {0, 1}, {0, -2}, {2}}));
  const Place anywhere(0, Real([](long bits) { return RealBall(Rational(1, 3), bits); }));
  CHECK(tangent(helix, anywhere)[0].exact() == Rational(-3, 5));
  CHECK(euler_rodrigues_frame(helix, anywhere).e1[0].exact() == Rational(-3, 5));
  CHECK_FALSE(tangent(helix, anywhere)[1].exact().has_value());
}

// Two ways: the Euler–Rodrigues frame is carried by the choice of preimages, that of a vector is
// not.
TEST_CASE("path frame: law: through corners by preimages and by positions it is the same") {
  Random random(88);
  for (int k = 0; k < 12; ++k) {
    const auto quadratic = [&] {
      return Polynomial{random.integer(1, 5), random.integer(-5, 5), random.integer(-5, 5)};
    };
    std::vector<Curve> curves;
    for (int j = 0; j < 3; ++j)
      curves.emplace_back(QuaternionPolynomial{quadratic(), quadratic(), quadratic(), quadratic()});
    const PhPath ph = test::chain(curves);
    CHECK(ph.corners().size() == 2);
    const PathAngle by_preimage{Path(ph)};
    const Path positions = test::by_positions(ph);
    CHECK(positions.corners() == ph.corners());
    const PathAngle by_points(positions);
    const StartAngle start = start_angle(LeastRotation{}, by_preimage);
    const StartAngle other = start_angle(LeastRotation{}, by_points);
    for (const Rational& t :
         {Rational(1, 3), Rational(1), Rational(5, 3), Rational(2), Rational(3)}) {
      const Place at = locate(positions, t);
      const Frame<Real> f = rotation_minimizing_frame(by_preimage, at, start);
      const Frame<Real> g = rotation_minimizing_frame(by_points, at, other);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        CHECK(f.e1[axis].enclose(90).overlaps(g.e1[axis].enclose(90)));
        CHECK(f.e2[axis].enclose(90).overlaps(g.e2[axis].enclose(90)));
        CHECK(f.e3[axis].enclose(90).overlaps(g.e3[axis].enclose(90)));
      }
    }
  }
}

// A circular arc has the tangents of the least rotation, whatever its radius.
TEST_CASE("path frame: behind a corner it is what it is behind an arc that rounds the corner") {
  const auto rounded = [](const std::string& r) {
    const auto piece = [](const std::string& x, const std::string& y, const char* to) {
      return Segment(test::expression_curve({x.c_str(), y.c_str(), "0"}, "0", to));
    };
    return joined({piece("(1 - " + r + ")*s", "0", "1"),
                   piece("1 - " + r + " + " + r + "*sin(s)", r + " - " + r + "*cos(s)", "pi/2"),
                   piece("1", r + " + (1 - " + r + ")*s", "1")});
  };
  const Path corner = test::polygon({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}});
  const Vector<Rational> v{1, 2, 5};
  const RealBall theta = PathAngle(corner, v).enclose({1, Rational(1)}, 100);
  CHECK_FALSE(theta.contains_zero());
  for (const char* radius : {"1/2", "1/1000", "sqrt(2)/10^9"})
    CHECK(PathAngle(rounded(radius), v).enclose({2, Rational(1)}, 100).overlaps(theta));
  CHECK(PathAngle(corner, {0, 0, 1}).is_zero());
}
