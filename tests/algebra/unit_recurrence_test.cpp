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
double root_share(const FixedSeries& w, const Polynomial& sigma, double counted) {
  const auto n = static_cast<long>(w.c.size()) - 1;
  Rational rest = 0;
  for (long i = 0; i <= std::min(n, sigma.degree()); ++i)
    rest += (1 - Rational(i, 2 * n)) * sigma.coefficient(i) *
            Rational(w.c[static_cast<std::size_t>(n - i)]);
  return static_cast<double>(abs(rest)) / counted;
}

double quotient_share(const FixedSeries& w, const FixedSeries& y, const Polynomial& nu,
                      const Polynomial& delta, double counted) {
  const auto n = static_cast<long>(y.c.size()) - 1;
  Rational rest = 0;
  for (long j = 0; j <= std::min(n, nu.degree()); ++j)
    rest += nu.coefficient(j) * Rational(w.c[static_cast<std::size_t>(n - j)]);
  for (long i = 0; i <= std::min(n, delta.degree()); ++i)
    rest -= delta.coefficient(i) * Rational(y.c[static_cast<std::size_t>(n - i)]);
  return static_cast<double>(abs(rest)) / counted;
}

/// The greatest shares of a run.
struct Shares {
  double root = 0;
  double quotient = 0;
};

Shares shares_of(const UnitQuotient& f, long Q, long most_bits, int steps) {
  const Polynomial sigma = over_first(f.radicand);
  const Polynomial delta = over_first(f.denominator);
  const Polynomial nu =
      power_of_two(-unit_exponent(f.numerator)) * to_polynomial(f.numerator.get());
  RootRecurrence root(f, Q, most_bits);
  QuotientRecurrence quotient(f, most_bits);
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
    // With as many bits as unit_series() takes, about, and with far fewer than the numbers have.
    const Shares enough = shares_of(f, Q, Q + 8, 30);
    const Shares few = shares_of(f, Q, std::max(4L, Q - 6), 30);
    for (const Shares& shares : {enough, few}) {
      CHECK(shares.root <= 1);
      CHECK(shares.quotient <= 1);
    }
    most.root = std::max(most.root, enough.root);
    most.quotient = std::max(most.quotient, enough.quotient);
    of_coefficients.root = std::max(of_coefficients.root, few.root);
    of_coefficients.quotient = std::max(of_coefficients.quotient, few.quotient);
  }
  CHECK(most.root > 0.9);
  CHECK(most.quotient > 0.9);
  CHECK(of_coefficients.root > 0.9);
  CHECK(of_coefficients.quotient > 0.9);
}
