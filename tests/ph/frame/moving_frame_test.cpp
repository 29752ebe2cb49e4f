#include "phrame/ph/frame/moving_frame.hpp"

#include "phrame/ph/frame/algebraic_frame.hpp"
#include "phrame/ph/frame/frame.hpp"
#include "support/curves.hpp"
#include "support/paths.hpp"

using namespace phrame;
using test::quintic;

namespace {

void check_equal(const Frame<Real>& a, const Frame<Real>& b) {
  CHECK(round_to_double(a.e1) == round_to_double(b.e1));
  CHECK(round_to_double(a.e2) == round_to_double(b.e2));
  CHECK(round_to_double(a.e3) == round_to_double(b.e3));
}

}  // namespace

// Other ways: the antiderivative itself at an algebraic number, and Frames at a rational one.
TEST_CASE("moving frame: at t of any kind as other ways have it") {
  const MovingFrame moving{PhPath(quintic), Angle()};
  const AlgebraicFrames frames(quintic);
  for (const Polynomial& p : {Polynomial{-1, 0, 2}, Polynomial{-1, 0, 0, 3}}) {
    const RealAlgebraic t = real_root(p, Interval{0, 1});
    const Frame<Real> expected = frames.rotation_minimizing(AlgebraicPoint(t));
    check_equal(moving.at({0, t}), expected);
    // The same number, as if it were transcendental.
    check_equal(moving.at({0, to_real(t)}), expected);
    CHECK(round_to_double(moving.tangent({0, to_real(t)})) == round_to_double(expected.e1));
  }
  const Rational third(1, 3);
  check_equal(moving.at({0, third}), rotation_minimizing_frame(quintic, RmfAngle(quintic), third));
}

// f₂ = −e₂ where the angle is π.
TEST_CASE("moving frame: it starts as it is told") {
  const MovingFrame moving(PhPath(quintic), Angle(Rational(1), Rational(0)));
  const Frame<Rational> erf = euler_rodrigues_frame(quintic, 0);
  const Frame<Real> start = moving.at({0, Rational(0)});
  for (std::size_t k = 0; k < 3; ++k)
    CHECK(round_to_double(start.e2[k]) == round_to_double(Rational(-erf.e2[k])));
}
