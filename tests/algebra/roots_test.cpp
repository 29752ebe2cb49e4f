#include "phrame/algebra/roots.hpp"

#include <algorithm>
#include <cmath>

#include "phrame/algebra/error.hpp"
#include "support/random.hpp"

using namespace phrame;
using test::for_samples;
using test::Random;

TEST_CASE("roots: of t⁴ − 1, and the root 0") {
  const Roots roots = isolate_roots({-1, 0, 0, 0, 1}, 100);
  REQUIRE(roots.real.size() == 2);
  REQUIRE(roots.upper.size() == 1);
  CHECK(roots.real[0].contains(-1));
  CHECK(roots.real[1].contains(1));
  CHECK(roots.upper[0].re().contains(0));
  CHECK(roots.upper[0].im().contains(1));
  CHECK(isolate_roots({0, 1}, 100).real.at(0).contains(0));
  CHECK_THROWS_AS(isolate_roots({3}, 100), DomainError);
  CHECK_THROWS_AS(isolate_roots(pow(Polynomial{1, 1}, 2), 100), DomainError);
}

TEST_CASE("roots: of very different sizes, 0 among them, are found together") {
  const std::vector<long> exponents = {-13000, -400, 0, 300, 13000};  // doubles end at 2¹⁰²⁴
  const auto size = [](long exponent) {
    const Rational power = pow(Integer(2), static_cast<unsigned>(std::abs(exponent)));
    return exponent < 0 ? Rational(1 / power) : power;
  };
  Polynomial p = Polynomial::monomial(1, 1);
  for (const long e : exponents) p *= Polynomial{size(e) * size(e), size(e), 1};
  const Roots roots = isolate_roots(p, 100);
  REQUIRE(roots.real.size() == 1);
  CHECK(roots.real[0].contains(0));
  REQUIRE(roots.upper.size() == exponents.size());
  for (const long e : exponents) {  // 2ᵉ·(−1 ± i√3)/2
    const auto has_it = [&](const ComplexBall& z) { return z.re().contains(-size(e) / 2); };
    CHECK(std::count_if(roots.upper.begin(), roots.upper.end(), has_it) == 1);
  }
  for (const ComplexBall& z : roots.upper) CHECK(acb_rel_accuracy_bits(z.raw()) >= 100);
}

TEST_CASE("roots: of a quadratic, however near to each other") {
  const Rational power = parse_rational("1e-800");
  const Polynomial near_pair = Polynomial{1, -2, 1} + Polynomial{power};
  Roots near = isolate_roots(near_pair, 64);
  REQUIRE(near.upper.size() == 1);
  CHECK(near.upper[0].re().contains(1));
  CHECK(near.upper[0].im().contains(parse_rational("1e-400")));
  CHECK(near.upper[0].im().accuracy_bits() >= 64);
  refine(near_pair, near, 3000);
  CHECK(near.upper[0].im().contains(parse_rational("1e-400")));
  CHECK(acb_rel_accuracy_bits(near.upper[0].raw()) >= 3000);
  const Roots real = isolate_roots(Polynomial{1, -2, 1} - Polynomial{power}, 64);
  REQUIRE(real.real.size() == 2);
  CHECK(real.real[0].contains(1 - parse_rational("1e-400")));
  CHECK(real.real[1].contains(1 + parse_rational("1e-400")));
}

TEST_CASE("roots: law: the known roots are found, refining keeps and narrows them") {
  for_samples(60, [](Random& random) {
    std::vector<Rational> real;
    std::vector<std::pair<Rational, Rational>> upper;
    Polynomial p{random.integer(1, 7)};
    for (long k = random.integer(0, 4); k > 0; --k) {
      const Rational x = random.rational();
      if (p(x) == 0) continue;
      real.push_back(x);
      p *= Polynomial{-x, 1};
    }
    for (long k = random.integer(0, 3); k > 0; --k) {
      const Rational x = random.rational();
      const Rational y = abs(random.rational()) + 1;
      const Polynomial quadratic{x * x + y * y, -2 * x, 1};
      if ((p % quadratic).is_zero()) continue;
      upper.emplace_back(x, y);
      p *= quadratic;
    }
    if (p.is_constant()) return;
    std::sort(real.begin(), real.end());
    Roots roots = isolate_roots(p, 64);
    for (const long bits : {64L, 300L, 2000L}) {
      if (bits > 64) refine(p, roots, bits);
      REQUIRE(roots.real.size() == real.size());
      REQUIRE(roots.upper.size() == upper.size());
      for (std::size_t k = 0; k < real.size(); ++k) {
        CHECK(roots.real[k].contains(real[k]));
        CHECK(roots.real[k].accuracy_bits() >= bits);
      }
      for (const auto& [x, y] : upper) {
        long found = 0;
        for (const ComplexBall& z : roots.upper)
          if (z.re().contains(x) && z.im().contains(y)) ++found;
        CHECK(found == 1);
      }
      for (const ComplexBall& z : roots.upper) CHECK(acb_rel_accuracy_bits(z.raw()) >= bits);
    }
  });
}

TEST_CASE("roots: a pair 10^-20 apart, and Wilkinson's polynomial of degree 20") {
  const Rational gap = parse_rational("1e-20");
  const Rational third(1, 3);
  // (t − 1/3)² + gap²: the roots 1/3 ± i·10^-20.
  const Roots pair = isolate_roots(
      Polynomial{third * third + gap * gap, -2 * third, 1} * Polynomial{5, 1, 1}, 400);
  REQUIRE(pair.upper.size() == 2);
  CHECK(pair.upper[1].re().contains(third));
  CHECK(pair.upper[1].im().contains(gap));
  CHECK(acb_rel_accuracy_bits(pair.upper[1].raw()) >= 400);
  Polynomial wilkinson{1};
  for (long k = 1; k <= 20; ++k) wilkinson *= Polynomial{-k, 1};
  const Roots roots = isolate_roots(wilkinson, 100);
  REQUIRE(roots.real.size() == 20);
  for (long k = 1; k <= 20; ++k) CHECK(roots.real[static_cast<std::size_t>(k - 1)].contains(k));
}

TEST_CASE("roots: coefficients beyond the range of doubles") {
  const Rational huge = parse_rational("1e400");
  const Roots roots = isolate_roots(Polynomial{huge, 0, 1} * Polynomial{-1, huge}, 200);
  REQUIRE(roots.real.size() == 1);
  REQUIRE(roots.upper.size() == 1);
  CHECK(roots.real[0].contains(1 / huge));
  CHECK(roots.upper[0].im().contains(parse_rational("1e200")));
}

TEST_CASE("roots: clusters and ill-conditioned roots, which doubles do not tell apart") {
  // Chebyshev's T of degree 60 has the roots cos((2k + 1)π/120), and coefficients of 73 bits.
  Polynomial before{1};
  Polynomial chebyshev{0, 1};
  for (long k = 1; k < 60; ++k) {
    Polynomial next = Polynomial{0, 2} * chebyshev - before;
    before = std::exchange(chebyshev, next);
  }
  const Roots cosines = isolate_roots(chebyshev, 100);
  REQUIRE(cosines.real.size() == 60);
  for (std::size_t k = 0; k < 60; ++k) {
    const Rational multiple(2 * static_cast<long>(60 - k) - 1, 120);
    const RealBall angle = multiply(pi(300), RealBall(multiple, 300), 300);
    CHECK(cosines.real[k].overlaps(cos_sin(angle, 300).cos));
    CHECK(cosines.real[k].accuracy_bits() >= 100);
  }
  // The polynomials of Mignotte have two real roots about 10^-66 apart.
  const Polynomial mignotte =
      Polynomial::monomial(1, 20) - Rational(2) * pow(Polynomial{-1, 1'000'000}, 2);
  const Roots near = isolate_roots(mignotte, 100);
  REQUIRE(near.real.size() == 4);
  CHECK(near.upper.size() == 8);
  const RealBall gap = subtract(near.real[2], near.real[1], 100);
  CHECK(gap.lower() > 0);
  CHECK(gap.upper() < parse_rational("1e-65"));
  // Ten roots at a distance of 10^-30 of 1/3, and two others.
  const Rational third(1, 3);
  const Rational size = parse_rational("1e-30");
  const Roots ring = isolate_roots(
      (pow(Polynomial{-third, 1}, 10) - Polynomial{parse_rational("1e-300")}) * Polynomial{5, 1, 1},
      120);
  REQUIRE(ring.real.size() == 2);
  REQUIRE(ring.upper.size() == 5);
  CHECK(ring.real[0].contains(third - size));
  CHECK(ring.real[1].contains(third + size));
  // A pair 10^-500 apart.
  const Rational tiny = parse_rational("1e-500");
  const Roots pair =
      isolate_roots(Polynomial{Rational(third * third + tiny * tiny), Rational(-2 * third), 1} *
                        Polynomial{5, 1, 1},
                    64);
  REQUIRE(pair.upper.size() == 2);
  CHECK(pair.upper[1].re().contains(third));
  CHECK(pair.upper[1].im().contains(tiny));
}
