#include "phrame/algebra/ring_ball.hpp"

#include "phrame/ph/curve/quaternion.hpp"
#include "support/random.hpp"

using namespace phrame;
using test::for_samples;
using test::Random;

TEST_CASE("ring ball: law: a template over a ring contains what it gives over the rationals") {
  for_samples(100, [](Random& random) {
    using Ball = RingBall<90>;
    const RationalQuaternion a{random.rational(), random.rational(), random.rational(),
                               random.rational()};
    const auto ball = [](const Rational& x) { return Ball{RealBall(x, 90)}; };
    const Quaternion<Ball> b{ball(a.u), ball(a.v), ball(a.p), ball(a.q)};
    for (std::size_t k = 0; k < 3; ++k) {
      CHECK(rotated_i(b)[k].x.contains(rotated_i(a)[k]));
      CHECK(rotated_j(b)[k].x.contains(rotated_j(a)[k]));
      CHECK(rotated_k(b)[k].x.contains(rotated_k(a)[k]));
    }
    CHECK(norm(b).x.contains(norm(a)));
  });
}
