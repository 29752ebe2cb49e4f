#include "phrame/integrate/exact_value.hpp"

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/roots.hpp"
#include "phrame/integrate/endpoint.hpp"
#include "support/random.hpp"

using namespace phrame;

namespace {

RealAlgebraic root_of_two() {
  return real_roots(Polynomial{-2, 0, 1}, closed_interval(0, 2)).front().at;
}

}  // namespace

TEST_CASE("exact value: sums of multiples of pi, logarithms and arctangents") {
  const ExactValue a{1, Rational(1, 4), {{2, 3}}, {{1, Rational(1, 2)}}};
  const ExactValue b{Rational(1, 2), Rational(-1, 4), {{-2, 3}}, {{-1, Rational(1, 2)}}};
  CHECK(a + b == ExactValue{Rational(3, 2), 0, {}, {}});
  CHECK(is_rational(a + b));
  CHECK_FALSE(is_rational(a));
  CHECK(Rational(2) * a == ExactValue{2, Rational(1, 2), {{4, 3}}, {{2, Rational(1, 2)}}});
  CHECK(Rational(0) * a == ExactValue{});
}

// Machin: 4·arctan(1/5) − arctan(1/239) = π/4; Euler: arctan(1/2) + arctan(1/3) = π/4.
TEST_CASE("exact value: arctangents that add up to a multiple of pi") {
  const ExactValue euler = ExactValue{0, 0, {}, {{1, Rational(1, 2)}}} +
                           ExactValue{0, Rational(-1, 4), {}, {{1, Rational(1, 3)}}};
  CHECK(is_rational(euler));
  const ExactValue machin = ExactValue{0, Rational(-1, 4), {}, {{4, Rational(1, 5)}}} +
                            ExactValue{0, 0, {}, {{-1, Rational(1, 239)}}};
  CHECK(is_rational(machin));
  const ExactValue nearly = ExactValue{0, Rational(-1, 4), {}, {{4, Rational(1, 5)}}} +
                            ExactValue{0, 0, {}, {{-1, Rational(1, 238)}}};
  CHECK_FALSE(is_rational(nearly));
}

TEST_CASE("exact value: an irrational multiple of pi is the whole one, and one only") {
  const ExactValue irrational{0, 0, {}, {}, root_of_two()};
  const ExactValue sum = irrational + ExactValue{1, Rational(1, 2), {}, {}};
  CHECK(sum.pi == 0);
  REQUIRE(sum.irrational_pi);
  CHECK(sign_at(Polynomial{Rational(-7, 4), -1, 1}, *sum.irrational_pi) == 0);  // (x − 1/2)² = 2
  CHECK_FALSE(is_rational(sum));
  CHECK_THROWS_AS(irrational + irrational, DomainError);
  CHECK_FALSE(sum_of({irrational, irrational}).has_value());
  CHECK(sum_of({irrational, ExactValue{1, Rational(1, 2), {}, {}}}) == sum);
}

TEST_CASE("endpoint: from minus infinity over the numbers to infinity") {
  const std::vector<Endpoint> ascending{Infinity::negative, Rational(-3), Rational(1),
                                        root_of_two(),      Rational(2),  Infinity::positive};
  for (std::size_t j = 0; j < ascending.size(); ++j)
    for (std::size_t k = 0; k < ascending.size(); ++k)
      CHECK(compare(ascending[j], ascending[k]) == (j <=> k));
  CHECK(compare(Endpoint(Rational(2)), Endpoint(RealAlgebraic(Rational(2)))) == 0);
  CHECK_FALSE(finite(Infinity::positive).has_value());
  CHECK(finite(Rational(1, 2)) == RealAlgebraic(Rational(1, 2)));
  CHECK_THROWS_AS(enclose(Endpoint(Infinity::negative), 53), DomainError);
}
