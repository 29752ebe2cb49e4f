#include "phrame/ph/along/path_angle.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <numbers>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/io/read/any_path.hpp"
#include "phrame/io/read/curve_file.hpp"
#include "phrame/ph/along/path_angle.hpp"
#include "phrame/ph/along/path_totals.hpp"
#include "phrame/ph/along/smooth_shape.hpp"
#include "phrame/ph/along/up_vector.hpp"
#include "phrame/ph/frame/path_frame.hpp"
#include "support/data.hpp"
#include "support/random.hpp"

using namespace phrame;

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

TEST_CASE("smooth angle: the twisted cubic (t, t², t³) [mpmath: quad of the same rate]") {
  const Path path(RationalCurve({Polynomial{0, 1}, {0, 0, 1}, {0, 0, 0, 1}}));
  const PathAngle angle(path, {0, 0, 1});
  CHECK(round_to_decimal(angle.value({0, Rational(1)}), 40).value ==
        "-0.3304832001393860863483991853636333167034");
  // θ to the Frenet frame is −∫ τ ds.
  CHECK(round_to_decimal(PathAngle(path, Reference::frenet).value({0, Rational(1)}), 40).value ==
        "-1.507278500292393126918601351905495484273");
}

// 170 bits of the 190 are 51 digits.
TEST_CASE("smooth angle: PH curves by their positions have the frames of the exact way") {
  std::ifstream file(test::data("/curves.jsonl"));
  long count = 0;
  for (std::string line; std::getline(file, line);) {
    const NamedPhPath named = read_path(line);
    const Curve& curve = named.path.segments().front();
    if (degree(curve) > 41) continue;
    ++count;
    CAPTURE(named.name);
    const Path path = by_positions(PhPath(curve));
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

TEST_CASE("smooth angle: another up vector gives the same frame") {
  test::Random random(77);
  for (long k = 0; k < 5 * test::multiplier(); ++k) {
    const long degree = random.integer(3, 8);
    std::vector<Vector<Rational>> points;
    std::vector<Rational> weights;
    for (long j = 0; j <= degree; ++j) {
      points.push_back({random.integer(-9, 9), random.integer(-9, 9), random.integer(-9, 9)});
      weights.push_back(Rational(random.integer(1, 9)));
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

TEST_CASE("smooth angle: plane curves and straight lines do not turn") {
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

TEST_CASE("smooth angle: an up vector along the tangent is refused, with the place") {
  const Path path(RationalCurve({Polynomial{0, 1}, {0, -1, 1}, {0, 0, -1, Rational(4, 3)}}));
  CHECK_THROWS_WITH_AS(PathAngle(path, {1, 0, 0}),
                       "the up vector (1, 0, 0) is along the tangent at t = 1/2", DomainError);
  CHECK_THROWS_WITH_AS(PathAngle(path, {0, 0, 0}), "the up vector is 0", DomainError);
  CHECK_FALSE(tangent_along(std::get<RationalCurve>(path.segments()[0]), up_vector(path)));
  CHECK_THROWS_AS(PathAngle(path).value({0, Rational(2)}), DomainError);
}

TEST_CASE("smooth angle: a path that is cut turns as the whole") {
  // (t, t², t³) on [0, 1] and [1, 2].
  const Polynomial x{0, 1};
  const Polynomial later{1, 1};
  const auto cubic = [](const Polynomial& t) { return RationalCurve({t, t * t, t * t * t}); };
  const Path cut = joined({cubic(x), cubic(later)});
  const Path whole(cubic(Rational(2) * x));
  const Vector<Rational> up{1, 1, 5};
  const RealBall a = PathAngle(cut, up).enclose({1, Rational(1, 2)}, 150);
  const RealBall b = PathAngle(whole, up).enclose({0, Rational(3, 4)}, 150);
  CHECK(a.overlaps(b));
  CHECK(a.is_accurate(150));
}

// Without inflections the angle is −∫τ ds.
TEST_CASE("smooth angle: to the Frenet frame of a spline, where that is continuous") {
  const auto read = [](const std::string& table) {
    return read_any_path(table).path;
  };
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

TEST_CASE("smooth angle: next to a cusp, |H| ≥ 1e-12, two up vectors give the same frame") {
  // r′ = (x, x², 1e-12), x = t − 1/3.
  const Polynomial x{Rational(-1, 3), 1};
  const Path path(
      RationalCurve({antiderivative(x), antiderivative(x * x), Polynomial{0, power_of_ten(-12)}}));
  const PathAngle one(path, {1, 2, 2});
  const PathAngle other(path, {-3, 4, 7});
  const StartNormal normal({0, 1, 1});
  const Place end{0, Rational(1)};
  CHECK(agree(rotation_minimizing_frame(one, end, start_angle(normal, one)),
              rotation_minimizing_frame(other, end, start_angle(normal, other)), 120));
}
