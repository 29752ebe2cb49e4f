#include "phrame/ph/curve/direction_span.hpp"

#include "phrame/ph/along/up_vector.hpp"
#include "phrame/ph/curve/vector.hpp"
#include "support/expression_curves.hpp"

using namespace phrame;
using test::expression_curve;

namespace {

std::optional<Vector<Rational>> normal_of(const Vector<const char*>& r) {
  return plane_normal(Path(expression_curve(r, "1", "2")));
}

bool is_line(const Vector<const char*>& r) {
  return is_straight(Path(expression_curve(r, "1", "2")));
}

}  // namespace

TEST_CASE("direction span: lines are seen by the form of the formulas") {
  CHECK(is_line({"s", "2*s - 1", "3 - s"}));
  CHECK(is_line({"exp(s) + 1", "5", "-3/2*exp(s)"}));
  CHECK(is_line({"s + pi*s", "2*s + 2*pi*s", "0"}));
  CHECK_FALSE(is_line({"s", "2*s - 1", "3*pi*s"}));  // in the span of two directions
  CHECK_FALSE(is_line({"s", "s^2", "0"}));
}

TEST_CASE("direction span: planes have their normal") {
  CHECK(normal_of({"cos(s)", "sin(s)", "7"}) == Vector<Rational>{0, 0, 1});
  // x + y + z = 2 sin s + 2 cos s − 2(cos s + sin s) = 0
  const auto diagonal = normal_of({"sin(s) + 2*cos(s)", "sin(s)", "-2*(sin(s) + cos(s))"});
  REQUIRE(diagonal);
  CHECK(cross(*diagonal, {1, 1, 1}) == Vector<Rational>{});
  CHECK(normal_of({"cos(s)", "sin(s)", "s"}) == std::nullopt);
  CHECK(normal_of({"s", "2*s", "s"}) == std::nullopt);
}

TEST_CASE("direction span: that of a rational curve is of the coefficients of H") {
  const RationalCurve parabola({Polynomial{0, 2}, {1, 0, 3}, {0, 2, 3}});  // H = (1, 3t, 1 + 3t)
  CHECK(direction_span(parabola) == std::vector<Vector<Rational>>{{1, 0, 1}, {0, 3, 3}});
  // Of a path, those that are independent, the first ones.
  const Path path = joined({RationalCurve({Polynomial{0, 1}, {}, {}}),
                            RationalCurve({Polynomial{1, 1}, {0, 0, 1}, {}}),
                            RationalCurve({Polynomial{2, 1}, Polynomial{1, 2}, {0, 0, 1}}),
                            RationalCurve({Polynomial{3, 1}, Polynomial{3, 2}, Polynomial{1, 2}})});
  CHECK(direction_span(path) == std::vector<Vector<Rational>>{{1, 0, 0}, {0, 2, 0}, {0, 0, 2}});
}

TEST_CASE("direction span: the up vector of formulas is nowhere along the tangent") {
  const Path helix(expression_curve({"3*cos(s)", "3*sin(s)", "4*s"}, "0", "4*pi"));
  const Vector<Rational> v = up_vector(helix);
  CHECK(!tangent_along(helix.segments().front(), v));
  // s = π/2 is t = 1/8, where r′ = (−3, 0, 4).
  const auto place = tangent_along(helix.segments().front(), {-3, 0, 4});
  REQUIRE(place);
  CHECK(place->is_certain);
  CHECK(place->place.lower == Rational(1, 8));
}
