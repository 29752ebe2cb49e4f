#include "phrame/algebra/as_written.hpp"

#include "phrame/algebra/rounding.hpp"
#include "support/random.hpp"

namespace as_written_test {

using namespace phrame;
using test::for_samples;
using test::Random;

TEST_CASE("as written: doubles, decimals and fractions as somebody writes them") {
  CHECK(as_written(exact_rational(4.0000000001)) == "4.0000000001");
  CHECK(as_written(exact_rational(0.1)) == "0.1");
  CHECK(as_written(exact_rational(-1e-300)) == "-1e-300");
  CHECK(as_written(exact_rational(1e300)).substr(0, 8) == "10000000");  // an integer
  for (const char* text :
       {"4.0000000001", "-0.00012345678901234567", "1e-9", "-1.25e-7", "0.0001",
        "123456789.123456789", "-1.25e-30", "1/3", "-22/7", "5", "0", "12345678/1234567", "1/8"})
    CHECK(as_written(parse_rational(text)) == text);
  CHECK(as_written(Rational(1) / Rational(pow(Integer(3), 100))) ==
        "1/51537752073201133103646112976562127270… (50 characters)");
}

TEST_CASE("as written: what is shown of a double is read as that double") {
  for_samples(200, [](Random& random) {
    const double x = round_to_double(Rational(random.integer(-999999, 999999), 997));
    CHECK(round_to_double(parse_rational(as_written(exact_rational(x)))) == x);
  });
}

TEST_CASE("as written: what rounds to the double that an end rounds to is that end") {
  const Real end = square_root_of(2);  // 1.41421356237309504880…
  CHECK(is_rounded(exact_rational(round_to_double(end)), end));
  CHECK(is_rounded(parse_rational("1.4142135623730951"), end));
  CHECK(!is_rounded(parse_rational("1.4142135623730953"), end));
  // Doubles that overflow and underflow are those of other numbers, too.
  for (const long k : {-4000, 4000})
    CHECK(!is_rounded(power_of_two(k), Rational(2 * power_of_two(k))));
}

}  // namespace as_written_test
