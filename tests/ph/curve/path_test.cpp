#include "phrame/ph/curve/path.hpp"

#include <doctest/doctest.h>

#include "phrame/algebra/error.hpp"
#include "phrame/ph/curve/place.hpp"
#include "support/expression_curves.hpp"
#include "support/paths.hpp"
#include "support/refusal.hpp"

using namespace phrame;

namespace {

std::string complaint(const RationalCurve& first, const RationalCurve& second) {
  return test::refusal_of<DomainError>([&] {
    Path path{Segment(first)};
    path.append(second);
  });
}

RationalCurve quarter(long turns) {
  const std::vector<Vector<Rational>> square{{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}};
  const auto at = [&](long k) { return square[static_cast<std::size_t>(k % 4)]; };
  const Vector<Rational> a = at(turns), b = at(turns + 1);
  return bezier_curve({a, {a[0] + b[0], a[1] + b[1], 0}, b}, {1, 1, 2});
}

}  // namespace

TEST_CASE("path: copies share their segments, until one of them grows") {
  Path path(quarter(0));
  const Path copy = path;
  CHECK(&copy.segments() == &path.segments());
  path.append(quarter(1));
  CHECK(copy.segments().size() == 1);
  CHECK(copy == Path(quarter(0)));
  CHECK(path == joined({quarter(0), quarter(1)}));
  CHECK_FALSE(path == copy);
}

TEST_CASE("path: a joint at which it does not go on or turns back is refused, with what differs") {
  const RationalCurve line({Polynomial{0, 1}, {}, {}});
  CHECK(complaint(line, line) == "it starts at (0, 0, 0), but the spline ends at (1, 0, 0)");
  CHECK(complaint(line, RationalCurve({Polynomial{1, 2}, Polynomial{0, 0, 1}, {}})).empty());
  CHECK(complaint(line, RationalCurve({Polynomial{1, -2}, {}, {}})) ==
        "the tangent turns back: the spline ends in the direction (1, 0, 0), and it starts in the "
        "opposite one, so that frames are undefined there");
}

TEST_CASE("path: a circle of four rational arcs is closed, three of them are not") {
  Path path{Segment(quarter(0))};
  path.append(quarter(1));
  path.append(quarter(2));
  CHECK_FALSE(path.ends_meet());
  path.append(quarter(3));
  CHECK(path.ends_meet());
  CHECK(path.is_closed());
  CHECK(path.end() == 4);
  CHECK(locate(path, Rational(5, 2)).segment == 2);
  CHECK_THROWS_AS(locate(path, Rational(17, 4)), DomainError);
  // A drop: its ends meet at a corner of 90°.
  const Path drop{Segment(bezier_curve({{0, 0, 0}, {1, 1, 0}, {-1, 1, 0}, {0, 0, 0}}))};
  CHECK(drop.is_closed());
  CHECK(drop.closes_at_corner());
  CHECK_FALSE(path.closes_at_corner());
}

TEST_CASE("path: behind a cusp segments are turned over, so that e1 is continuous") {
  // r = (t − t², 0, 0) turns back at 1/2 and ends with the tangent (−1, 0, 0), e₁ = (1, 0, 0).
  const RationalCurve there_and_back({Polynomial{0, 1, -1}, {}, {}});
  const RationalCurve on({Polynomial{0, -1}, Polynomial{0, 0, 1}, {}});
  Path path{Segment(there_and_back)};
  path.append(on);
  const auto& last = std::get<RationalCurve>(path.segments().back());
  CHECK(evaluate(last.direction(), 0)[0] > 0);
  CHECK(last.multiplier() == Polynomial{-1});
}

TEST_CASE("path: a PH path by its positions has its points, and is as closed") {
  const PhPath loop = test::closed_loop();
  const Path path = test::by_positions(loop);
  REQUIRE(path.segments().size() == loop.segments().size());
  CHECK(path.is_closed());
  for (std::size_t k = 0; k < loop.segments().size(); ++k)
    CHECK(std::get<RationalCurve>(path.segments()[k]).numerator() == position(loop.segments()[k]));
}

TEST_CASE("path: a curve that turns back at a cusp to where it came from is not closed") {
  // Along y = x² from 0 to x = 1/4 and back: e₁ is (1, 0, 0) at both ends, r′/|r′| is not.
  const Curve back_and_forth(QuaternionPolynomial{{1}, {}, {}, {0, 1, -1}}, Polynomial{1, -2},
                             {0, 0, 0});
  const PhPath parabola(back_and_forth);
  CHECK(parabola.ends_meet());
  CHECK_FALSE(Path(parabola).is_closed());
  CHECK(test::by_positions(parabola).ends_meet());
  CHECK_FALSE(test::by_positions(parabola).is_closed());
}

TEST_CASE("path: formulas join by their values, and with rational curves") {
  const auto arc = [](const char* from, const char* to) {
    return test::expression_curve({"cos(s)", "sin(s)", "0"}, from, to);
  };
  Path path(arc("0", "1/3"));
  path.append(arc("1/3", "pi/2"));
  CHECK_THROWS_AS(path.append(arc("0", "1")), DomainError);     // another point
  CHECK_THROWS_AS(path.append(arc("pi/2", "0")), DomainError);  // the opposite direction
  path.append(RationalCurve({Polynomial{0, -1}, {1}, {}}));     // (0, 1) to (−1, 1)
  CHECK_THROWS_AS(path.append(arc("pi", "4")), DomainError);
  CHECK(path.segments().size() == 3);
  CHECK_FALSE(path.ends_meet());
  CHECK(Path(arc("1", "1 + 2*pi")).is_closed());
  // It starts at sin²(1) + cos²(1), which no form says is 1.
  const Path line(RationalCurve({Polynomial{0, 1}, {}, {}}));
  CHECK_THROWS_AS(Path(line).append(
                      test::expression_curve({"sin(s)^2 + cos(s)^2 + s - 1", "0", "0"}, "1", "2")),
                  Undecided);
}

TEST_CASE("path: formulas behind a cusp are turned over") {
  Path path(RationalCurve({Polynomial{0, 1, -1}, {}, {}}));  // there and back
  path.append(test::expression_curve({"-sin(s)", "1 - cos(s)", "0"}, "0", "1"));
  CHECK(orientation(path.segments().back()) == -1);
  CHECK(*direction(path, {1, Rational(0)})[0].exact() > 0);  // e₁ goes on
}

TEST_CASE("path: periods with roots are closed, and arcs by formulas join lines at 60°") {
  const auto knot = [](const char* to) {
    return Path(
        test::expression_curve({"cos(sqrt(2)*s)", "sin(sqrt(2)*s)", "sin(sqrt(8)*s)"}, "0", to));
  };
  CHECK(knot("2*pi/sqrt(2)").is_closed());
  CHECK(knot("sqrt(2)*pi").is_closed());
  CHECK_FALSE(knot("pi/sqrt(2)").ends_meet());
  Path path(test::expression_curve({"cos(s)", "sin(s)", "0"}, "0", "pi/3"));
  path.append(test::expression_curve({"1/2 - sqrt(3)*s", "sqrt(3)/2 + s", "0"}, "0", "1"));
  CHECK(path.corners().empty());
  path.append(
      test::expression_curve({"1/2 - sqrt(3) + s", "sqrt(3)/2 + 1 - sqrt(3)*s", "0"}, "0", "1"));
  CHECK(path.corners() == std::vector<std::size_t>{2});
  CHECK_THROWS_AS(path.append(test::expression_curve(
                      {"3/2 - sqrt(3) - s", "1 - sqrt(3)/2 + sqrt(3)*s", "0"}, "0", "1")),
                  DomainError);
}

// The period is written so that no form says that it is one.
TEST_CASE("path: where it is not told whether a path is closed, that is what is known") {
  const auto ends = [](const char* to) {
    return closure(
        Path(test::expression_curve({"cos(exp(1)*s)", "sin(exp(1)*s)", "0"}, "exp(-1)", to)));
  };
  const Closure undecided = ends("exp(-1)*(1 + 2*pi)");
  CHECK_FALSE(undecided.ends_meet);
  CHECK_FALSE(undecided.is_closed);
  CHECK(undecided.undecided ==
        "whether the ends of the curve meet is not told: they agree to 1024 bits");
  CHECK(ends("1").ends_meet == false);
  CHECK(ends("1").is_closed == false);
}
