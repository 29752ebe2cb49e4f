#include "phrame/ph/sweep/rational_sweep.hpp"

#include <doctest/doctest.h>
#include "phrame/algebra/error.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/ph/curve/vector.hpp"
#include "phrame/ph/frame/frame.hpp"
#include "support/curves.hpp"
#include "support/paths.hpp"
#include "support/refusal.hpp"
#include "support/surface_point.hpp"
#include "support/text.hpp"

using namespace phrame;
using test::class_one;

namespace rational_sweep_test {

/// Half a circle and two rational pieces.
ProfileCurve round_profile() {
  return ProfileCurve({{{{1, 0}, {1, 1}, {0, 1}}, {1, 1, 2}},
                       {{{0, 1}, {-1, 2}, {-1, -1}, {0, -1}}, {1, 3, Rational(1, 2), 1}},
                       {{{0, -1}, {1, 0}}, {2, 1}}});
}

/// With one hole that is round, and one that is not.
ProfileCurve pierced_square() {
  auto hole = circle_curve(Rational(1, 4)).pieces();
  for (PlaneBezier& quarter : hole)
    for (ProfilePoint& at : quarter.points) at[1] += Rational(1, 2);
  return ProfileCurve::of_rings(
      {polygon_curve(rectangle_profile(2, 2)).pieces(), hole,
       polygon_curve(Profile({{0, 0}, {Rational(1, 2), Rational(-1, 2)}, {-1, Rational(-3, 4)}}))
           .pieces()});
}

ProfileCurve square() { return polygon_curve(rectangle_profile(2, 2)); }

/// The exact rotation-minimizing frame, by the closed form of its angle.
Frame<Rational> exact_frame(const PathAngle& angle, const PathParameter& at,
                            const FrameAngle& start) {
  const Curve& curve = *ph_curve(angle.path().segments()[at.segment]);
  const auto direction = angle.direction(at).value();
  const auto turned_by = turned(
      euler_rodrigues_frame(curve, at.t), direction,
      [&](const FrameAngle& from) { return angle.value(at, from); }, start);
  Frame<Rational> exact;
  for (std::size_t k = 0; k < 3; ++k) {
    exact.e1[k] = turned_by.e1[k].exact().value();
    exact.e2[k] = turned_by.e2[k].exact().value();
    exact.e3[k] = turned_by.e3[k].exact().value();
  }
  return exact;
}

/// Each patch at some points is r + λ(x f₂ + y f₃), with weights > 0.
void check_surface(const PhPath& path, const RationalSurface& surface,
                   const RationalSweepForm& form, const FrameAngle& start = {}) {
  const PathAngle angle(path);
  const bool is_against = path.segments().front().multiplier()(0) < 0;
  const auto pieces = is_against ? reversed_pieces(form.profile) : form.profile.pieces();
  CHECK(surface.patches.size() % pieces.size() == 0);
  Rational end;
  for (const SurfacePatch& patch : surface.patches) {
    if (patch.side == 0) {
      CHECK(patch.from == end);
      end = patch.to;
    }
    for (const auto& row : patch.weights)
      for (const Rational& weight : row) CHECK(weight > 0);
    const auto [x, y, weight] = polynomials(pieces[patch.side]);
    for (const Rational& s : {Rational(0), Rational(2, 7), Rational(1)}) {
      const Rational t = patch.from + s * (patch.to - patch.from);
      const PathParameter at = locate_inside(path, t);
      const Frame<Rational> f = exact_frame(angle, at, start);
      const Rational scale = form.scale(t);
      for (const Rational& u : {Rational(0), Rational(3, 5)}) {
        const auto expected = evaluate(position(path.segments()[at.segment]), at.t) +
                              Rational(scale * x(u) / weight(u)) * f.e2 +
                              Rational(scale * y(u) / weight(u)) * f.e3;
        CHECK(test::point(patch, u, s) == expected);
      }
    }
  }
  CHECK(end == path.end());
}

RationalSurface swept(const PhPath& path, const RationalSweepForm& form,
                      const FrameStart& start = Angle()) {
  return rational_sweep(path, rational_rmf(path, start), form);
}

std::string refusal(const std::function<void()>& make) {
  return test::refusal_of<Error>([&] { make(); });
}

}  // namespace rational_sweep_test

using namespace rational_sweep_test;

TEST_CASE("rational sweep: the surface is that of the exact frame, at fractions of t and u") {
  const PhPath quintic((Curve(class_one)));
  for (const ProfileCurve& profile :
       {round_profile(), square(), circle_curve(Rational(1, 3)), pierced_square()}) {
    const RationalSweepForm form{profile};
    check_surface(quintic, swept(quintic, form), form);
  }
  const PhPath line(Curve({{1}, {}, {}, {}}));
  const RationalSurface prism = swept(line, {square()});
  check_surface(line, prism, {square()});
  CHECK(prism.patches.size() == 4);
  CHECK(prism.patches[0].points.size() == 2);  // of degree 1 in t
  CHECK_FALSE(prism.is_closed);
}

TEST_CASE("rational sweep: through joints, scaled, started anywhere, against the motion") {
  const Curve whole{class_one};
  const PhPath path = test::cut(whole, {Rational(1, 3), Rational(3, 4)});
  RationalSweepForm form{round_profile()};
  form.scale = RationalFunction(Polynomial{2, -1, 1}, Polynomial{3, 1});
  check_surface(path, swept(path, form), form);
  // arg(3 + 4i), arg(−1), and a right angle.
  const Frame<Rational> erf = euler_rodrigues_frame(path.segments().front(), 0);
  const auto along = [&](const GaussianRational& z) {
    return StartNormal(z.re * erf.e2 + z.im * erf.e3);
  };
  for (const GaussianRational& z :
       {GaussianRational{3, 4}, GaussianRational{-1, 0}, GaussianRational{-8, 6}})
    check_surface(path, swept(path, form, along(z)), form, angle_of(z));
  check_surface(path, swept(path, form, Angle(Rational(3, 2), 0)), form, Angle(Rational(3, 2), 0));
  const PhPath back(Curve(class_one, Polynomial{-1}));
  check_surface(back, swept(back, form), form);
}

// N = |A|² = t⁴ + … with a minimum near 1/2: (1, 100(t − 1/2)).
TEST_CASE("rational sweep: a part is halved until its weights are positive") {
  const PhPath sharp(Curve({{1}, {}, {}, {-50, 100}}));
  const RationalSurface surface = swept(sharp, {square()});
  check_surface(sharp, surface, {square()});
  CHECK(surface.patches.size() > 4);
}

TEST_CASE("rational sweep: the normal is outward, for either sign of the multiplier") {
  for (const long sign : {1, -1}) {
    const PhPath line(Curve({{1}, {}, {}, {}}, Polynomial{sign}));
    const RationalSurface surface = swept(line, {square()});
    for (const SurfacePatch& patch : surface.patches) {
      const auto at = [&](const Rational& u, const Rational& s) {
        return test::point(patch, u, s);
      };
      const Vector<Rational> corner = at(0, 0);
      const auto normal = cross(at(1, 0) - corner, at(0, 1) - corner);
      CHECK(dot(normal, at(Rational(1, 2), 0)) > 0);  // the curve starts at the origin
    }
  }
}

TEST_CASE("rational sweep: holes are swept, too, and their normal is into them") {
  const ProfileCurve frame = polygon_curve(Profile::of_rings(
      {{{1, 1}, {-1, 1}, {-1, -1}, {1, -1}}, {{2, 2}, {-2, 2}, {-2, -2}, {2, -2}}}));
  for (const long sign : {1, -1}) {
    const PhPath line(Curve({{1}, {}, {}, {}}, Polynomial{sign}));
    const RationalSurface surface = swept(line, {frame});
    check_surface(line, surface, {frame});
    CHECK(surface.sides == 8);
    CHECK(surface.rings == std::vector<std::size_t>{0, 4});
    CHECK(surface.patches.size() == 8);
    for (const SurfacePatch& patch : surface.patches) {
      const auto at = [&](const Rational& u, const Rational& s) {
        return test::point(patch, u, s);
      };
      const Vector<Rational> corner = at(0, 0);
      const auto normal = cross(at(1, 0) - corner, at(0, 1) - corner);
      CHECK(dot(normal, at(Rational(1, 2), 0)).sign() == (patch.side < 4 ? 1 : -1));
    }
  }
  const PhPath loop = test::closed_loop();
  CHECK(swept(loop, {pierced_square()}).is_closed);
}

// The plane loop has the same frame at both ends, and its own normal all along.
TEST_CASE("rational sweep: a closed curve in a plane is closed") {
  const PhPath loop = test::closed_loop();
  const RationalSurface surface = swept(loop, {round_profile()});
  CHECK(surface.is_closed);
  check_surface(loop, surface, {round_profile()});
  RationalSweepForm scaled{square()};
  scaled.scale = RationalFunction(Polynomial{1, 1});
  CHECK_FALSE(swept(loop, scaled).is_closed);
}

TEST_CASE("rational sweep: what is not rational is refused, with the reason") {
  const PhPath quintic(test::quintic);
  CHECK(test::contains(refusal([&] { swept(quintic, {square()}); }), "residues"));
  CHECK(test::contains(
      refusal([&] { swept(PhPath(Curve(class_one)), {square()}, Angle(Rational(1, 4), 0)); }),
      "pi/4"));
  const PhPath cusp(Curve({{1}, {}, {}, {}}, Polynomial{Rational(1, 4), -1, 1}));
  CHECK(test::contains(refusal([&] { swept(cusp, {square()}); }), "cusp"));
  RationalSweepForm negative{square()};
  negative.scale = RationalFunction(Polynomial{1, -2});
  CHECK_THROWS_AS(swept(PhPath(Curve(class_one)), negative), DomainError);
}

// The check of the result is independent of how it was made: another frame is no such surface.
TEST_CASE("rational sweep: a frame that is not rotation-minimizing is noticed") {
  const PhPath path(test::quintic);
  const std::vector<RationalFramePiece> erf{{0, 0, 1, test::quintic.preimage()}};
  CHECK(test::contains(refusal([&] { rational_sweep(path, erf, {square()}); }),
                       "not rotation-minimizing"));
  RationalSweepForm form{square()};
  form.is_rotation_minimizing = false;
  CHECK(refusal([&] { rational_sweep(path, erf, form); }).empty());
  const std::vector<RationalFramePiece> other{{0, 0, 1, class_one}};
  CHECK(test::contains(refusal([&] { rational_sweep(path, other, form); }), "not normal"));
}
