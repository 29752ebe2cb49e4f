#include "phrame/ph/frame/compiled_angle.hpp"
#include "phrame/ph/frame/compiled_frame.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/ph/frame/path_frame.hpp"
#include "support/curves.hpp"
#include "support/expression_curves.hpp"
#include "support/paths.hpp"
#include "support/random.hpp"

using namespace phrame;

namespace {

/// |x − y| ≤ bound, as far as 160 bits tell.
bool is_within(double x, const Real& y, double bound) {
  const RealBall off = subtract(RealBall(exact_rational(x), 160), y.enclose(160), 160);
  return absolute(off).upper() <= exact_rational(bound);
}

void check_frame(const Frame<double>& found, const Frame<Real>& exact, double bound) {
  for (std::size_t k = 0; k < 3; ++k) {
    CHECK(is_within(found.e1[k], exact.e1[k], bound));
    CHECK(is_within(found.e2[k], exact.e2[k], bound));
    CHECK(is_within(found.e3[k], exact.e3[k], bound));
  }
}

/// Compiled values against the exact ones, which they were not made from but in the middle of the
/// pieces.
void check_compiled(const PathAngle& angle, const Real& start, long count) {
  CompiledAngle theta = CompiledAngle(angle, start);
  const CompiledFrames frames = CompiledFrames(angle, start);
  const double end = round_to_double(angle.path().end());
  for (long k = 0; k <= count; ++k) {
    const double t = end * static_cast<double>(k) / static_cast<double>(count);
    CAPTURE(t);
    const Place at = locate(angle.path(), exact_rational(t));
    CHECK(theta(t) == round_to_double(angle.value(at) + start));
    check_frame(frames(t), rotation_minimizing_frame(angle, at, start), 0x1p-53);
    if (const auto rounded = frames.rounded(t)) {
      const Frame<Real> exact = rotation_minimizing_frame(angle, at, start);
      CHECK(rounded->e1 == round_to_double(exact.e1));
      CHECK(rounded->e2 == round_to_double(exact.e2));
      CHECK(rounded->e3 == round_to_double(exact.e3));
    }
  }
  CHECK(theta.exact_values() <= 2 + count / 20);
}

RationalCurve random_bezier(test::Random& random, long degree, bool is_rational) {
  std::vector<Vector<Rational>> points;
  std::vector<Rational> weights;
  for (long k = 0; k <= degree; ++k) {
    points.push_back({random.integer(-9, 9), random.integer(-9, 9), random.integer(-9, 9)});
    weights.push_back(is_rational ? Rational(random.integer(1, 5), 2) : Rational(1));
  }
  return bezier_curve(points, weights);
}

}  // namespace

// f₂ and θ at t = 1/2 and θ at 1 by mpmath's odefun and quad, as in any_path_test.
TEST_CASE("compiled path: the cubic of an independent method") {
  const Path cubic(bezier_curve({{0, 0, 0}, {1, 0, 0}, {1, 2, 0}, {0, 2, 3}}));
  const PathAngle angle(cubic, {0, 0, 1});
  CompiledAngle theta = CompiledAngle(angle);
  CHECK(theta(0) == 0);
  CHECK(theta(0.5) == -0.289671535325403270086160);
  CHECK(theta(1) == -1.65740642390110110987773);
  const Vector<double> f2 = CompiledFrames(angle)(0.5).e2;
  CHECK(std::abs(f2[0] - -0.9583377490235709016413) <= 0x1p-52);
  CHECK(std::abs(f2[1] - 0.1713824762533109234127) <= 0x1p-52);
  CHECK(std::abs(f2[2] - -0.2285099683377478978835) <= 0x1p-52);
  CHECK_THROWS_AS(theta(1.5), DomainError);
  CHECK_THROWS_AS(CompiledFrames{angle}(-0.5), DomainError);
}

TEST_CASE("compiled path: random curves, polynomial and rational, and their paths") {
  test::for_samples(6, [](test::Random& random) {
    const RationalCurve curve =
        random_bezier(random, random.integer(2, 6), random.integer(0, 1) == 1);
    CAPTURE(degree(curve));
    check_compiled(PathAngle(Path(curve)), Rational(random.integer(-3, 3), 4), 40);
  });
  const Path path = joined({bezier_curve({{0, 0, 0}, {1, 0, 0}, {2, 1, 1}}, {1, 2, 3}),
                            bezier_curve({{2, 1, 1}, {3, 2, 2}, {3, 3, 0}, {1, 5, -1}})});
  check_compiled(PathAngle(path), Rational(0), 60);
}

TEST_CASE("compiled path: near a cusp, and through one") {
  // (t, ε)-like: |H| comes down to 1/1000 of its size at 1/2.
  const Polynomial x{0, Rational(1, 4), Rational(-1, 2), Rational(1, 3)};
  const Path near(RationalCurve({x, Polynomial{0, 0, 1, -1}, Polynomial{0, Rational(1, 500)}}));
  check_compiled(PathAngle(near, {1, 2, 9}), Rational(0), 60);
  const Path cusp(RationalCurve({Polynomial{0, Rational(1, 4), Rational(-1, 2), Rational(1, 3)},
                                 Polynomial{0, 0, Rational(1, 8), Rational(-1, 3), Rational(1, 4)},
                                 Polynomial{0, Rational(1, 4), Rational(-1, 2), Rational(1, 3)}}));
  check_compiled(PathAngle(cusp), Rational(1, 3), 60);
}

TEST_CASE("compiled path: a plane path's frame is exact where it is 0") {
  const Path path(bezier_curve({{0, 0, 0}, {1, 0, 0}, {2, 1, 0}}, {1, 2, 3}));
  const PathAngle angle(path);
  REQUIRE(angle.is_zero());
  CompiledAngle theta = CompiledAngle(angle);
  CHECK(theta(0.3) == 0);
  const Frame<double> frame = CompiledFrames(angle).rounded(0.3).value();
  CHECK(frame.e1[2] == 0);
  CHECK(frame.e2[2] == 0);
  CHECK(std::abs(frame.e3[2]) == 1);
  check_compiled(angle, Rational(0), 20);
}

// Two equations for one frame: that of the preimage, and that of H.
TEST_CASE("compiled path: a PH curve by its positions has the frame of the PH curve") {
  const PhPath ph(test::quintic);
  const PathAngle angle(test::by_positions(ph));
  const Vector<Rational> e2 = euler_rodrigues_frame(test::quintic, 0).e2;
  const CompiledFrames known{PathAngle(ph)};
  const CompiledFrames found = CompiledFrames(angle, start_angle(StartNormal(e2), angle));
  for (long k = 0; k <= 100; ++k) {
    const double t = static_cast<double>(k) / 100;
    const Frame<double> a = known(t);
    const Frame<double> b = found(t);
    for (std::size_t i = 0; i < 3; ++i) {
      CHECK(std::abs(a.e1[i] - b.e1[i]) <= 0x1p-52);
      CHECK(std::abs(a.e2[i] - b.e2[i]) <= 0x1p-52);
      CHECK(std::abs(a.e3[i] - b.e3[i]) <= 0x1p-52);
    }
  }
}

TEST_CASE("compiled path: the angle to the Frenet frame") {
  const Path cubic(bezier_curve({{0, 0, 0}, {1, 0, 0}, {1, 2, 0}, {0, 2, 3}}));
  const PathAngle angle(cubic, Reference::frenet);
  CompiledAngle theta = CompiledAngle(angle);
  CHECK(theta(1) == -1.65740642390110110987772706379);
  for (const double t : {0.0, 0.1, 0.7, 0.99})
    CHECK(theta(t) == round_to_double(angle.value({0, exact_rational(t)})));
}

TEST_CASE("compiled path: curves by formulas, alone and behind a rational one") {
  const Path wild(test::expression_curve(
      {"exp(s)*cos(s)", "log(2 + s)*s", "atan(s) + sqrt(1 + s^2)"}, "0", "1/4"));
  check_compiled(PathAngle(wild), Rational(1, 3), 12);
  // There and back, so that what follows is turned over.
  Path path(RationalCurve({Polynomial{0, 1, -1}, {}, {}}));
  path.append(test::expression_curve({"-sin(s)", "1 - cos(s)", "s^2"}, "0", "1/4"));
  check_compiled(PathAngle(path, {1, 3, 2}), Rational(0), 12);
}

TEST_CASE("compiled path: in a plane formulas have the zeros of the frame of its normal") {
  const Path circle(test::expression_curve({"cos(s)", "sin(s)", "2"}, "0", "1"));
  const CompiledFrames frames = CompiledFrames(PathAngle(circle, {0, 0, 1}));
  const auto frame = frames.rounded(0.4).value();
  CHECK(frame.e1[2] == 0);
  CHECK(frame.e2[2] == 0);
  CHECK(frame.e3[0] == 0);
  CHECK(frame.e3[2] == 1);
}
