#include "phrame/algebra/taylor_model.hpp"

#include "phrame/algebra/elementary.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/algebra/rounding.hpp"
#include "support/random.hpp"

namespace taylor_model_test {

using namespace phrame;
using test::for_samples;
using test::Random;

namespace {

constexpr long bits = 40;

Rational grid() { return power_of_two(-bits); }

/// P(z).
Rational value(const TaylorModel& a, const Rational& z) {
  Rational sum = 0;
  for (std::size_t k = a.terms.size(); k-- > 0;) sum = sum * z + Rational(a.terms[k]);
  return sum * grid();
}

/// Is x within the model at z?
bool has(const TaylorModel& a, const Rational& z, const Real& x) {
  const RealBall ball = x.enclose(300);
  const Rational radius = Rational(a.radius) * grid();
  return ball.lower() >= value(a, z) - radius && ball.upper() <= value(a, z) + radius;
}

/// A function with a constant term about c, and a radius of any size.
TaylorModel random_model(Random& random, long c) {
  TaylorModel a{{Integer(c) << bits},
                Integer(random.integer(0, 9)) << static_cast<unsigned long>(random.integer(0, 36))};
  for (long k = random.integer(0, 4); k > 0; --k)
    a.terms.push_back((Integer(random.integer(-9, 9)) << (bits - 6)) + Integer(1));
  return a;
}

}  // namespace

// A function of the model lies anywhere within it.
TEST_CASE("Taylor models: law: functions are within those of models") {
  for_samples(60, [](Random& random) {
    const TaylorModels models(random.integer(3, 24), bits);
    const TaylorModel a = random_model(random, random.integer(2, 6));
    const TaylorModel b = random_model(random, random.integer(-6, 6));
    const Rational z(random.integer(-8, 8), 8);
    const auto any = [&](const TaylorModel& f) {
      return value(f, z) + Rational(f.radius) * grid() * Rational(random.integer(-4, 4), 4);
    };
    const Rational x = any(a);
    const Rational y = any(b);
    CHECK(has(models.add(a, b), z, Real(x + y)));
    CHECK(has(models.subtract(a, b), z, Real(x - y)));
    CHECK(has(models.multiply(a, b), z, Real(x * y)));
    CHECK(has(models.multiply(Rational(-7, 3), a), z, Real(Rational(-7, 3) * x)));
    CHECK(has(models.number(x), z, Real(x)));
    CHECK(has(models.inverse(a), z, Real(1 / x)));
    CHECK(has(models.inverse(models.multiply(-1, a)), z, Real(-1 / x)));
    CHECK(has(models.exp(b), z, elementary("exp", Real(y), true)));
    CHECK(has(models.cos_sin(b).cos, z, elementary("cos", Real(y), true)));
    CHECK(has(models.cos_sin(b).sin, z, elementary("sin", Real(y), true)));
    CHECK(has(models.log(a), z, elementary("log", Real(x), true)));
    CHECK(has(models.atan(b), z, elementary("arctan", Real(y), true)));
    try {
      CHECK(has(models.sqrt(a), z, elementary("sqrt", Real(x), true)));
    } catch (const Undecided&) {  // with too few terms
    }
  });
}

TEST_CASE("Taylor models: numbers that may be 0, and great ones, are refused") {
  const TaylorModels models(4, 10);
  for (const TaylorModel& a : {TaylorModel{{500}, 500}, TaylorModel{{500, 300}, 200},
                               TaylorModel{{}, 0}, TaylorModel{{0, 1}, 0}}) {
    CHECK_THROWS_AS(models.inverse(a), Undecided);
    CHECK_THROWS_AS(models.sqrt(a), Undecided);
    CHECK_THROWS_AS(models.log(a), Undecided);
  }
  CHECK_THROWS_AS(models.exp(models.number(701)), Undecided);
  CHECK_THROWS_AS(models.exp({{0, 65 << 10}, 0}), Undecided);
  CHECK_THROWS_AS(models.number(Rational(Integer(1) << 1001UL)), Undecided);
  CHECK_THROWS_AS(models.cos_sin(models.number(Rational(Integer(1) << 65UL))), Undecided);
}

TEST_CASE("Taylor models: what is beyond the order is in the radius") {
  const TaylorModels models(2, bits);
  const TaylorModel square = models.multiply(models.variable(), models.variable());
  CHECK(square.terms.empty());
  CHECK(has(square, 1, Real(1)));
}

TEST_CASE("Taylor models: what is 0 exactly stays so") {
  const TaylorModels models(4, 10);
  const TaylorModel a{{5, 7}, 3};
  CHECK(models.multiply(a, {}).is_zero());
  CHECK(models.number(0).is_zero());
  CHECK(models.log(models.number(1)).radius == 2);
  CHECK(models.exp({}).terms == std::vector<Integer>{1024});
}

}  // namespace taylor_model_test
