#include "phrame/algebra/elementary.hpp"

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/rounding.hpp"
#include "support/random.hpp"

namespace elementary_test {

using namespace phrame;

TEST_CASE("elementary: all functions at 1/2 (Abramowitz & Stegun, chapter 4; by mpmath)") {
  const std::pair<const char*, const char*> values[] = {
      {"exp", "1.6487212707001281468"},      {"expm1", "0.64872127070012814685"},
      {"log", "-0.69314718055994530942"},    {"log1p", "0.40546510810816438198"},
      {"sin", "0.47942553860420300027"},     {"cos", "0.87758256189037271612"},
      {"tan", "0.54630248984379051326"},     {"arcsin", "0.52359877559829887308"},
      {"arccos", "1.0471975511965977462"},   {"arctan", "0.46364760900080611621"},
      {"sinh", "0.52109530549374736162"},    {"cosh", "1.1276259652063807852"},
      {"tanh", "0.46211715726000975850"},    {"arcsinh", "0.48121182505960344750"},
      {"arctanh", "0.54930614433405484570"}, {"sqrt", "0.70710678118654752440"}};
  for (const auto& value : values) {
    const char* name = value.first;
    const Real x = elementary(name, Rational(1, 2), true);
    CHECK_MESSAGE(round_to_decimal(x, 20).value == value.second, name);
    CHECK(x.origin().is_irrational);
  }
  CHECK(round_to_decimal(elementary("arccosh", Rational(2), true), 20).value ==
        "1.3169578969248167086");
}

TEST_CASE("elementary: rational values are exact, and outside of the domain there are none") {
  for (const auto& [name, x, value] : {std::tuple{"exp", 0, 1},
                                       {"log", 1, 0},
                                       {"cos", 0, 1},
                                       {"arccos", 1, 0},
                                       {"arccosh", 1, 0},
                                       {"sqrt", 9, 3},
                                       {"arctanh", 0, 0},
                                       {"log1p", 0, 0}})
    CHECK(elementary(name, Rational(x), true).exact() == Rational(value));
  for (const auto& [name, x] : {std::pair{"log", 0},
                                {"log", -1},
                                {"log1p", -1},
                                {"log1p", -2},
                                {"arcsin", 2},
                                {"arccos", -2},
                                {"arccosh", 0},
                                {"arctanh", 1},
                                {"arctanh", -3},
                                {"sqrt", -1},
                                {"no such", 1}})
    CHECK_THROWS_AS(elementary(name, Rational(x), true), DomainError);
  const Real root = square_root_of(2);
  CHECK_THROWS_AS(elementary("arcsin", root, true), DomainError);
  CHECK_THROWS_AS(elementary("log", -root, true), DomainError);
  CHECK(elementary("log", root, true).origin().is_irrational);
  CHECK(!elementary("log", root, false).origin().is_irrational);  // e, say
}

TEST_CASE("elementary: powers and angles") {
  const Real root = square_root_of(2);
  CHECK(round_to_decimal(power_of(Rational(2), root), 20).value == "2.6651441426902251887");
  CHECK(round_to_decimal(power_of(root, 5), 20).value == "5.6568542494923801952");
  CHECK(round_to_decimal(power_of(root, -5), 20).value == "0.17677669529663688110");
  CHECK(power_of(Rational(2, 3), -3).exact() == Rational(27, 8));
  CHECK(power_of(root, 0).exact() == Rational(1));
  CHECK(round_to_decimal(arctan2_of(Rational(-1), Rational(-1)), 20).value ==
        "-2.3561944901923449288");
  CHECK(arctan2_of(Rational(0), Rational(3)).exact() == Rational(0));
  CHECK(round_to_double(arctan2_of(Rational(0), Rational(-3))) == 0x1.921fb54442d18p+1);
  CHECK_THROWS_AS(arctan2_of(Rational(0), Rational(0)), DomainError);
  CHECK_THROWS_AS(power_of(Rational(-2), root), DomainError);
}

}  // namespace elementary_test
