#include "phrame/algebra/double_polynomial.hpp"

#include <algorithm>
#include <cmath>

#include "phrame/algebra/rational.hpp"
#include "support/doubles.hpp"

using namespace phrame;
using test::any_double;
using test::for_samples;
using test::Random;

namespace {

/// In [−1, 1], often of few digits, small, or an end.
double argument(Random& random) {
  if (random.chance(8)) return static_cast<double>(random.integer(-1, 1));
  const double y = std::ldexp(static_cast<double>(random.integer(-(1L << 53), 1L << 53)), -53);
  return random.chance(4) ? std::ldexp(y, -static_cast<int>(random.integer(0, 400))) : y;
}

/// Polynomials with numerators of 200 bits, whose coefficients tend to 0 as those of a Taylor
/// series.
std::vector<Polynomial> polynomials(Random& random, const DoubleShape& shape, bool zero_at_zero) {
  std::vector<Polynomial> result;
  const long step = random.integer(0, 6);
  for (long which = 0; which < shape.width; ++which) {
    std::vector<Rational> c;
    for (long k = 0; k <= shape.degree; ++k) {
      Rational x = exact_rational(any_double(random)) + exact_rational(any_double(random)) / 3;
      if (random.chance(10)) x = 0;
      c.push_back(x / Rational(pow(Integer(2), static_cast<unsigned>(k * step))));
    }
    if (zero_at_zero) c[0] = 0;
    result.emplace_back(c);
  }
  return result;
}

std::vector<BallPolynomial> as_balls(const std::vector<Polynomial>& polynomials) {
  std::vector<BallPolynomial> balls;
  for (const Polynomial& p : polynomials) balls.emplace_back(p, 300);
  return balls;
}

/// The polynomial that the doubles are, from their meaning in double_polynomial.hpp.
Polynomial meaning(const std::vector<double>& doubles, const DoubleShape& shape, long which) {
  std::vector<Rational> c(static_cast<std::size_t>(shape.degree + 1));
  auto next = doubles.begin();
  for (long k = shape.degree; k >= 0; --k)
    for (long part = 0; part < (k < shape.paired ? 2 : 1); ++part, next += shape.width)
      c[static_cast<std::size_t>(k)] += exact_rational(next[which]);
  CHECK(next == doubles.end());
  return Polynomial(c);
}

Rational sum(const DoubleDouble& x) { return exact_rational(x.high) + exact_rational(x.low); }

}  // namespace

TEST_CASE("error-free transformations: sums and products are exact") {
  for_samples(2000, [](Random& random) {
    const double a = any_double(random);
    const double b = random.chance(4) ? a * (1 - 0x1p-52) : any_double(random);
    const DoubleDouble s = two_sum(a, -b);
    CHECK(s.high == a - b);
    CHECK(sum(s) == exact_rational(a) - exact_rational(b));
    const DoubleDouble p = two_product(split_factor(a), split_factor(b));
    CHECK(p.high == a * b);
    CHECK(sum(p) == exact_rational(a) * exact_rational(b));
  });
}

TEST_CASE("error-free transformations: pairs are added, subtracted and multiplied to 100 bits") {
  for_samples(500, [](Random& random) {
    const auto pair = [&] {
      const double high = any_double(random);
      return two_sum(high, high * 0x1p-54 * static_cast<double>(random.integer(-9, 9)) / 10);
    };
    const DoubleDouble a = pair();
    const DoubleDouble b = pair();
    const Rational allowed = Rational(1, Integer(1) << 100);
    CHECK(abs(sum(a + b) - (sum(a) + sum(b))) <= (abs(sum(a)) + abs(sum(b))) * allowed);
    CHECK(abs(sum(a - b) - (sum(a) - sum(b))) <= (abs(sum(a)) + abs(sum(b))) * allowed);
    CHECK(abs(sum(a * b) - sum(a) * sum(b)) <= abs(sum(a) * sum(b)) * allowed);
  });
}

TEST_CASE("double polynomial: law: the doubles are what their order says, and next to the balls") {
  for_samples(100, [](Random& random) {
    const long width = random.chance(2) ? 1 : 4;
    const long degree = random.integer(1, 20);
    const DoubleShape shape{width, degree, random.integer(1, degree), 0};
    const auto exact = polynomials(random, shape, false);
    const auto doubles = round_coefficients(as_balls(exact), shape);
    REQUIRE(static_cast<long>(doubles.size()) == shape.size());
    for (long which = 0; which < width; ++which) {
      const Polynomial p = meaning(doubles, shape, which);
      const BallPolynomial same = exact_polynomial(doubles, shape, which);
      for (long k = 0; k <= degree; ++k) {
        const Rational c = exact[static_cast<std::size_t>(which)].coefficient(k);
        const Integer precision = Integer(1) << (k < shape.paired ? 106 : 53);
        CHECK(abs(p.coefficient(k) - c) * precision <= abs(c));
        CHECK(same.coefficient(k).radius() == 0);
        CHECK(same.coefficient(k).midpoint() == p.coefficient(k));
      }
    }
  });
}

TEST_CASE("double polynomial: law: Horner's rule keeps to its bound, and is not far below it") {
  double closest = 0;  // of all errors to their bounds
  double closest_plain = 0;
  for_samples(400, [&](Random& random) {
    const long width = random.chance(2) ? 1 : 4;
    const bool is_plain = random.chance(2);
    DoubleShape shape = is_plain ? plain_shape(width) : compensated_shape(width);
    if (random.chance(3)) shape.degree = is_plain ? 3 : 7;
    const bool zero_at_zero = random.chance(3);
    const auto doubles =
        round_coefficients(as_balls(polynomials(random, shape, zero_at_zero)), shape);
    for (int round = 0; round < 10; ++round) {
      const double y = argument(random);
      std::array<DoubleDouble, 4> value{};
      if (is_plain) {
        for (long which = 0; which < width; ++which) {
          const auto at = [&](long k) {
            return doubles[static_cast<std::size_t>(shape.position(k) + which)];
          };
          double s = at(shape.degree);
          for (long k = shape.degree - 1; k > 0; --k)
            s = round % 2 == 0 ? s * y + at(k) : std::fma(s, y, at(k));
          const double second =
              doubles[static_cast<std::size_t>(shape.position(0) + width + which)];
          value[static_cast<std::size_t>(which)].high = at(0) + (second + s * y);
        }
      } else if (width == 1) {
        value[0] = evaluate_compensated<1>(doubles.data(), shape, y)[0];
      } else {
        value = evaluate_compensated<4>(doubles.data(), shape, y);
      }
      for (long which = 0; which < width; ++which) {
        const double bound = rounding_error(doubles, shape, which);
        const Rational factor = zero_at_zero ? abs(exact_rational(y)) : Rational(1);
        const Rational off = abs(sum(value[static_cast<std::size_t>(which)]) -
                                 meaning(doubles, shape, which)(exact_rational(y)));
        CHECK(off <= exact_rational(bound) * factor + exact_rational(underflow_error));
        if (bound > 0 && factor > 0) {
          double& closest_here = is_plain ? closest_plain : closest;
          closest_here =
              std::max(closest_here, static_cast<double>(off / (exact_rational(bound) * factor)));
        }
      }
    }
  });
  CHECK(closest > 0.02);
  CHECK(closest_plain > 0.2);
}
