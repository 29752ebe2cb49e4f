#pragma once
#include <doctest/doctest.h>

#include <algorithm>
#include <cstdlib>
#include <random>

#include "phrame/algebra/rational_function.hpp"
#include "phrame/ph/curve/curve.hpp"

namespace phrame::inline v0::test {

/// Random objects from one seed, biased to the corners: zero, units, repeated factors, huge
/// heights.
class Random {
 public:
  explicit Random(unsigned long seed) : engine_(seed) {}

  long integer(long low, long high) {
    return std::uniform_int_distribution<long>(low, high)(engine_);
  }
  bool chance(long one_in) { return integer(1, one_in) == 1; }

  Rational rational() {
    if (chance(8)) return 0;
    if (chance(8)) return integer(0, 1) == 0 ? -1 : 1;
    if (chance(16)) return Rational(huge(), huge());
    return Rational(integer(-20, 20), integer(1, chance(2) ? 1 : 12));
  }

  /// Of degree ≤ `degree`; sometimes 0, constant, sparse or with huge coefficients.
  Polynomial polynomial(long degree) {
    if (chance(12)) return {};
    const bool sparse = chance(4);
    std::vector<Rational> c;
    for (long k = integer(0, degree); k >= 0; --k)
      c.push_back(sparse && chance(2) ? Rational(0) : rational());
    return Polynomial(c);
  }

  Polynomial nonzero_polynomial(long degree) {
    for (;;)
      if (Polynomial p = polynomial(degree); !p.is_zero()) return p;
  }

  Polynomial nonconstant_polynomial(long degree) {
    for (;;)
      if (Polynomial p = polynomial(degree); !p.is_constant()) return p;
  }

  /// A product of small factors with multiplicities 1 to 3.
  Polynomial repeated_polynomial(long factors) {
    Polynomial product{1};
    for (long k = 0; k < factors; ++k) product *= pow(nonconstant_polynomial(2), integer(1, 3));
    return product;
  }

  GaussianPolynomial gaussian_polynomial(long degree) {
    return {polynomial(degree), polynomial(degree)};
  }

  QuaternionPolynomial quaternion_polynomial(long degree) {
    for (;;) {
      QuaternionPolynomial a{polynomial(degree), polynomial(degree), polynomial(degree),
                             polynomial(degree)};
      if (is_zero(a)) continue;
      if (chance(5)) return a * QuaternionPolynomial{polynomial(1), Polynomial{1}, {}, {}};
      return a;
    }
  }

  /// Degree ≤ 2·degree + 3; sometimes with a multiplier.
  Curve curve(long degree) {
    return Curve(quaternion_polynomial(degree), chance(3) ? nonzero_polynomial(2) : Polynomial{1},
                 {rational(), rational(), rational()});
  }

 private:
  Integer huge() {
    Integer n = 1;
    for (int k = 0; k < 6; ++k) n = n * 4294967291U + Integer(integer(1, 4294967290));
    return n;
  }

  std::mt19937_64 engine_;
};

/// The effort of the laws: PHRAME_TEST_MULTIPLIER, 1 by default.
inline long multiplier() {
  const char* text = std::getenv("PHRAME_TEST_MULTIPLIER");
  return text == nullptr ? 1 : std::max(1L, std::strtol(text, nullptr, 10));
}

/// The first number, or with more effort the second: of collections of which a part is enough for
/// every day.
inline long everyday(long part, long whole) { return multiplier() > 1 ? whole : part; }

/// Checks a law on `count` random samples; a failure shows the seed of its sample.
/// PHRAME_TEST_SEED is added to the seeds.
template <class Law>
void for_samples(long count, Law law) {
  const char* text = std::getenv("PHRAME_TEST_SEED");
  const unsigned long first = text == nullptr ? 0 : std::strtoul(text, nullptr, 10);
  for (long k = 0; k < count * multiplier(); ++k) {
    const unsigned long seed = first + static_cast<unsigned long>(k);
    CAPTURE(seed);
    Random random(seed);
    law(random);
  }
}

}  // namespace phrame::test
