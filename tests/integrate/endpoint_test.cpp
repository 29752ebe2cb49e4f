#include "phrame/integrate/endpoint.hpp"

#include "phrame/algebra/error.hpp"
#include "support/random.hpp"

namespace endpoint_test {

using namespace phrame;

namespace {

const Endpoint minus_infinity = Infinity::negative;
const Endpoint plus_infinity = Infinity::positive;
/// √2, and the same in other words, as the root of t⁴ − 4 in [1, 2].
const Endpoint root_two = real_root({-2, 0, 1}, {1, 2});
const Endpoint root_two_again = real_root({-4, 0, 0, 0, 1}, {1, 2});

}  // namespace

TEST_CASE("endpoint: all ends are in the order of the real line") {
  const std::vector<Endpoint> ascending{minus_infinity, Rational(-3),   Rational(1),
                                        root_two,       Rational(3, 2), plus_infinity};
  for (std::size_t a = 0; a < ascending.size(); ++a)
    for (std::size_t b = 0; b < ascending.size(); ++b)
      CHECK(compare(ascending[a], ascending[b]) == (a <=> b));
  CHECK(compare(root_two, root_two_again) == std::strong_ordering::equal);
  CHECK(compare(RealAlgebraic(Rational(1)), Rational(1)) == std::strong_ordering::equal);
}

TEST_CASE("endpoint: a finite one is a number, an infinite one is none") {
  for (const Endpoint& end : {minus_infinity, plus_infinity}) {
    CHECK(is_infinite(end));
    CHECK_FALSE(finite(end));
    CHECK(bits_of(end) == 0);
    CHECK_THROWS_AS(enclose(end, 64), DomainError);
  }
  CHECK_FALSE(is_infinite(root_two));
  REQUIRE(finite(Rational(2, 7)));
  CHECK(compare(*finite(Rational(2, 7)), Rational(2, 7)) == 0);
  const RealBall ball = enclose(root_two, 100);
  CHECK(multiply(ball, ball, 100).contains(Rational(2)));
  CHECK(ball.is_accurate(90));
  CHECK(bits_of(Endpoint(Rational(1'000'000'007, 3))) >= 30);
}

}  // namespace endpoint_test
