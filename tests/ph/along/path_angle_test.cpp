#include "phrame/ph/along/path_angle.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <numbers>

#include "phrame/algebra/algebraic_angle.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/io/read/any_path.hpp"
#include "phrame/io/read/curve_file.hpp"
#include "phrame/ph/along/curvature.hpp"
#include "phrame/ph/along/path_totals.hpp"
#include "phrame/ph/along/up_vector.hpp"
#include "phrame/ph/curve/identify.hpp"
#include "phrame/ph/frame/frame.hpp"
#include "phrame/ph/frame/path_frame.hpp"
#include "support/curves.hpp"
#include "support/data.hpp"
#include "support/paths.hpp"
#include "support/random.hpp"

using namespace phrame;
using test::chain;
using test::for_samples;
using test::quarters;
using test::Random;

namespace {

/// The same curve with another Euler–Rodrigues frame: A·c, f/|c|².
Curve with_other_frame(const Curve& curve, const RationalQuaternion& c) {
  const QuaternionPolynomial factor{{c.u}, {c.v}, {c.p}, {c.q}};
  const bool turns_over = c.u == 0 && c.v == 0;
  const Polynomial scale{(turns_over ? -1 : 1) / norm(c)};
  return Curve(curve.preimage() * factor, scale * curve.multiplier(), curve.start());
}

/// r′ = (1 − t²)a + 2tb for unit vectors a ⟂ b of the axes: from direction a to direction b in
/// their plane.
Curve plane_quarter(const Vector<Rational>& a, const Vector<Rational>& b) {
  Vector<Polynomial> r;
  for (std::size_t k = 0; k < 3; ++k) r[k] = Polynomial{a[k], 2 * b[k], -a[k]};
  return std::get<Curve>(identify(r));
}

const Vector<Rational> x{1, 0, 0};
const Vector<Rational> y{0, 1, 0};
const Vector<Rational> z{0, 0, 1};
const Vector<Rational> minus_x{-1, 0, 0};
const Vector<Rational> minus_y{0, -1, 0};
const Vector<Rational> minus_z{0, 0, -1};

PhPath through(const std::vector<Vector<Rational>>& directions) {
  std::vector<Curve> curves;
  for (std::size_t k = 0; k < directions.size(); ++k)
    curves.push_back(plane_quarter(directions[k], directions[(k + 1) % directions.size()]));
  return chain(curves);
}

Vector<double> second_vector(PathAngle& angle, const Rational& t) {
  const PathParameter at = locate(angle.path(), t);
  const Curve& curve = *ph_curve(angle.path().segments()[at.segment]);
  return round_to_double(turned(as_real(euler_rodrigues_frame(curve, at.t)), angle.value(t)).e2);
}

std::string digits(const Real& value) { return round_to_decimal(value, 15).value; }

}  // namespace

// A normal carried along by the differential equation f′ = −(f·e₁′)e₁, solved by mpmath's Taylor
// series method to 18 digits.
TEST_CASE("spline: the frame is carried through the joints of a closed spline in space") {
  PathAngle angle(chain(quarters()));
  CHECK(second_vector(angle, 0) == Vector<double>{0, 1, 0});
  CHECK(second_vector(angle, 1) == Vector<double>{-0.96017767574763922, 0, 0.279390105400784369});
  CHECK(second_vector(angle, 2) == Vector<double>{0, -0.843882338008277201, 0.536528284061226159});
  CHECK(second_vector(angle, 3) == Vector<double>{0.660376288078903314, 0, 0.750934856124770187});
  CHECK(second_vector(angle, 4) == Vector<double>{0, 0.424274800804632424, 0.905533485522313237});
  CHECK(digits(angle.holonomy().value()) == "1.13263544456407");
}

TEST_CASE("spline: neither frame nor holonomy depend on the preimages chosen") {
  std::vector<Curve> curves = quarters();
  curves[0] = with_other_frame(with_other_frame(curves[0], {0, 0, 1, 5}), {1, 7, 0, 0});
  curves[1] = with_other_frame(curves[1], {0, 0, 2, -3});
  curves[2] = with_other_frame(curves[2], {-1, 0, 0, 0});
  curves[3] = with_other_frame(curves[3], {0, 0, 0, 1});
  const PhPath path = chain(curves);
  PathAngle angle(path);
  CHECK(digits(angle.holonomy().value()) == "1.13263544456407");
  for (std::size_t k = 0; k < 3; ++k) {
    const Frame<Rational> before = euler_rodrigues_frame(path.segments()[k], 1);
    const Frame<Rational> after = euler_rodrigues_frame(path.segments()[k + 1], 0);
    CHECK(before.e1 == after.e1);
    CHECK(before.e2 == after.e2);
    CHECK(hodograph(path.segments()[k + 1]) == hodograph(curves[k + 1]));
  }
}

// Gauss and Bonnet: a closed geodesic polygon on the sphere of tangents carries a normal by minus
// the sum of its turning angles.
TEST_CASE("spline: holonomies of plane pieces are exact multiples of a quarter turn") {
  PathAngle plane(through({x, y, minus_x, minus_y}));
  CHECK(plane.holonomy().value().exact() == Rational(0));
  PathAngle hexagon(through({x, y, minus_x, z, minus_y, minus_z}));
  CHECK(hexagon.holonomy().value().exact() == Rational(0));
  PathAngle half(through({x, y, x, minus_y, minus_x, z, minus_x, minus_z}));
  CHECK(half.path().ph()->closing_turn().has_value());
  CHECK(digits(half.holonomy().value()) == "3.14159265358979");
  CHECK(half.value(8).exact() == Rational(0));
  // By positions nothing is known but values: that it is within 256 bits of half a turn.
  const Real by_values = *PathAngle(test::by_positions(*half.path().ph()), {3, 5, 7}).holonomy();
  CHECK(digits(by_values) == "3.14159265358979");
}

// Without inflections θ′ ds⁻¹ = −τ, and of the halves of a curve the angle is that of the curve.
TEST_CASE("spline: the angle to the Frenet frame, where that is continuous") {
  const Curve curve(test::quintic);
  const PhPath halves =
      chain({segment(curve, 0, Rational(1, 3)), segment(curve, Rational(1, 3), 1)});
  const PathAngle angle(halves, Reference::frenet);
  const RmfAngle one(curve, Reference::frenet);
  for (const Rational& t : {Rational(1, 5), Rational(1, 3), Rational(2, 3), Rational(1)}) {
    const Rational at = 3 * t <= 1 ? Rational(3 * t) : Rational(1 + (3 * t - 1) / 2);
    CHECK(digits(angle.value(at)) == digits(one.value(t)));
  }
  CHECK(digits(angle.value(2)) == digits(-total_torsion(Path(halves)).value));
  CHECK(digits(PathAngle(test::by_positions(halves), Reference::frenet).value({1, Rational(1)})) ==
        digits(angle.value(2)));
  // A plane curve, an inflection at the joint, as of x³ and −x³.
  const auto frenet = [](const std::vector<Curve>& curves) {
    return PathAngle(chain(curves), Reference::frenet);
  };
  const PathAngle plane = frenet({plane_quarter(x, y), plane_quarter(y, minus_x)});
  CHECK(plane.value(2).exact() == Rational(0));
  const PathAngle inflected = frenet({plane_quarter(x, y), plane_quarter(y, x)});
  CHECK(inflected.value(2).exact() == Rational(0));
  CHECK_THROWS_WITH_AS(frenet({plane_quarter(x, y), plane_quarter(y, z)}),
                       "Frenet frame: at the joint t = 1 it jumps, by 1.57 radians", DomainError);
  CHECK_THROWS_WITH_AS(frenet({Curve({{1}, {}, {}, {}}), plane_quarter(x, y)}),
                       "Frenet frame: segment 1 is a straight line, it has no principal normal",
                       DomainError);
}

TEST_CASE("spline: a rational frame stays exact through the joints, to a segment without one") {
  // Quarter turns in three planes carry k to x, back along the octant of the sphere.
  std::vector<Curve> curves{plane_quarter(x, y), plane_quarter(y, z), plane_quarter(z, x)};
  curves[1] = with_other_frame(curves[1], {1, 7, 0, 0});
  const QuaternionPolynomial twist{{1, 2}, {3, -1}, {}, {}};
  for (const std::size_t k : {0U, 2U}) curves[k] = Curve(curves[k].preimage() * twist);
  const PhPath path = chain(curves);
  PathAngle angle(path);
  for (const Rational& t : {Rational(1, 3), Rational(1), Rational(5, 3), Rational(9, 4)}) {
    const PathParameter at = locate(path, t);
    const Frame<Rational> erf = euler_rodrigues_frame(path.segments()[at.segment], at.t);
    const auto direction = angle.direction(at);
    REQUIRE(direction);
    const auto frame = turned(erf, *direction);
    const auto expected = turned(as_real(erf), angle.value(at));
    for (std::size_t k = 0; k < 3; ++k) {
      REQUIRE(frame.e2[k].exact());
      CHECK(expected.e2[k].enclose(100).contains(*frame.e2[k].exact()));
      REQUIRE(frame.e3[k].exact());
      CHECK(expected.e3[k].enclose(100).contains(*frame.e3[k].exact()));
    }
  }
  curves.push_back(quarters().front());
  PathAngle longer(chain(curves));
  CHECK(longer.direction({2, 1}));
  CHECK_FALSE(longer.direction({3, Rational(1, 2)}));
}

TEST_CASE("spline: an open one has no holonomy, a plane one that closes at a corner 0") {
  PathAngle open(through({x, y, z}));
  CHECK_FALSE(open.path().ends_meet());
  CHECK_FALSE(open.holonomy());
  // (0, 0) → (1, 0) → (5/3, 1) → (2/3, 5/3) → (0, 2/3) → (0, 0), where it arrives downwards.
  const auto line = [](const Vector<Rational>& d, const Rational& length) {
    return scaled(std::get<Curve>(identify({Polynomial{d[0]}, Polynomial{d[1]}, Polynomial{d[2]}})),
                  length);
  };
  PathAngle corner(chain({line(x, 1), plane_quarter(x, y), plane_quarter(y, minus_x),
                          plane_quarter(minus_x, minus_y), line(minus_y, Rational(2, 3))}));
  CHECK(corner.path().closes_at_corner());
  CHECK(corner.holonomy()->exact() == Rational(0));
}

// The factor 1 + it turns the Euler–Rodrigues frame by 2·arctan t about the tangent, in each of
// four pieces, and θ back: the angle is −2π, the holonomy 0.
TEST_CASE("spline: a holonomy is 0 or pi exactly, however often the frame turns") {
  const auto twisted = [](const PhPath& path, long power) {
    std::vector<Curve> curves;
    QuaternionPolynomial factor{{1}, {}, {}, {}};
    for (long k = 0; k < power; ++k) {
      factor = factor * QuaternionPolynomial{{1}, {0, 1}, {}, {}};
    }
    for (const Curve& curve : path.segments())
      curves.emplace_back(curve.preimage() * factor, curve.multiplier());
    return curves;
  };
  for (const long power : {1, 7}) {
    PhPath loop = through({x, y, minus_x, minus_y});
    PathAngle angle(chain(twisted(loop, power)));
    CHECK(digits(angle.value(4)) == digits(Real([power](long bits) {
            return multiply(RealBall(-2 * power, bits), pi(bits), bits);
          })));
    CHECK(angle.holonomy().value().exact() == Rational(0));
    PathAngle half(
        chain(twisted(through({x, y, x, minus_y, minus_x, z, minus_x, minus_z}), power)));
    CHECK(digits(half.holonomy().value()) == "3.14159265358979");
  }
}

TEST_CASE("spline: a curve cut in pieces keeps its angle") {
  for_samples(40, [](Random& random) {
    const Curve curve = PhPath(random.curve(3)).segments().front();  // e₁ = r′/|r′| at the start
    const Rational cut(random.integer(1, 5), 6);
    if (curve.multiplier()(cut) == 0) return;  // the curve may turn back there
    Curve second = segment(curve, cut, 1);
    if (random.chance(2))
      second = with_other_frame(second, {random.integer(-9, 9), random.integer(1, 9), 0, 0});
    if (random.chance(2)) second = with_other_frame(second, {0, 0, random.integer(-9, 9), 1});
    PathAngle pieces(chain({segment(curve, 0, cut), second}));
    RmfAngle whole(curve, Reference::euler_rodrigues);
    for (const Rational& t : {Rational(1, 3), Rational(1), Rational(7, 4), Rational(2)}) {
      const Rational original = t <= 1 ? Rational(cut * t) : Rational(cut + (1 - cut) * (t - 1));
      const RealBall difference =
          subtract(pieces.value(t).enclose(100), whole.value(original).enclose(100), 100);
      CHECK(difference.contains_zero());
      CHECK(abs(difference.upper()) <
            Rational(1, 1 << 30) * (1 + abs(whole.value(original).enclose(50).upper())));
    }
  });
}

// The second half is the mirror image of the first in the plane across its last tangent, run
// through backwards: −diag(−1, 1, 1) is the half turn i about x.
TEST_CASE("spline: angles of different segments that cancel are exactly 0") {
  for_samples(10, [](Random& random) {
    QuaternionPolynomial a = random.quaternion_polynomial(3);
    const Polynomial rest{1, -1};
    for (Polynomial* component : {&a.p, &a.q}) *component *= rest;  // A(1) ∈ ℚ(i)
    if (a.u(1) == 0 && a.v(1) == 0) return;
    const Curve first(a);
    const Curve mirrored = rotated(reversed(first), {0, 1, 0, 0});
    PathAngle angle(chain({first, Curve(mirrored.preimage(), {1})}));
    CHECK(angle.value(2).exact() == Rational(0));
    CHECK(angle.value(PathParameter{1, Rational(1, 2)}).exact() ==
          angle.value(PathParameter{0, Rational(1, 2)}).exact());
  });
}

// By positions the same angle is the Taylor series of −e₂′·e₃, without a preimage.
TEST_CASE("path angle: to the frame of v the closed form is the integral by positions") {
  for_samples(25, [](Random& random) {
    const Curve curve = random.curve(2);
    const Path path{curve};
    const Vector<Rational> v{random.integer(-5, 5), random.integer(-5, 5), 7};
    CAPTURE(curve);
    if (v == Vector<Rational>{} || tangent_along(path.segments().front(), v)) return;
    const PathAngle closed(path, v);
    const PathAngle by_values(test::by_positions(PhPath(curve)), v);
    REQUIRE(closed.closed_form(0) != nullptr);
    REQUIRE(by_values.closed_form(0) == nullptr);
    for (const Rational& t : {Rational(1, 3), Rational(1)}) {
      const RealBall theta = closed.enclose(Place(0, t), 150);
      CHECK(theta.overlaps(by_values.enclose(Place(0, t), 150)));
      CHECK(theta.is_accurate(140));
      CHECK(closed.rate(Place(0, t), 100).overlaps(by_values.rate(Place(0, t), 100)));
    }
    // Turned from the frame of v, the frame is that which starts there by the preimage.
    const PathAngle to_erf(path);
    const StartAngle here = start_angle(LeastRotation{}, closed);
    REQUIRE(here.exact);
    const Place end(0, Rational(1));
    const Frame<Real> one = rotation_minimizing_frame(closed, end, here);
    const Frame<Real> other =
        rotation_minimizing_frame(to_erf, end, start_angle(LeastRotation{}, to_erf));
    for (std::size_t k = 0; k < 3; ++k)
      CHECK(one.e2[k].enclose(120).overlaps(other.e2[k].enclose(120)));
  });
}

// Along paths of every kind, and to all frames.

namespace {

/// Are all components equal as far as so many bits tell?
bool agree(const Frame<Real>& a, const Frame<Real>& b, long bits) {
  const auto same = [bits](const Vector<Real>& u, const Vector<Real>& v, bool is_reversed) {
    for (std::size_t k = 0; k < 3; ++k) {
      const RealBall x = u[k].enclose(bits);
      const RealBall y = v[k].enclose(bits);
      if (!x.is_accurate(bits - 20) || !y.is_accurate(bits - 20)) return false;
      if (!x.overlaps(is_reversed ? subtract({}, y, bits) : y)) return false;
    }
    return true;
  };
  return (same(a.e1, b.e1, false) && same(a.e3, b.e3, false) && same(a.e2, b.e2, false)) ||
         (same(a.e1, b.e1, true) && same(a.e3, b.e3, true) && same(a.e2, b.e2, false));
}

}  // namespace

TEST_CASE("path angle: the twisted cubic (t, t², t³) [mpmath: quad of the same rate]") {
  const Path path(RationalCurve({Polynomial{0, 1}, {0, 0, 1}, {0, 0, 0, 1}}));
  const PathAngle angle(path, {0, 0, 1});
  CHECK(round_to_decimal(angle.value({0, Rational(1)}), 40).value ==
        "-0.3304832001393860863483991853636333167034");
  // θ to the Frenet frame is −∫ τ ds.
  CHECK(round_to_decimal(PathAngle(path, Reference::frenet).value({0, Rational(1)}), 40).value ==
        "-1.507278500292393126918601351905495484273");
}

// 170 bits of the 190 are 51 digits.
TEST_CASE("path angle: PH curves by their positions have the frames of the exact way") {
  std::ifstream file(test::data("/curves.jsonl"));
  long count = 0;
  for (std::string line; std::getline(file, line);) {
    const NamedPhPath named = read_path(line);
    const Curve& curve = named.path.segments().front();
    if (degree(curve) > 41) continue;
    ++count;
    CAPTURE(named.name);
    const Path path = test::by_positions(PhPath(curve));
    const PathAngle angle(path);
    const RmfAngle exact(curve);
    const Frame<Rational> erf = euler_rodrigues_frame(curve, 0);
    const StartAngle from = start_angle(StartNormal({erf.e2[0], erf.e2[1], erf.e2[2]}), angle);
    for (const Rational& t : {Rational(1, 3), Rational(1)})
      CHECK(agree(rotation_minimizing_frame(angle, {0, t}, from),
                  rotation_minimizing_frame(curve, exact, t), 190));
  }
  CHECK(count == 110);  // of 132
}

TEST_CASE("path angle: another up vector gives the same frame") {
  test::Random random(77);
  for (long k = 0; k < 5 * test::multiplier(); ++k) {
    const long degree = random.integer(3, 8);
    std::vector<Vector<Rational>> points;
    std::vector<Rational> weights;
    for (long j = 0; j <= degree; ++j) {
      points.push_back({random.integer(-9, 9), random.integer(-9, 9), random.integer(-9, 9)});
      weights.emplace_back(random.integer(1, 9));
    }
    const Path path(bezier_curve(points, weights));
    const PathAngle one(path);
    const PathAngle other(path, {7, -31, 19});
    const Vector<Rational> normal{3, 1, 4};
    const StartAngle from_one = start_angle(StartNormal(normal), one);
    const StartAngle from_other = start_angle(StartNormal(normal), other);
    const Place at{0, Rational(2, 3)};
    CHECK(agree(rotation_minimizing_frame(one, at, from_one),
                rotation_minimizing_frame(other, at, from_other), 120));
  }
}

TEST_CASE("path angle: plane curves and straight lines do not turn") {
  const Path plane(RationalCurve({Polynomial{0, 1}, {0, 0, 1}, {1, 2, 3}}));
  CHECK(plane_normal(plane) == Vector<Rational>{-2, -3, 1});
  CHECK(PathAngle(plane).is_zero());
  CHECK(PathAngle(plane).value({0, Rational(1, 3)}).exact() == Rational(0));
  const Path line(RationalCurve({Polynomial{0, 1}, {0, 2}, {1, 3}}));
  CHECK(is_straight(line));
  CHECK_FALSE(plane_normal(line));
  CHECK(PathAngle(line).is_zero());
  CHECK_THROWS_AS(PathAngle(line, Reference::frenet), DomainError);
  const Frame<Real> frame = rotation_minimizing_frame(PathAngle(plane), {0, Rational(0)});
  CHECK(frame.e1[0].enclose(60).overlaps(divide(RealBall(1, 60), sqrt(RealBall(5, 60), 60), 60)));
}

TEST_CASE("path angle: at the joint behind a straight segment it is exactly 0, but for a corner") {
  const RationalCurve line({Polynomial{0, 1}, {0, 2}, {0, 3}});
  const auto at_joint = [&](RationalCurve next) {
    return PathAngle(joined({line, std::move(next)}), {0, 0, 1}).value({1, Rational(0)});
  };
  CHECK(at_joint(RationalCurve({Polynomial{1, 1, 1}, {2, 2, 0, 1}, {3, 3, 4}})).exact() ==
        Rational(0));
  CHECK_FALSE(at_joint(RationalCurve({Polynomial{1, 1, 1}, {2, 3, 0, 1}, {3, 3, 4}})).exact());
}

TEST_CASE("path angle: an up vector along the tangent is refused, with the place") {
  const Path path(RationalCurve({Polynomial{0, 1}, {0, -1, 1}, {0, 0, -1, Rational(4, 3)}}));
  CHECK_THROWS_WITH_AS(PathAngle(path, {1, 0, 0}),
                       "the up vector (1, 0, 0) is along the tangent at t = 1/2", DomainError);
  CHECK_THROWS_WITH_AS(PathAngle(path, {0, 0, 0}), "the up vector is 0", DomainError);
  CHECK_FALSE(tangent_along(std::get<RationalCurve>(path.segments()[0]), up_vector(path)));
  CHECK_THROWS_AS(PathAngle(path).value({0, Rational(2)}), DomainError);
}

TEST_CASE("path angle: a path that is cut turns as the whole") {
  // (t, t², t³) on [0, 1] and [1, 2].
  const Polynomial sooner{0, 1};
  const Polynomial later{1, 1};
  const auto cubic = [](const Polynomial& t) { return RationalCurve({t, t * t, t * t * t}); };
  const Path cut = joined({cubic(sooner), cubic(later)});
  const Path whole(cubic(Rational(2) * sooner));
  const Vector<Rational> up{1, 1, 5};
  const RealBall a = PathAngle(cut, up).enclose({1, Rational(1, 2)}, 150);
  const RealBall b = PathAngle(whole, up).enclose({0, Rational(3, 4)}, 150);
  CHECK(a.overlaps(b));
  CHECK(a.is_accurate(150));
}

// Without inflections the angle is −∫τ ds.
TEST_CASE("path angle: to the Frenet frame of a spline, where that is continuous") {
  const auto read = [](const std::string& table) { return read_any_path(table).path; };
  const auto frenet = [&](const std::string& table) {
    return PathAngle(read(table), Reference::frenet);
  };
  const auto check_torsion = [](const PathAngle& angle) {
    const Place end{angle.path().segments().size() - 1, Rational(1)};
    CHECK(round_to_double(angle.value(end)) ==
          doctest::Approx(-round_to_double(total_torsion(angle.path()).value)));
  };
  check_torsion(frenet("# kind: periodic\nx y z\n0 0 0\n3 0 1\n4 3 -1\n1 4 0\n-1 2 2\n"));
  // Up to 50 points, of a closed spline too, the second derivatives are equal as fractions.
  std::string knot = "# kind: periodic\nx y z\n";
  for (int k = 0; k < 50; ++k) {
    const double u = 2 * std::numbers::pi * k / 50;
    knot += fmt::format("{:.3f} {:.3f} {:.3f}\n", std::sin(u) + 2 * std::sin(2 * u),
                        std::cos(u) - 2 * std::cos(2 * u), -std::sin(3 * u));
  }
  CHECK_NOTHROW(require_frenet_joints(read(knot)));
  // The binormals there are along (−6, 6, −2) and (10, −10, −14).
  CHECK_THROWS_WITH_AS(frenet("x y z dx dy dz\n0 0 0 1 0 0\n1 1 1 1 1 0\n2 0 3 0 1 1\n"),
                       "Frenet frame: at the joint t = 1 it jumps, by 1.01 radians", DomainError);
  // In a plane an inflection may be at a joint: y = ±x³.
  const PathAngle plane = frenet("x y z dx dy dz\n0 0 0 1 1 0\n1 0 0 1 -2 0\n2 0 0 1 1 0\n");
  CHECK(plane.is_zero());
}

TEST_CASE("path angle: next to a cusp, |H| ≥ 1e-12, two up vectors give the same frame") {
  // r′ = (w, w², 1e-12), w = t − 1/3.
  const Polynomial w{Rational(-1, 3), 1};
  const Path path(
      RationalCurve({antiderivative(w), antiderivative(w * w), Polynomial{0, power_of_ten(-12)}}));
  const PathAngle one(path, {1, 2, 2});
  const PathAngle other(path, {-3, 4, 7});
  const StartNormal normal({0, 1, 1});
  const Place end{0, Rational(1)};
  CHECK(agree(rotation_minimizing_frame(one, end, start_angle(normal, one)),
              rotation_minimizing_frame(other, end, start_angle(normal, other)), 120));
}

// Along the edges x, y, z, −x, −y, −z of a cube the tangent's way on the sphere halves it, by
// symmetry.
TEST_CASE("path angle: along the edges of a cube a frame comes back exactly") {
  const Path cube =
      test::polygon({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {1, 1, 1}, {0, 1, 1}, {0, 0, 1}, {0, 0, 0}});
  for (const Vector<Rational>& v : {Vector<Rational>{1, 2, 5}, {1, 1, 1}, {3, -2, 7}})
    CHECK(PathAngle(cube, v).holonomy()->exact() == Rational(0));
  CHECK(PathAngle(segment(cube, 0, 5), {1, 2, 5}).holonomy() == std::nullopt);
}

// Rodrigues' formula in mpmath takes (0, 1, 0) from edge to edge to (0, 1/2, −√3/2).
TEST_CASE("path angle: the holonomy of a quadrangle along x, y, z and back is -pi/3") {
  const Path four = test::polygon({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {1, 1, 1}, {0, 0, 0}});
  for (const Vector<Rational>& v : {Vector<Rational>{1, 2, 5}, {2, -3, 1}, {1, -1, 0}})
    CHECK(over_pi(PathAngle(four, v).holonomy().value()) == Rational(-1, 3));
}

// Of the same closed curve e₁ is the tangent at the start, whichever e₁ the segments are given
// with, so that the frame comes back turned by the same angle about it, with the same sign.
TEST_CASE("path angle: the holonomy is the same whether or not the first segment is turned over") {
  const PhPath ph = chain(quarters());
  const auto holonomy = [](const std::vector<Segment>& segments) {
    Path path(segments.front());
    for (std::size_t k = 1; k < segments.size(); ++k) path.append(segments[k]);
    return PathAngle(path, {3, 5, 7}).holonomy().value();
  };
  const Path of_ph(ph);
  for (const Path& path : {of_ph, test::by_positions(ph)}) {
    std::vector<Segment> segments = path.segments();
    CHECK(digits(holonomy(segments)) == "1.13263544456407");
    for (Segment& segment : segments) {
      segment = turned_over(segment);
      CHECK(digits(holonomy(segments)) == "1.13263544456407");
    }
  }
  const Path trefoil = read_any_path(R"json({"phrame": "curve/1", "from": 0, "to": "2*pi",
      "expressions": {"x": "sin(t) + 2*sin(2*t)", "y": "cos(t) - 2*cos(2*t)", "z": "-sin(3*t)"}}
      )json")
                           .path;
  CHECK(digits(holonomy({turned_over(trefoil.segments().front())})) ==
        digits(holonomy(trefoil.segments())));
}
