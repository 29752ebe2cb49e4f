#include "phrame/io/read/feedrate.hpp"

#include <doctest/doctest.h>

#include "phrame/algebra/error.hpp"

using namespace phrame;
using Of = Feedrate::Of;

TEST_CASE("feedrate text: the variable says what the speed depends on") {
  CHECK(parse_feedrate("50") == Feedrate{RationalFunction({50}, {1}), Of::arc_length});
  CHECK(parse_feedrate("10 + 2*s") == Feedrate{RationalFunction({10, 2}, {1}), Of::arc_length});
  CHECK(parse_feedrate("5+t^2") == Feedrate{RationalFunction({5, 0, 1}, {1}), Of::parameter});
  const Feedrate curved{RationalFunction({5}, {1, 2}), Of::curvature};
  CHECK(parse_feedrate("5/(1 + 2*kappa)") == curved);
  CHECK(parse_feedrate("5/(1+2*κ)") == curved);
  CHECK(parse_feedrate("0.1") ==
        Feedrate{RationalFunction({Rational(1, 10)}, {1}), Of::arc_length});
}

TEST_CASE("feedrate text: other variables and what is no rational function are refused") {
  CHECK_THROWS_WITH_AS(parse_feedrate("2*x"), doctest::Contains("\"x\" is not one of s"),
                       InputError);
  CHECK_THROWS_WITH_AS(parse_feedrate("s+t"), doctest::Contains("a second variable, \"t\""),
                       InputError);
  CHECK_THROWS_WITH_AS(parse_feedrate("sqrt(s)"), doctest::Contains("only rational functions"),
                       InputError);
  CHECK_THROWS_WITH_AS(parse_feedrate("2s"), doctest::Contains("2*s"), InputError);
  CHECK_THROWS_WITH_AS(parse_feedrate(""), doctest::Contains("empty"), InputError);
}
