#include "phrame/algebra/bounded_algebraic.hpp"

#include "phrame/algebra/algebraic_image.hpp"
#include "support/random.hpp"

namespace bounded_algebraic_test {

using namespace phrame;
using test::for_samples;
using test::Random;

namespace {

RealAlgebraic root_of(long n) { return real_root({-n, 0, 1}, {Rational(0), std::nullopt}); }

}  // namespace

TEST_CASE("bounded algebraic: √2 + √3 is recognised, with degree 4") {
  const BoundedAlgebraic sum = bounded(root_of(2)) + bounded(root_of(3));
  CHECK(sum.conjugates == 4);
  CHECK(recognized(sum, 4) == real_root({1, 0, -10, 0, 1}, closed_interval(3, 4)));
  CHECK_FALSE(recognized(sum, 3).has_value());
  CHECK(is_root({1, 0, -10, 0, 1}, sum) == true);
  CHECK(is_root({1, 0, -10, 0, 2}, sum) == false);
}

TEST_CASE("bounded algebraic: a sum that cancels is 0, or rational") {
  const RealAlgebraic x = real_root({-1, -1, 0, 0, 0, 1}, real_line());
  const RealAlgebraic y = affine(x, -1, Rational(2, 3));
  CHECK(recognized(bounded(x) + bounded(y), 1) == RealAlgebraic(Rational(2, 3)));
  CHECK(recognized(bounded(x) + bounded(affine(x, -1, 0)), 8) == RealAlgebraic(0));
}

// 2^−200 is far from 0 for an algebraic number with these bounds only if they say so.
TEST_CASE("bounded algebraic: a number near 0 is not taken for 0") {
  const RealAlgebraic tiny = Rational(1, Integer(1) << 200);
  CHECK(is_root({0, 1}, bounded(tiny)) == false);
  BoundedAlgebraic many = bounded(tiny);
  many.conjugates = many_conjugates;
  many.enclose = [](long bits) { return hull(Rational(0), power_of_two(-bits), 64); };
  CHECK_FALSE(is_root({0, 1}, many).has_value());
}

TEST_CASE("bounded algebraic: law: affine images and values of polynomials are recognised") {
  for_samples(20, [](Random& random) {
    const RealAlgebraic x = root_of(random.chance(2) ? 5 : 7);
    const Polynomial p = random.polynomial(3);
    const RealAlgebraic y = image(p, x);
    CHECK(recognized(bounded(y), 2) == y);
    const Rational factor = abs(random.rational()) + 1;
    const Rational shift = random.rational();
    CHECK(affine(y, -factor, shift) == image(-factor * p + Polynomial{shift}, x));
    CHECK(image(RationalFunction({1}, {1, 0, 1}), x) ==
          image(Polynomial{Rational(1, x.polynomial() == Polynomial{-5, 0, 1} ? 6 : 8)}, x));
  });
}

}  // namespace bounded_algebraic_test
