#include "phrame/ph/along/path_length.hpp"

#include "phrame/algebra/error.hpp"
#include "phrame/ph/curve/special_points.hpp"
#include "support/paths.hpp"
#include "support/random.hpp"

namespace path_length_test {

using namespace phrame;
using test::for_samples;
using test::Random;

namespace {

/// A straight line with r′ = f·g² in the direction of x.
Curve line(const Polynomial& g, const Polynomial& f = {1}) { return Curve({g, {}, {}, {}}, f); }

/// The part of (9/32·t², 9/64·t³, 0) from a to b: |r′| = 9/16·t·√(1 + 9/16·t²), s = ((1 +
/// 9/16·t²)^{3/2} − 1)/3.
Segment part(const Rational& a, const Rational& b) {
  const Polynomial t{a, b - a};
  return RationalCurve({Rational(9, 32) * t * t, Rational(9, 64) * t * t * t, Polynomial()});
}

}  // namespace

// (5/4)³ = 125/64: the length is 61/192.
TEST_CASE("path length: what is elementary is exact, and told from what is given") {
  const PathLength length{Path(part(0, 1))};
  const Rational whole(61, 192);
  CHECK(length.total().exact() == whole);
  const Place end = length.point(whole);
  CHECK(end.t.exact() == Rational(1));
  CHECK(length.point(whole - power_of_two(-20000)).t.exact() == std::nullopt);
  CHECK(length.point(whole + power_of_two(-20000)).t.exact() == Rational(1));  // the same double
  CHECK_THROWS_AS(length.point(whole + power_of_two(-50)), DomainError);
  CHECK(length.value({0, Rational(1, 3)}).origin().is_irrational);
}

// √(1 + 9/16·4/25) = √109/10 is in the lengths of both parts.
TEST_CASE("path length: roots cancel where a curve is cut, and so does a parameter in a part") {
  const PathLength length(joined({part(0, Rational(2, 5)), part(Rational(2, 5), 2)}));
  CHECK_FALSE(length.before(1).exact());
  CHECK(length.value({1, Rational(3, 8)}).exact() == Rational(61, 192));  // t = 1
  const PathLength to_end(joined({part(0, Rational(2, 5)), part(Rational(2, 5), 1)}));
  CHECK(to_end.total().exact() == Rational(61, 192));
  CHECK(to_end.point(Rational(61, 192)).segment == 1);
}

TEST_CASE("path length: what rounds to the same double as the length is the end of the curve") {
  long beyond = 0;
  for_samples(20, [&](Random& random) {
    const PathLength length{Path(PhSegment(random.curve(2)))};
    const Rational total =
        length.total().exact() ? *length.total().exact() : length.total().enclose(200).upper();
    const Rational near = exact_rational(round_to_double(length.total()));
    if (near > total) ++beyond;
    const Place end = length.point(std::max(near, total));
    CHECK((end.segment == 0 && end.t.exact() == Rational(1)));
    if (const auto s = length.closed_form(0); s && near > total)
      CHECK(s->parameter(near).exact() == Rational(1));
    const Rational next = near * (1 + power_of_two(-51));
    CHECK_THROWS_AS(length.point(next), DomainError);
  });
  CHECK(beyond > 0);
}

// s = 2t − t², s = t² and s = t + t³/3, joined: 1, 2 and 10/3.
TEST_CASE("path length: up to the joints, between points, and back") {
  const PathLength length{
      Path(test::chain({line({1}, {2, -2}), line({1}, {0, 2}), Curve({{1}, {}, {}, {0, 1}})}))};
  CHECK(length.total().exact() == Rational(10, 3));
  CHECK(length.before(0).exact() == Rational(0));
  CHECK(length.before(2).exact() == Rational(2));
  CHECK(length.of_segment(2).exact() == Rational(4, 3));
  CHECK(length.value({1, Rational(1, 2)}).exact() == Rational(5, 4));
  const auto place = [&](const Rational& s) {
    const Place point = length.point(s);
    return std::pair(point.segment, point.t.exact().value());
  };
  using Reached = std::pair<std::size_t, Rational>;
  CHECK(place(0) == Reached(0, 0));
  CHECK(place(Rational(3, 4)) == Reached(0, Rational(1, 2)));
  CHECK(place(1) == Reached(1, 0));
  CHECK(place(Rational(5, 4)) == Reached(1, Rational(1, 2)));
  CHECK(place(2) == Reached(2, 0));
  CHECK(place(Rational(10, 3)) == Reached(2, 1));
  CHECK_THROWS_WITH_AS(length.point(4), "arc length: 4 is outside [0, 10/3]", DomainError);
  CHECK_THROWS_AS(length.point(Rational(-1, 9)), DomainError);
}

// The second segment turns back at its middle: half a length there, half a length back: s − 1 is
// t − t², and 1/2 − (t − t²) behind it.
TEST_CASE("path length: a segment that turns back has a length, no polynomial, and roots") {
  const PathLength length{Path(test::chain({line({1}), line({1}, {1, -2}), line({1}, {-1})}))};
  CHECK(length.before(1).exact() == Rational(1));
  CHECK(length.of_segment(1).exact() == Rational(1, 2));
  CHECK(length.total().exact() == Rational(5, 2));
  CHECK(length.closed_form(0) != nullptr);
  CHECK(length.closed_form(1) == nullptr);
  CHECK(length.closed_form(2)->total() == 1);
  CHECK(length.value({1, Rational(3, 4)}).exact() == 1 + Rational(1, 4) + Rational(1, 16));
  CHECK(length.point(1 + Rational(3, 16)).t.exact() == Rational(1, 4));
  CHECK(length.point(1 + Rational(5, 16)).t.exact() == Rational(3, 4));
  CHECK(length.point(1 + Rational(1, 4)).t.exact() == Rational(1, 2));
  // 1/2 − t + t² = 3/8, t > 1/2: 8t² − 8t + 1.
  const Place behind = length.point(1 + Rational(3, 8));
  CHECK(algebraic_number(behind)->polynomial() == Polynomial{1, -8, 8});
  CHECK(compare(*algebraic_number(behind), Rational(1, 2)) > 0);
  CHECK(length.point(Rational(3, 2)).segment == 2);
}

// r′ = t² − 1/2: √2/3 − 1/6 in all, and t/2 − t³/3 = s before √(1/2).
TEST_CASE("path length: a sign that changes at an irrational t") {
  const PathLength length{Path(PhSegment(line({1}, {Rational(-1, 2), 0, 1})))};
  CHECK(round_to_decimal(length.total(), 30).value == "0.304737854124365016267229574737");
  CHECK_FALSE(length.value({0, Rational(3, 4)}).exact());
  CHECK(length.value({0, Rational(1, 2)}).exact() == Rational(1, 4) - Rational(1, 24));
  const Place before = length.point(Rational(1, 5));
  CHECK(algebraic_number(before)->polynomial() == Polynomial{6, -15, 0, 10});
  CHECK_FALSE(algebraic_number(length.point(Rational(3, 10))));
}

TEST_CASE("path length: law: s and its inverse belong together, and pieces add up") {
  for_samples(30, [](Random& random) {
    const Curve curve(random.quaternion_polynomial(2));
    const PathLength length{Path(test::cut(curve, {Rational(1, 3), Rational(1, 2)}))};
    const ArcLength whole(curve);
    CHECK(length.total().exact() == whole.total());
    const Rational s = whole.total() * Rational(random.integer(0, 60), 60);
    const Place point = length.point(s);
    CHECK(algebraic_number(point));
    CHECK(length.value(point).exact() == s);
    const Real there = value(length.closed_form(point.segment)->polynomial(), point);
    CHECK((there + length.before(point.segment)).exact() == s);
  });
}

}  // namespace path_length_test
