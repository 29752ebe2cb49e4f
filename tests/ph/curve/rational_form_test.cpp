#include "phrame/ph/curve/rational_form.hpp"

#include <doctest/doctest.h>

#include "phrame/algebra/error.hpp"
#include "phrame/io/read/formula.hpp"

using namespace phrame;

namespace {

std::optional<RationalCurve> form(const Vector<const char*>& r, const char* from, const char* to) {
  const auto read = [](const char* text) { return parse_formula(text, "s").value; };
  return rational_form({read(r[0]), read(r[1]), read(r[2])}, read(from), read(to));
}

}  // namespace

TEST_CASE("rational form: formulas of polynomials and quotients are a rational curve") {
  // s = 1 + 2t
  CHECK(form({"s^2", "(s - 1)*(s + 1)/2", "1"}, "1", "3") ==
        RationalCurve({Polynomial{1, 4, 4}, {0, 2, 2}, {1}}));
  CHECK(form({"(1 - s^2)/(1 + s^2)", "2*s*(1 + s^2)^-1", "0"}, "0", "1") ==
        RationalCurve({Polynomial{1, 0, -1}, {0, 2}, {}}, Polynomial{1, 0, 1}));
  // s = t/2, over (4 + t)(6 + t)
  CHECK(form({"1/(s + 2)", "1/(s + 3)", "s"}, "0", "1/2") ==
        RationalCurve({Polynomial{12, 2}, {8, 2}, {0, 12, 5, Rational(1, 2)}},
                      Polynomial{24, 10, 1}));
}

TEST_CASE("rational form: others are none") {
  CHECK(!form({"s", "sin(s)", "0"}, "0", "1"));
  CHECK(!form({"s", "pi*s", "0"}, "0", "1"));
  CHECK(!form({"s", "s^2", "0"}, "0", "pi"));
  CHECK(!form({"s", "s^(1/2)", "0"}, "1", "2"));
  CHECK(!form({"s", "s^100000", "0"}, "0", "1"));
  CHECK(!form({"s", "(((2^400)^400)^400)*s", "0"}, "0", "1"));
  CHECK(!form({"s", "s^2", "0"}, "1", "1"));
  CHECK_THROWS_WITH_AS(form({"s", "1/(s - 1)", "0"}, "0", "2"), "y has a pole at s = 1",
                       DomainError);
  CHECK_THROWS_WITH_AS(form({"s", "0", "s/(s^2 - 2)"}, "2", "1"),
                       doctest::Contains("z has a pole at s ≈ 1.41421356"), DomainError);
}
