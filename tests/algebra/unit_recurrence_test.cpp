#include "phrame/algebra/unit_recurrence.hpp"

#include <algorithm>

#include "phrame/algebra/rounding.hpp"
#include "support/random.hpp"

using namespace phrame;

namespace {

/// p/p(0), exactly.
Polynomial over_first(const IntegerPolynomial& p) {
  const Polynomial q = to_polynomial(p.get());
  return Rational(1 / q.coefficient(0)) * q;
}

/// What is left over by the last step, over what was counted for it: by fractions.
template <class Number>
double root_share(const FixedSeries<Number>& w, const Polynomial& sigma, double counted) {
  const auto n = static_cast<long>(w.c.size()) - 1;
  Rational rest = 0;
  for (long i = 0; i <= std::min(n, sigma.degree()); ++i)
    rest += (1 - Rational(i, 2 * n)) * sigma.coefficient(i) *
            Rational(to_integer(w.c[static_cast<std::size_t>(n - i)]));
  return static_cast<double>(abs(rest)) / counted;
}

template <class Number>
double quotient_share(const FixedSeries<Number>& w, const FixedSeries<Number>& y,
                      const Polynomial& nu, const Polynomial& delta, double counted) {
  const auto n = static_cast<long>(y.c.size()) - 1;
  Rational rest = 0;
  for (long j = 0; j <= std::min(n, nu.degree()); ++j)
    rest += nu.coefficient(j) * Rational(to_integer(w.c[static_cast<std::size_t>(n - j)]));
  for (long i = 0; i <= std::min(n, delta.degree()); ++i)
    rest -= delta.coefficient(i) * Rational(to_integer(y.c[static_cast<std::size_t>(n - i)]));
  return static_cast<double>(abs(rest)) / counted;
}

/// The greatest shares of a run.
struct Shares {
  double root = 0;
  double quotient = 0;
};

template <class Number>
Shares shares_of(const UnitQuotient& f, long Q, long most_bits, int steps) {
  const Polynomial sigma = over_first(f.radicand);
  const Polynomial delta = over_first(f.denominator);
  const Polynomial nu =
      power_of_two(-unit_exponent(f.numerator)) * to_polynomial(f.numerator.get());
  RootRecurrence<Number> root(f, Q, most_bits);
  QuotientRecurrence<Number> quotient(f, most_bits);
  Shares shares;
  for (int k = 0; k < steps; ++k) {
    const double before = quotient.y().left_over;
    quotient.step(root.w());
    shares.quotient = std::max(shares.quotient, quotient_share(root.w(), quotient.y(), nu, delta,
                                                               quotient.y().left_over - before));
    const double root_before = root.w().left_over;
    root.step();
    shares.root =
        std::max(shares.root, root_share(root.w(), sigma, root.w().left_over - root_before));
  }
  return shares;
}

}  // namespace

// Each step is allowed one unit for its rounding, and its coefficients' errors. What is really left
// over is up to nearly as much: with one rounding less in the count, half of the coefficients'
// errors, or one coefficient, the law does not hold.
TEST_CASE("unit recurrence: law: no step leaves over more than it counts, and some nearly that") {
  test::Random random(79);
  Shares most;
  Shares of_coefficients;
  Shares of_words;
  Shares of_exact;
  for (long k = 0; k < 60 * test::multiplier(); ++k) {
    Polynomial S{random.integer(1, 9)};
    Polynomial D{random.integer(1, 9)};
    for (long factor = random.integer(0, 3); factor > 0; --factor) {
      const Rational re(random.integer(-9, 9), 4);
      const Rational im(random.integer(6, 20), 8);
      (random.integer(0, 1) == 0 ? S : D) *= Polynomial{re * re + im * im, -2 * re, 1};
    }
    const UnitQuotient f = unit_quotient(random.nonzero_polynomial(4), D, S);
    const long Q = random.integer(4, 60);
    CAPTURE(D);
    CAPTURE(S);
    CAPTURE(Q);
    // With as many bits as unit_series() takes, about, with far fewer than the numbers have, and
    // with so many that the coefficients themselves are shorter, as long as the numbers are long.
    const Shares enough = shares_of<Integer>(f, Q, Q + 8, 30);
    const Shares few = shares_of<Integer>(f, Q, std::max(4L, Q - 6), 30);
    const Shares exact = shares_of<Integer>(f, 4 * Q + 150, 4 * Q + 158, 60);
    const Shares by_words = shares_of<TwoWords>(f, Q + 16, 90, 30);
    const Shares few_words = shares_of<TwoWords>(f, 76, 70, 30);
    for (const Shares& shares : {enough, few, exact, by_words, few_words}) {
      CHECK(shares.root <= 1);
      CHECK(shares.quotient <= 1);
    }
    most.root = std::max(most.root, enough.root);
    most.quotient = std::max(most.quotient, enough.quotient);
    of_coefficients.root = std::max(of_coefficients.root, few.root);
    of_coefficients.quotient = std::max(of_coefficients.quotient, few.quotient);
    of_exact.root = std::max(of_exact.root, exact.root);
    of_exact.quotient = std::max(of_exact.quotient, exact.quotient);
    of_words.root = std::max(of_words.root, few_words.root);
    of_words.quotient = std::max(of_words.quotient, few_words.quotient);
  }
  CHECK(most.root > 0.9);
  CHECK(most.quotient > 0.9);
  CHECK(of_coefficients.root > 0.9);
  CHECK(of_coefficients.quotient > 0.9);
  CHECK(of_exact.root > 0.9);
  CHECK(of_exact.quotient > 0.9);
  CHECK(of_words.root > 0.9);
  CHECK(of_words.quotient > 0.9);
}

TEST_CASE("unit recurrence: law: sums of products of two words are those of integers") {
  test::Random random(83);
  const auto some = [&random](long bits) {
    const Integer size =
        (Integer(random.integer(0, LONG_MAX)) << 63U) + random.integer(0, LONG_MAX);
    const Integer x = size >> static_cast<unsigned long>(random.integer(126 - bits, 126));
    return random.chance(2) ? x : Integer(-x);
  };
  for (long k = 0; k < 300 * test::multiplier(); ++k) {
    ProductSum<Integer> sum;
    ProductSum<TwoWords> by_words;
    for (std::size_t j = 0; j < most_products; ++j) {
      const bool is_greatest = random.chance(4);
      const Integer limit = (Integer(1) << static_cast<unsigned long>(most_factor_bits)) - 1;
      const Integer a = is_greatest ? limit : some(most_factor_bits);
      const Integer b = !is_greatest       ? some(most_factor_bits)
                        : random.chance(2) ? limit
                                           : Integer(-limit);
      const auto x = from_integer<TwoWords>(a);
      const auto y = from_integer<TwoWords>(b);
      CHECK(to_integer(x) == a);
      CHECK(bit_length(x) == bit_length(a));
      sum.add(a, b);
      by_words.add(x, y);
      const long bits = random.integer(64, 128);
      const Integer upper = sum.upper(bits);
      if (bit_length(upper) < 124)
        CHECK(to_integer(by_words.upper(bits)) == upper);
      else
        CHECK(bit_length(by_words.upper(bits)) > most_factor_bits);
      const auto n = static_cast<std::size_t>(random.integer(1, 99));
      CHECK(to_integer(floor_quotient(x, n)) == floor_quotient(a, n));
    }
  }
}
