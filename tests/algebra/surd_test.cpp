#include "phrame/algebra/surd.hpp"

#include "phrame/algebra/error.hpp"
#include "support/random.hpp"

using namespace phrame;
using test::for_samples;
using test::Random;

TEST_CASE("surd: square factors of 1, 2, 49, 72 and of the square of a large prime") {
  const auto split = [](const Integer& x) {
    const SquareFactor s = split_square(x);
    return std::pair(s.root, s.rest);
  };
  CHECK(split(1) == std::pair<Integer, Integer>(1, 1));
  CHECK(split(2) == std::pair<Integer, Integer>(1, 2));
  CHECK(split(49) == std::pair<Integer, Integer>(7, 1));
  CHECK(split(72) == std::pair<Integer, Integer>(6, 2));
  const Integer prime = (Integer(1) << 89U) - 1;
  CHECK(split(prime * prime * 3) == std::pair<Integer, Integer>(prime, 3));
  CHECK_THROWS_AS(split_square(0), DomainError);
}

TEST_CASE("surd: law: x = root²·rest, and no small square is left") {
  for_samples(200, [](Random& random) {
    const Integer x = random.integer(1, 100000);
    const SquareFactor s = split_square(x);
    CHECK(s.root * s.root * s.rest == x);
    for (long p = 2; p < 320; ++p) CHECK(s.rest % (p * p) != 0);
  });
}
