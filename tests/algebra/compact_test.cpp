#include "phrame/algebra/compact.hpp"

#include "phrame/algebra/rounding.hpp"
#include "support/random.hpp"

namespace compact_test {

using namespace phrame;
using test::for_samples;
using test::Random;

namespace {

/// Words of its numbers for which there is room.
long room(const Polynomial& p) {
  const auto of = [](const fmpz& x) { return COEFF_IS_MPZ(x) ? COEFF_TO_PTR(x)->_mp_alloc : 0; };
  long sum = of(*p.raw()->den);
  for (slong k = 0; k < p.raw()->length; ++k) sum += of(p.raw()->coeffs[k]);
  return sum;
}

}  // namespace

TEST_CASE("compact: law: it is the same polynomial, to compute with") {
  for_samples(100, [](Random& random) {
    const Polynomial p = random.polynomial(6);
    Polynomial q = compact(p);
    CHECK(q == p);
    CHECK(q * q + p == p * p + p);
    q *= Rational(Integer(1) << 300, 7);
    CHECK(compact(q) == Rational(Integer(1) << 300, 7) * p);
  });
}

TEST_CASE("compact: a number has the room that it needs, whatever was there before") {
  const Rational great = pow(Polynomial{3}, 4000).coefficient(0);
  Polynomial p{great, great, great};
  p -= Polynomial{great - power_of_two(100), great - power_of_two(90), great};
  CHECK(room(p) > 50);
  const Polynomial q = compact(std::move(p));
  CHECK(room(q) == 4);
  CHECK(q == Polynomial{power_of_two(100), power_of_two(90)});
}

}  // namespace compact_test
