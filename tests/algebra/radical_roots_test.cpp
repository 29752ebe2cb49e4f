#include "phrame/algebra/radical_roots.hpp"

#include <algorithm>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/factor.hpp"
#include "phrame/algebra/roots.hpp"
#include "support/random.hpp"

namespace radical_roots_test {

using namespace phrame;
using test::for_samples;
using test::Random;

namespace {

const Radical i = Radical::imaginary_unit();

bool uses(const Radical& x, Radical::Kind kind) {
  return std::any_of(x.steps().begin(), x.steps().end(),
                     [&](const Radical::Step& step) { return step.kind == kind; });
}

/// lead · ∏ (t − z) contains p, and each root lies in the certified enclosure of its place: this
/// needs neither formula nor matching.
void check_roots(const Polynomial& p, const std::vector<Radical>& roots, long bits = 400) {
  CAPTURE(to_string(p));
  REQUIRE(static_cast<long>(roots.size()) == p.degree());
  std::vector<ComplexBall> balls;
  for (const Radical& x : roots) balls.push_back(enclose(x, bits));
  std::vector<ComplexBall> product{{RealBall(p.leading_coefficient(), bits), RealBall()}};
  for (const ComplexBall& z : balls) {
    product.insert(product.begin(), ComplexBall());
    for (std::size_t k = 0; k + 1 < product.size(); ++k)
      acb_submul(product[k].raw(), product[k + 1].raw(), z.raw(), 2 * bits);
  }
  for (std::size_t k = 0; k < product.size(); ++k) {
    CHECK(product[k].re().contains(p.coefficient(static_cast<long>(k))));
    CHECK(product[k].im().contains_zero());
  }
  const Roots certified = isolate_roots(p, bits);
  // No number below the real axis or on its negative part hides in a square root.
  for (std::size_t k = certified.real.size(); k < roots.size(); ++k)
    CHECK(uses(roots[k], Radical::Kind::imaginary_unit));
  const std::size_t real = certified.real.size();
  const std::size_t upper = certified.upper.size();
  for (std::size_t k = 0; k < real; ++k) CHECK(balls[k].overlaps({certified.real[k], RealBall()}));
  for (std::size_t k = 0; k < upper; ++k) {
    CHECK(balls[real + k].overlaps(certified.upper[k]));
    CHECK(balls[real + upper + k].overlaps(conjugate(certified.upper[k])));
  }
}

std::vector<Radical> checked_roots(const Polynomial& p) {
  auto roots = roots_by_radicals(p);
  check_roots(p, roots);
  return roots;
}

Radical root_of(const Rational& x) { return sqrt(Radical(x)); }
Radical cube_root_of(const Rational& x) { return cbrt(Radical(x)); }

}  // namespace

TEST_CASE("radical roots: of degree 1 and 2 are rational numbers and surds") {
  CHECK(checked_roots({3, -2}) == std::vector<Radical>{Rational(3, 2)});
  CHECK(checked_roots({-1, -1, 1}) ==
        std::vector<Radical>{Rational(1, 2) - root_of(5) / 2, Rational(1, 2) + root_of(5) / 2});
  CHECK(checked_roots({1, 1, 1}) == std::vector<Radical>{Rational(-1, 2) + i * root_of(3) / 2,
                                                         Rational(-1, 2) - i * root_of(3) / 2});
  CHECK(checked_roots({1, 0, 9}) == std::vector<Radical>{i / 3, -i / 3});
}

TEST_CASE("radical roots: of a pure cubic, where S or R is 0, one cube root") {
  const auto roots = checked_roots({-2, 0, 0, 1});
  CHECK(roots[0] == cube_root_of(2));
  CHECK(roots[1] == -cube_root_of(2) / 2 + i * root_of(3) * cube_root_of(2) / 2);
  CHECK(checked_roots({2, 0, 0, 1})[0] == -cube_root_of(2));
  CHECK(checked_roots({-9, 12, -6, 1})[0] == 2 + cube_root_of(1));  // (t − 2)³ = 1: 3 is a root
  CHECK(checked_roots({-10, 12, -6, 1})[0] == 2 + cube_root_of(2));
}

TEST_CASE("radical roots: of x³ + x + 1 and x³ − 6x − 6, one real root by real cube roots") {
  const auto roots = checked_roots({1, 1, 0, 1});
  CHECK(roots[0] == cbrt(12 * root_of(93) - 108) / 6 - cbrt(12 * root_of(93) + 108) / 6);
  CHECK_FALSE(uses(roots[0], Radical::Kind::imaginary_unit));
  CHECK(checked_roots({-6, -6, 0, 1})[0] == cube_root_of(4) + cube_root_of(2));
  CHECK(checked_roots({6, -6, 0, 1})[0] == -cube_root_of(4) - cube_root_of(2));
  CHECK(checked_roots({-3, 3, 0, 1}).size() == 3);   // Q > 0, R > 0
  CHECK(checked_roots({30, -6, 0, 1}).size() == 3);  // Q < 0, R < 0
  CHECK(checked_roots({1, 1, 1, 1})[0] == Radical(-1));
}

TEST_CASE("radical roots: three real roots are sums of conjugate complex cube roots") {
  const auto roots = checked_roots({1, -3, 0, 1});
  const Radical omega = Rational(-1, 2) + i * root_of(3) / 2;
  const Radical conjugate_omega = Rational(-1, 2) - i * root_of(3) / 2;
  CHECK(roots[2] == cbrt(4 * (i * root_of(3)) - 4) / 2 + cbrt(-4 - 4 * (i * root_of(3))) / 2);
  CHECK(enclose(roots[2], 200).overlaps(enclose(cbrt(omega) + cbrt(conjugate_omega), 200)));
  for (const Radical& x : roots) CHECK(enclose(x, 200).im().contains_zero());
  checked_roots({-1, -3, 0, 1});
  checked_roots({1, -2, -1, 1});  // 2 cos(2π/7)
}

TEST_CASE("radical roots: of a quartic whose resolvent splits, by Euler's formula") {
  CHECK(checked_roots({1, 0, -10, 0, 1}) ==
        std::vector<Radical>{-root_of(2) - root_of(3), root_of(2) - root_of(3),
                             root_of(3) - root_of(2), root_of(2) + root_of(3)});
  const Radical half = root_of(2) / 2;
  CHECK(checked_roots({1, 0, 0, 0, 1})[1] == half + i * root_of(2) / 2);
  checked_roots({1, 0, -1, 0, 1});
  // √2 + √3 + √6 and, with the other sign of the product, √2 + √3 − √6; then with √−1 and √−2.
  checked_roots({-23, -48, -22, 0, 1});
  checked_roots({-23, 48, -22, 0, 1});
  checked_roots({9, 0, 2, 0, 1});
  CHECK(checked_roots({144, 0, 12, 0, 1}).size() == 4);
}

TEST_CASE("radical roots: of the two quartics of Farouki's quintic of 2003") {
  const auto is = [](const Radical& x, const char* re, const char* im) {
    const ComplexBall z = enclose(x, 64);
    const Rational error = parse_rational("1e-12");
    return abs((z.re().lower() - parse_rational(re))) < error &&
           abs((z.im().lower() - parse_rational(im))) < error;
  };
  const auto sigma = checked_roots({6, -12, 46, -72, 37});
  CHECK(is(sigma[0], "0.012018388019", "0.394440354901"));
  CHECK(is(sigma[1], "0.960954584954", "0.343344423853"));
  const auto rho = checked_roots({720, -2976, 3376, -544, 80});
  CHECK(is(rho[0], "0.493692520439", "0.069302855662"));
  CHECK(is(rho[1], "2.906307479561", "5.269302855662"));
}

TEST_CASE("radical roots: of biquadratic quartics, where E = 0") {
  CHECK(checked_roots({-2, 0, 0, 0, 1})[1] == sqrt(root_of(2)));
  CHECK(checked_roots({2, 0, 0, 0, 1}).size() == 4);  // i√2 under the root
  const auto is_real = [](const Radical& x) { return !uses(x, Radical::Kind::imaginary_unit); };
  const auto four = checked_roots({3, 0, -5, 0, 1});  // real roots
  CHECK(std::all_of(four.begin(), four.end(), is_real));
  CHECK(checked_roots({3, 0, 5, 0, 1}).size() == 4);  // no real root
  const auto two = checked_roots({-3, 0, 5, 0, 1});
  CHECK(std::count_if(two.begin(), two.end(), is_real) == 2);
  CHECK(checked_roots({-1, 0, -1, 0, 1}).size() == 4);
  CHECK(checked_roots(compose({3, 0, -5, 0, 1}, {Rational(2, 3), 1})).size() == 4);
  for (const Radical& x : roots_by_radicals({3, 0, 5, 0, 1})) CHECK(x.steps().size() <= 4);
}

TEST_CASE("radical roots: of a quartic whose resolvent has one rational root, without ∛") {
  // w³ + 2pw² + (p² − 4r)w = q² for w = 1 where 4r = (p + 1)² − q², and for w = −1 where
  // 4r = (p − 1)² + q².
  for (const Polynomial& p : {Polynomial{3, 2, 3, 0, 1},
                              {2, 1, 2, 0, 1},
                              {5, 4, -7, 0, 1},
                              {8, 2, -7, 0, 1},
                              {2, 2, 3, 0, 1},
                              {8, -4, 5, 0, 1}})
    for (const Radical& x : checked_roots(p)) CHECK_FALSE(uses(x, Radical::Kind::cube_root));
  // (t² + t + √2)(t² + t − √2) shifted: irreducible, with a resolvent root.
  const Polynomial product{-2, 0, 1, 2, 1};
  for (const Radical& x : checked_roots(product)) CHECK_FALSE(uses(x, Radical::Kind::cube_root));
  // (t² + √2·t + 1 + √2) times its conjugate.
  for (const Radical& x : checked_roots({-1, -4, 0, 0, 1}))
    CHECK_FALSE(uses(x, Radical::Kind::cube_root));
}

TEST_CASE("radical roots: of general quartics by Ferrari's formula") {
  for (const Polynomial& p : {Polynomial{1, 1, 0, 0, 1},
                              {-1, -1, 0, 0, 1},
                              {1, -1, 0, 0, 1},
                              {-1, 1, 0, 0, 1},
                              {1, 1, -4, 0, 1},
                              {1, -1, -4, 0, 1},
                              {5, 1, 3, 2, 7},
                              {-1, 2, 3, 5, 1}}) {
    const auto roots = checked_roots(p);
    CHECK(uses(roots[0], Radical::Kind::cube_root));
    if (p.coefficient(2) == 0)  // the resolvent has one real root: no complex cube root
      for (std::size_t k = 0; k < isolate_roots(p, 64).real.size(); ++k)
        CHECK_FALSE(uses(roots[k], Radical::Kind::imaginary_unit));
  }
  // S = 0 in the resolvent, p² + 12r = 0: its root is one cube root.
  for (const Polynomial& p : {Polynomial{-3, 5, 6, 0, 1}, {-3, -5, 6, 0, 1}, {-3, 1, -6, 0, 1}})
    for (const Radical& x : checked_roots(p))
      CHECK(std::count_if(x.steps().begin(), x.steps().end(), [](const Radical::Step& step) {
              return step.kind == Radical::Kind::cube_root;
            }) == 1);
  // The resolvent has three real roots: with four real roots and with none.
  checked_roots({1, 1, -5, 0, 1});
  checked_roots({5, 1, 5, 0, 1});
}

TEST_CASE("radical roots: what is refused") {
  CHECK_THROWS_AS(roots_by_radicals({7}), DomainError);
  CHECK_THROWS_AS(roots_by_radicals({3, 4, 0, 0, 1}), DomainError);  // (t + 1)²(t² − 2t + 3)
  CHECK_THROWS_WITH_AS(roots_by_radicals({-1, -1, 0, 0, 0, 1}),
                       "roots_by_radicals: the irreducible factor t^5 - t - 1 has a degree > 4",
                       DomainError);
}

TEST_CASE("radical roots: of a product, of reducible quartics and of degree 9") {
  CHECK(checked_roots({0, -1, 0, 1}) == std::vector<Radical>{-1, 0, 1});
  checked_roots({3, 8, 0, 0, 1});
  checked_roots(Polynomial{1, 1, 0, 0, 1} * Polynomial{1, -3, 0, 1} * Polynomial{-2, 0, 1});
}

TEST_CASE("radical roots: roots of a quartic 10^-30 apart, coefficients of 100 digits") {
  const Rational tiny = parse_rational("1e-60");
  // (t² − 2)² = 10⁻⁶⁰·t: two pairs of neighbours.
  checked_roots({4, -tiny, -4, 0, 1});
  const Rational huge = parse_rational("1e100");
  checked_roots({huge + 7, -huge, 3, huge, 1});
  checked_roots({huge, 1, huge * huge, 1});
  checked_roots({1, 1, huge, 1, 1});
}

TEST_CASE("radical roots: law: random polynomials of degree ≤ 4, all roots in their places") {
  for_samples(60, [](Random& random) {
    const Polynomial p = random.nonconstant_polynomial(4);
    if (!is_squarefree(p)) return;
    checked_roots(p);
  });
}

TEST_CASE("radical roots: law: quartics and cubics with coefficients of 60 digits") {
  for_samples(6, [](Random& random) {
    const auto coefficient = [&] {
      Integer n = random.integer(1, 1'000'000'000);
      for (int k = 0; k < 6; ++k) n = n * 1'000'000'000 + Integer(random.integer(0, 999'999'999));
      return Rational(random.chance(2) ? -n : n);
    };
    const long degree = random.integer(3, 4);
    std::vector<Rational> c;
    for (long k = 0; k <= degree; ++k) c.push_back(coefficient());
    checked_roots(Polynomial(c));
  });
}

TEST_CASE("radical roots: law: quartics of each kind: t ↦ r·t + s, with factors over ℚ(√d)") {
  for_samples(60, [](Random& random) {
    // (t² + at + b)² − d(ct + e)².
    const Polynomial square = pow(Polynomial{random.integer(-5, 5), random.integer(-4, 4), 1}, 2);
    const Polynomial line = pow(Polynomial{random.integer(-4, 4), random.integer(-4, 4)}, 2);
    const Rational stretch = Rational(random.integer(1, 5), random.integer(1, 5));
    const Polynomial p =
        compose(square - Rational(random.integer(-6, 6)) * line, {random.rational(), stretch});
    if (!is_squarefree(p)) return;
    for (const Radical& x : checked_roots(p)) CHECK_FALSE(uses(x, Radical::Kind::cube_root));
  });
}

}  // namespace radical_roots_test
