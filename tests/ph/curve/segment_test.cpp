#include "phrame/ph/curve/segment.hpp"
#include "phrame/ph/along/path_angle.hpp"

#include <algorithm>

#include "phrame/algebra/error.hpp"
#include "phrame/ph/curve/real_vector.hpp"
#include "phrame/ph/curve/vector.hpp"
#include "phrame/ph/frame/frame.hpp"
#include "phrame/ph/frame/path_frame.hpp"
#include "support/curves.hpp"
#include "support/expression_curves.hpp"
#include "support/paths.hpp"
#include "support/random.hpp"

using namespace phrame;

namespace {

constexpr long bits = 200;

bool are_equal(const Vector<Real>& a, const Vector<Real>& b) {
  for (std::size_t k = 0; k < 3; ++k) {
    const RealBall difference = subtract(a[k].enclose(bits), b[k].enclose(bits), bits);
    if (!difference.contains_zero() || difference.radius() > power_of_two(-150)) return false;
  }
  return true;
}

void check_equal(const Frame<Real>& a, const Frame<Real>& b) {
  CHECK(are_equal(a.e1, b.e1));
  CHECK(are_equal(a.e2, b.e2));
  CHECK(are_equal(a.e3, b.e3));
}

/// The same curve by its preimage, by its positions or by formulas.
Segment given_as(int kind, const Curve& curve) {
  if (kind == 0) return PhSegment(curve);
  if (kind == 1) return RationalCurve(position(curve));
  const auto text = [](const Polynomial& p) {
    std::string in_s = to_string(p);
    std::replace(in_s.begin(), in_s.end(), 't', 's');
    return in_s;
  };
  const Vector<Polynomial> r = position(curve);
  const std::string x = text(r[0]), y = text(r[1]), z = text(r[2]);
  return test::expression_curve({x.c_str(), y.c_str(), z.c_str()}, "0", "1");
}

}  // namespace

// The closed form of the whole PH path against sums along pieces of every kind, in every order.
TEST_CASE("segment: law: frames do not depend on what is known of the pieces") {
  const PhPath exact = test::cut(test::quintic, {Rational(1, 3), Rational(3, 4)});
  const PathAngle theta(exact);
  const FrameAngle start = start_angle(LeastRotation{}, exact);
  const auto rmf = [&](std::size_t segment, const Rational& t) {
    const Frame<Rational> erf = euler_rodrigues_frame(exact.segments()[segment], t);
    return turned(as_real(erf), theta.value(PathParameter{segment, t}, start));
  };
  for (int kinds = 0; kinds < 27; ++kinds) {
    CAPTURE(kinds);
    const int kind[] = {kinds % 3, kinds / 3 % 3, kinds / 9};
    Path path(given_as(kind[0], exact.segments()[0]));
    for (std::size_t k = 1; k < 3; ++k) path.append(given_as(kind[k], exact.segments()[k]));
    CHECK(path.ph().has_value() == (kinds == 0));
    const PathAngle angle(path, {Rational(3), Rational(-3), Rational(2)});
    const StartAngle from = start_angle(LeastRotation{}, angle);
    for (std::size_t k = 0; k < 3; ++k) {
      const Place at(k, Rational(2, 5));
      check_equal(rotation_minimizing_frame(angle, at, from), rmf(k, Rational(2, 5)));
      if (kind[k] == 0)
        check_equal(euler_rodrigues_frame(path, at),
                    as_real(euler_rodrigues_frame(exact.segments()[k], Rational(2, 5))));
      else
        CHECK_THROWS_AS(euler_rodrigues_frame(path, at), DomainError);
    }
  }
}

TEST_CASE("segment: a path of PH curves alone is that path") {
  const PhPath loop = test::closed_loop();
  CHECK(Path(loop).ph() == loop);
  CHECK(Path(loop).is_closed());
  CHECK(NamedPhPath("loop", loop).name == "loop");
}

TEST_CASE("segment: law: by its positions a PH curve has the e1 of its preimage") {
  test::for_samples(20, [](test::Random& random) {
    const PhSegment segment(random.curve(2));
    const Vector<Rational> H = evaluate(segment.by_positions().direction(), 0);
    const Vector<Rational> e1 = euler_rodrigues_frame(segment.curve(), 0).e1;
    CHECK(dot(H, e1) > 0);
    CHECK(cross(H, e1) == Vector<Rational>{});
    CHECK(dot(evaluate(segment.turned_over().by_positions().direction(), 0), e1) < 0);
    CHECK(orientation(Segment(segment)) == -orientation(segment.turned_over()));
  });
}

// At t with t² = 1/2, known by enclosures only, and at a fraction.
TEST_CASE("segment: the Euler-Rodrigues frame at any real t is that of the preimage") {
  const Path path{PhPath(test::quintic)};
  const Real t = square_root_of(Rational(1, 2));
  const Frame<Real> found = euler_rodrigues_frame(path, {0, t});
  const Vector<Polynomial> e2 = rotated_j(test::quintic.preimage());
  for (std::size_t k = 0; k < 3; ++k) {
    const Real expected = quotient_of(value(e2[k], t), value(sigma(test::quintic.preimage()), t));
    CHECK(subtract(found.e2[k].enclose(bits), expected.enclose(bits), bits).contains_zero());
  }
}
