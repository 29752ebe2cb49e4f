#include "phrame/algebra/rational.hpp"

#include <cfenv>
#include <cmath>
#include <limits>

#include "phrame/algebra/error.hpp"
#include "support/random.hpp"

using namespace phrame;

TEST_CASE("rational: texts are read exactly") {
  CHECK(parse_rational("3/7") == Rational(3, 7));
  CHECK(parse_rational("-6/4") == Rational(-3, 2));
  CHECK(parse_rational("+2") == 2);
  CHECK(parse_rational("0.9515") == Rational(9515, 10000));
  CHECK(parse_rational("1e-3") == Rational(1, 1000));
  CHECK(parse_rational("-1.5E+2") == -150);
  CHECK(parse_rational(".5") == Rational(1, 2));
  CHECK(parse_rational("5.") == 5);
  CHECK(parse_rational("0x1.8p-3") == Rational(3, 16));
  CHECK(parse_rational("-0XaP1") == -20);
  CHECK(parse_rational("007") == 7);
  CHECK(parse_rational("0/5") == 0);
}

TEST_CASE("rational: 10^400 is not a double, and is read all the same") {
  Integer power = 1;
  for (int k = 0; k < 400; ++k) power *= 10;
  CHECK(parse_rational("1e400") == Rational(power));
  CHECK(parse_rational("1e-400") == 1 / Rational(power));
  CHECK(parse_rational("1" + std::string(400, '0')) == Rational(power));
}

TEST_CASE("rational: what is not a number is refused and quoted") {
  for (const char* text : {"",      " ",     "1 ",   " 1",       "1/0",
                           "0/0",   "nan",   "inf",  "-",        ".",
                           "1e",    "1e+",   "1//2", "1/2/3",    "1/-2",
                           "0x",    "0x.p1", "x1",   "1.2.3",    "1,5",
                           "1e5/2", "0x1/2", "--1",  "1e100001", "1e99999999999999999999",
                           "٣"}) {
    CAPTURE(text);
    CHECK_THROWS_AS(parse_rational(text), InputError);
    try {
      parse_rational(text);
    } catch (const InputError& error) {
      CHECK(error.reason().find(std::string("\"") + text + "\"") != std::string::npos);
    }
  }
}

TEST_CASE("rational: a number beyond the length limit is refused with the limit, in one line") {
  const std::string digits(1'000'000, '7');
  try {
    parse_rational(digits);
    FAIL("accepted");
  } catch (const InputError& error) {
    CHECK(error.reason().find("100000") != std::string::npos);
    CHECK(error.reason().find("1000000 characters") != std::string::npos);
    CHECK(error.reason().size() < 200);
  }
  CHECK(parse_rational(std::string(100'000, '1')) > 0);
}

TEST_CASE("rational: a double is taken exactly") {
  CHECK(exact_rational(0.1) == Rational(Integer("3602879701896397"), Integer("36028797018963968")));
  CHECK(exact_rational(-0.0) == 0);
  CHECK(exact_rational(0x1.8p-3) == Rational(3, 16));
  CHECK(exact_rational(std::numeric_limits<double>::denorm_min()) == parse_rational("0x1p-1074"));
  CHECK_THROWS_AS(exact_rational(std::numeric_limits<double>::quiet_NaN()), DomainError);
  CHECK_THROWS_AS(exact_rational(std::numeric_limits<double>::infinity()), DomainError);
}

TEST_CASE("rational: law: it becomes the nearest double, in any rounding mode") {
  test::for_samples(200, [](test::Random& random) {
    constexpr long largest = 1L << 53;
    const long most = random.chance(2) ? 99 : random.chance(2) ? largest : 2 * largest;
    const Rational x(random.integer(-most, most), random.integer(1, most));
    std::fesetround(FE_DOWNWARD);
    const auto near = static_cast<double>(x);
    std::fesetround(FE_TONEAREST);
    const Rational off = abs(x - exact_rational(near));
    for (const double other : {-1e300, 1e300})
      CHECK(off <= abs(x - exact_rational(std::nextafter(near, other))));
  });
}

TEST_CASE("rational: law: text and FLINT's rationals give back the same number") {
  test::for_samples(200, [](test::Random& random) {
    const Rational x = random.rational();
    CHECK(parse_rational(to_string(x)) == x);
    CHECK(Rational(x.raw()) == x);
  });
}

TEST_CASE("rational: an abbreviated text is one line and cuts no character in two") {
  CHECK(abbreviated("a\nb\x1b[31m") == "a?b?[31m");
  const std::string cut = abbreviated(std::string(39, 'a') + "é and more text", 40);
  CHECK(cut.starts_with(std::string(39, 'a') + "…"));
}

TEST_CASE("rational: the simplest fraction in an interval") {
  CHECK(simplest_between(Rational(3, 10), Rational(4, 10)) == Rational(1, 3));
  CHECK(simplest_between(Rational(-1, 2), Rational(7)) == 0);
  CHECK(simplest_between(Rational(22, 7), Rational(22, 7)) == Rational(22, 7));
  CHECK(simplest_between(parse_rational("3.14159"), parse_rational("3.1416")) ==
        Rational(355, 113));
}
