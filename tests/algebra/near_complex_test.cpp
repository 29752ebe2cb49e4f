#include "phrame/algebra/near_complex.hpp"

#include "phrame/algebra/gaussian_integer.hpp"
#include "phrame/algebra/rational.hpp"
#include "support/random.hpp"

namespace phrame::inline v0 {
namespace {

using test::for_samples;
using test::Random;

Rational exact(const DoubleDouble& x) { return exact_rational(x.high) + exact_rational(x.low); }
GaussianRational exact(const NearComplex& z) { return {exact(z.re), exact(z.im)}; }

/// With parts of every kind: of one double and of two, 0, of very different sizes.
NearComplex any_number(Random& random) {
  const auto part = [&]() -> DoubleDouble {
    if (random.chance(8)) return {};
    const double high = std::ldexp(static_cast<double>(random.integer(-1L << 53, 1L << 53)),
                                   static_cast<int>(random.integer(-90, -10)));
    if (random.chance(4)) return {high};
    return two_sum(high, high * 0x1p-53 * static_cast<double>(random.integer(-1000, 1000)) / 1024);
  };
  return {part(), part(), 0};
}

/// A number that z may be, at the edge of its disc.
GaussianRational at_edge(const NearComplex& z, Random& random) {
  const Rational r = exact_rational(z.error);
  const GaussianRational centre = exact(z);
  switch (random.integer(0, 3)) {
    case 0:
      return {centre.re + r, centre.im};
    case 1:
      return {centre.re, centre.im - r};
    default:
      return {centre.re - r * Rational(3, 5), centre.im + r * Rational(4, 5)};
  }
}

bool contains(const NearComplex& z, const GaussianRational& x) {
  const GaussianRational centre = exact(z);
  const Rational r = exact_rational(z.error);
  const Rational dx = x.re - centre.re;
  const Rational dy = x.im - centre.im;
  return dx * dx + dy * dy <= r * r;
}

}  // namespace

TEST_CASE("near numbers: law: sums, products and inverses contain those of all they may be") {
  for_samples(3000, [](Random& random) {
    NearComplex z = any_number(random);
    NearComplex w = any_number(random);
    for (NearComplex* x : {&z, &w})
      if (random.chance(2))
        x->error = std::ldexp(pairs::size_above(*x), static_cast<int>(random.integer(-110, -8)));
    const GaussianRational a = at_edge(z, random);
    const GaussianRational b = at_edge(w, random);
    CHECK(contains(z + w, a + b));
    CHECK(contains(z - w, {a.re - b.re, a.im - b.im}));
    CHECK(contains(z * w, a * b));
    CHECK(contains(conjugate(z), {a.re, -a.im}));
    const Rational norm = b.re * b.re + b.im * b.im;
    const NearComplex q = inverse(w);
    if (std::isfinite(q.error)) CHECK(contains(q, {b.re / norm, -b.im / norm}));
    const Rational size = exact_rational(pairs::size_above(z));
    CHECK(exact(z).re * exact(z).re + exact(z).im * exact(z).im <= size * size);
    const double below = pairs::size_below(z);
    if (below > 0)
      CHECK(a.re * a.re + a.im * a.im >= exact_rational(below * below * (1 - 0x1p-50)));
  });
}

TEST_CASE("near numbers: of a hundred bits") {
  const NearComplex z{{1.0, 0x1.2p-54}, {-0.5, 0x1.8p-56}};
  CHECK((z * z).error < 0x1p-101);
  CHECK((z + z).error < 0x1p-102);
  CHECK(inverse(z).error < 0x1p-97);
}

TEST_CASE("near numbers: nothing is known of what overflows, and of the inverse of what may be 0") {
  const NearComplex large{{0x1p600}, {0x1p600}};
  CHECK_FALSE(std::isfinite((large * large * large).error));
  CHECK_FALSE(std::isfinite(inverse({{1.0}, {}, 1.5}).error));
  CHECK_FALSE(std::isfinite(inverse({}).error));
}

}  // namespace phrame
