#include "phrame/ph/along/path_totals.hpp"

#include "phrame/algebra/error.hpp"
#include "phrame/ph/curve/shape.hpp"
#include "support/curves.hpp"
#include "support/paths.hpp"
#include "support/random.hpp"

namespace path_totals_test {

using namespace phrame;
using test::chain;
using test::cut;
using test::for_samples;
using test::Random;
using Terms = std::vector<PathTotal::Term>;

namespace {

/// Half of a screw: the tangent has a constant angle to an axis.
const Curve screw({{1}, {0, 1}, {0, 1}, {}});
/// √2 stands before its total curvature, whose value is known from the tests of totals.
const Curve oblique({{1, 1, -1}, {0, 1, -1}, {0, -1, 1}, {1, -1, 1}});

std::string digits(const Real& x, long count = 25) { return round_to_decimal(x, count).value; }

const PathTotal& finite(const std::variant<PathTotal, Infinite>& total) {
  return std::get<PathTotal>(total);
}

void check_equal(const PathTotal& pieces, const Real& whole) {
  CHECK(digits(pieces.value, 50) == digits(whole, 50));
}

}  // namespace

TEST_CASE("path totals: pieces of a curve have the totals of the whole") {
  const auto check = [](const Curve& curve, const std::vector<Rational>& at) {
    const PhPath pieces = cut(curve, at);
    CHECK(pieces.segments().size() == at.size() + 1);
    check_equal(total_length(pieces), total_length(curve).value);
    check_equal(erf_twist(pieces), erf_twist(curve).value);
    check_equal(total_torsion(pieces), total_torsion(curve).value);
    const auto energy = bending_energy(curve);
    check_equal(finite(bending_energy(pieces)), std::get<Total>(energy).value);
    const auto frenet = frenet_energy(curve);
    check_equal(finite(frenet_energy(pieces)), std::get<Total>(frenet).value);
    if (const auto curvature = total_curvature(curve))
      check_equal(total_curvature(pieces).value(), curvature->value);
  };
  check(test::quintic, {Rational(1, 3)});
  check(test::quintic, {Rational(1, 7), Rational(1, 2), Rational(9, 10)});
  check(screw, {Rational(1, 3), Rational(1, 2)});
  check(oblique, {Rational(1, 3)});  // its curvature changes sign at 1/2
  check(Curve({{0, 3, 0, -1}, {0, 0, -3}, {}, {3}}, {Rational(1, 3)}), {Rational(2, 5)});
}

// κ ds = 2/(1 + t²) dt and κ² ds = 4/(1 + t²)³ dt on each of four segments: π/2 and 1 + 3π/8, those
// of f = 1/2 scaled alike.
TEST_CASE("path totals: of a closed plane curve, by hand") {
  const PhPath loop = test::closed_loop();
  CHECK(total_length(loop).value.exact() == Rational(16, 3));
  CHECK(erf_twist(loop).value.exact() == Rational(0));
  CHECK(total_torsion(loop).value.exact() == Rational(0));
  CHECK(total_curvature(loop).value().exact == Terms{{1, {0, 2, {}, {}}}});
  CHECK(absolute_rotation_index(loop).value().exact() == Rational(1));
  CHECK(finite(bending_energy(loop)).exact == Terms{{1, {4, Rational(3, 2), {}, {}}}});
}

// 3·2·arctan(√2t/(1 − t)) from 0 to 3π, about i − k, cut where the parts are no multiples of π.
TEST_CASE("path totals: the index of a path that turns one way is exact in any plane") {
  const QuaternionPolynomial turn{{1, -1}, {0, 1}, {}, {0, -1}};
  const Curve curve(turn * turn * turn * QuaternionPolynomial{{1}, {}, {}, {1}});
  const PhPath pieces = cut(curve, {Rational(1, 3), Rational(3, 4)});
  CHECK(total_curvature(pieces).value().segments[0].radicand == 2);
  CHECK_FALSE(absolute_rotation_index(pieces.segments()[0]).value().exact());
  CHECK(absolute_rotation_index(pieces).value().exact() == Rational(3, 2));
  // With a straight line between, which turns neither way.
  const Curve line({{1}, {}, {}, {}});
  const Curve left({{1}, {}, {}, {0, 1}});
  const Curve right({{1}, {}, {}, {0, -1}});
  const auto index = [](const std::vector<Curve>& curves) {
    return absolute_rotation_index(chain(curves)).value();
  };
  CHECK(index({reversed(rotated(reversed(left), {1, 0, 0, 0})), rotated(line, {1, 0, 0, 1})})
            .exact() == Rational(1, 4));
  CHECK(index({line, left}).exact() == Rational(1, 4));
  CHECK(index({line, left, rotated(line, {1, 0, 0, 1}), rotated(right, {1, 0, 0, 1})}).exact() ==
        Rational(1, 2));
  CHECK(index({line, line}).exact() == Rational(0));
  CHECK_FALSE(absolute_rotation_index(cut(test::quintic, {Rational(1, 2)})));
}

// 2·arctan(1/2) and then 2·arctan(1/3) to the other side.
TEST_CASE("path totals: the index of a path that turns back is that of its parts") {
  const Curve left({{2}, {}, {}, {0, 1}});
  const Curve right =
      Curve(QuaternionPolynomial{{3}, {}, {}, {0, -1}} * QuaternionPolynomial{{2}, {}, {}, {1}});
  const PhPath path = chain({left, right});
  CHECK(total_curvature(path).value().exact == Terms{{1, {0, Rational(1, 2), {}, {}}}});
  CHECK(absolute_rotation_index(path).value().exact() == Rational(1, 4));
}

// In a plane with the normal i − k and then in that of x and y: the tangent starts as j each time.
// 1.359347637816487748385570 + π/2.
TEST_CASE("path totals: the roots before the integrals of different segments may differ") {
  const Curve flat({{1, -1}, {}, {}, {1, 1}});
  const PathTotal total = total_curvature(chain({oblique, flat})).value();
  CHECK(total.segments[0].radicand == 2);
  CHECK(total.segments[1].radicand == 1);
  CHECK(digits(total.value) == "2.930143964611384367616892");
}

TEST_CASE("path totals: an energy is infinite where that of a segment is") {
  const Curve cusp({{1}, {}, {0, 1}, {}}, {-1, 2});
  const PhPath path =
      chain({Curve({{1}, {}, {0, 1}, {}}, {-1}), Curve({{1}, {}, {1, 1}, {}}, {-2, 1})});
  CHECK(std::holds_alternative<PathTotal>(bending_energy(path)));
  const PhPath stopped = cut(Curve({{1}, {}, {0, 1}, {}}, {-2, 4}), {Rational(1, 3)});
  const auto energy = bending_energy(stopped);
  // 1/2 is at (1/2 − 1/3)/(2/3) = 1/4 of the second segment.
  CHECK(std::get<Infinite>(energy) == Infinite{Rational(5, 4), 1});
  CHECK(std::holds_alternative<Infinite>(frenet_energy(stopped)));
  CHECK(std::holds_alternative<Infinite>(bending_energy(cusp)));
  CHECK_THROWS_AS(total_torsion(chain({Curve({{1}, {}, {}, {}}), screw})), DomainError);
}

TEST_CASE("path totals: law: pieces of random curves have the totals of the whole") {
  for_samples(15, [](Random& random) {
    const Curve curve(random.quaternion_polynomial(2));
    if (line_direction(curve.preimage())) return;
    const PhPath pieces = cut(curve, {Rational(random.integer(1, 6), 7)});
    check_equal(total_length(pieces), total_length(curve).value);
    check_equal(erf_twist(pieces), erf_twist(curve).value);
    check_equal(total_torsion(pieces), total_torsion(curve).value);
    const auto whole = bending_energy(curve);
    const auto energy = bending_energy(pieces);
    REQUIRE(whole.index() == energy.index());
    if (whole.index() == 0) check_equal(finite(energy), std::get<Total>(whole).value);
  });
}

}  // namespace path_totals_test
