#include "phrame/ph/along/feedrate.hpp"

#include "phrame/algebra/error.hpp"
#include "phrame/ph/along/arc_length.hpp"
#include "phrame/ph/curve/invariants.hpp"
#include "support/random.hpp"

using namespace phrame;
using test::for_samples;
using test::Random;

namespace {

using Of = Feedrate::Of;

/// A = 1 + tk: r′ = (1 − t², 2t, 0), σ = 1 + t², s = t + t³/3, κ = 2/(1 + t²)².
const Curve plane({{1}, {}, {}, {0, 1}});

RationalFunction polynomial(const Polynomial& p) { return RationalFunction(p); }

}  // namespace

TEST_CASE("feedrate: each kind as a function of t, by hand") {
  const Polynomial sigma{1, 0, 1};
  CHECK(travel_time_rate(plane, {polynomial({5}), Of::parameter}) ==
        RationalFunction({Rational(1, 5), 0, Rational(1, 5)}, {1}));
  // V = 3 + 6(t + 2)
  CHECK(travel_time_rate(plane, {polynomial({3, 6}), Of::parameter}, 2) ==
        RationalFunction(sigma, {15, 6}));
  CHECK(travel_time_rate(plane, {polynomial({5, 0, 1}), Of::parameter}) ==
        RationalFunction(sigma, {5, 0, 1}));
  // σ(1 + 2κ)/5 = (σ + 4/σ)/5
  CHECK(travel_time_rate(plane, {RationalFunction({5}, {1, 2}), Of::curvature}) ==
        RationalFunction(sigma * sigma + Polynomial{4}, Rational(5) * sigma));
}

TEST_CASE("feedrate: a curve along which f is negative has its own length") {
  const Curve back(plane.preimage(), {-2});
  CHECK(travel_time_rate(back, {polynomial({1}), Of::parameter}) == polynomial({2, 0, 2}));
}

TEST_CASE("feedrate: law: along the curve V has the values of the quantity it depends on") {
  for_samples(40, [](Random& random) {
    const RationalFunction v(random.polynomial(3), random.nonzero_polynomial(3));
    const Rational t(random.integer(0, 20), 20);
    const auto check = [&](Of of, const Rational& quantity) {
      if (v.denominator()(quantity) == 0) return;
      CHECK(speed_along(plane, {v, of})(t) == v(quantity));
    };
    check(Of::parameter, t);
    check(Of::curvature, 2 / pow(Polynomial{1, 0, 1}, 2)(t));
  });
}

TEST_CASE(
    "feedrate: a speed that is 0, infinite or negative on the curve is refused, with the place") {
  const auto refused = [](const RationalFunction& v, Of of, const char* why) {
    CHECK_THROWS_WITH_AS(travel_time_rate(plane, {v, of}), doctest::Contains(why), DomainError);
  };
  refused(polynomial({1, -2}), Of::parameter, "is 0 at t = 1/2");
  refused(polynomial({-1, 0, 2}), Of::parameter, "is 0 at t ≈ 0.707106781187");
  refused(polynomial({1, -1}), Of::parameter, "is 0 at t = 1");
  refused(polynomial({2, -1}), Of::curvature, "is 0 at t = 0");
  refused(RationalFunction({1}, {-1, 3}), Of::parameter, "is infinite at t = 1/3");
  refused(polynomial({-5}), Of::parameter, "negative, -5");
  refused(RationalFunction(), Of::parameter, "is 0");
  refused(polynomial({-2, 1}), Of::parameter, "negative, -2 at t = 0");
  CHECK_NOTHROW(travel_time_rate(plane, {polynomial({Rational(10001, 10000), -1}), Of::parameter}));
  const Curve turning({{1}, {}, {}, {}}, {-1, 2});
  CHECK_THROWS_WITH_AS(travel_time_rate(turning, {polynomial({1}), Of::parameter}),
                       doctest::Contains("changes sign"), DomainError);
  const Curve line({{1}, {}, {}, {}});
  CHECK_THROWS_AS(travel_time_rate(line, {RationalFunction({1}, {0, 1}), Of::curvature}),
                  DomainError);
}
