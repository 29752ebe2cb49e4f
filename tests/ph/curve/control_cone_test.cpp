#include "phrame/ph/curve/control_cone.hpp"

#include <doctest/doctest.h>

#include "phrame/ph/curve/curve.hpp"
#include "phrame/ph/curve/vector.hpp"
#include "support/random.hpp"

using namespace phrame;
using test::for_samples;
using test::Random;

TEST_CASE("control_cone: a plane cubic and one in space") {
  // w = 1 + it: r = (t − t³/3, t², 0), legs (1, 0, 0)/3, (1, 1, 0)/3 and (0, 1, 0)·2/3.
  const Curve plane({{1}, {}, {}, {0, 1}});
  CHECK(control_cone(plane) == ControlCone{Rational(1, 2), false, -1});
  // (u, v, p, q) = (1, t, t, 0): r′ = (1, 2t², −2t), legs (1, 0, 0)/3, (1, 0, −1)/3 and (1, 2,
  // −2)/3: cosines 1/√2 and 3/(3√2), and cos φ = 1 − 2·2/3.
  const Curve cubic({{1}, {0, 1}, {0, 1}, {}});
  CHECK(control_cone(cubic) == ControlCone{Rational(1, 2), false, Rational(-1, 3)});
  CHECK_FALSE(control_cone(Curve({{1, 1}, {}, {}, {}})));            // a line
  CHECK_FALSE(control_cone(Curve({{1}, {0, 0, 1}, {0, 1}, {}})));    // a quintic
  CHECK_FALSE(control_cone(Curve({{-1, 2}, {}, {}, {1}}, {0, 1})));  // a quartic
}

TEST_CASE("control_cone: law: the angle between the first and the last leg") {
  long obtuse = 0;
  for_samples(30, [&](Random& random) {
    const Curve curve = random.curve(1);
    const auto cone = control_cone(curve);
    if (!cone) return;
    const auto points = control_points(curve);
    const auto L0 = points[1] - points[0], L1 = points[2] - points[1], L2 = points[3] - points[2];
    obtuse += cone->is_obtuse;
    CHECK((dot(L2, L1) < 0) == cone->is_obtuse);
    CHECK(dot(L2, L1) * dot(L2, L1) == cone->cosine_squared * dot(L1, L1) * dot(L2, L2));
    // cos of the angle between them: by the law of cosines on the sphere.
    const Rational cosine =
        cone->cosine_squared + (1 - cone->cosine_squared) * cone->azimuth_cosine;
    CHECK(dot(L0, L2) * dot(L0, L2) == cosine * cosine * dot(L0, L0) * dot(L2, L2));
  });
  CHECK(obtuse > 0);
}
