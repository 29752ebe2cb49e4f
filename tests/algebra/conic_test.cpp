#include "phrame/algebra/conic.hpp"

#include "phrame/algebra/integer_factors.hpp"
#include "support/random.hpp"

namespace conic_test {

using namespace phrame;

namespace {

/// Has x² = Ay² + Bz² a solution modulo p³ in which not all of x, y, z are divisible by p?
bool has_solution_modulo(const Integer& a, const Integer& b, long p) {
  const long m = p * p * p;
  const long a0 = static_cast<long>(modulo(a, m));
  const long b0 = static_cast<long>(modulo(b, m));
  std::vector<bool> unit(static_cast<std::size_t>(m)), any(static_cast<std::size_t>(m));
  for (long x = 0; x < m; ++x) {
    any[static_cast<std::size_t>(x * x % m)] = true;
    if (x % p != 0) unit[static_cast<std::size_t>(x * x % m)] = true;
  }
  for (long y = 0; y < m; ++y)
    for (long z = 0; z < m; ++z) {
      const auto square = static_cast<std::size_t>(((a0 * y % m) * y + (b0 * z % m) * z) % m);
      if (y % p == 0 && z % p == 0 ? unit[square] : any[square]) return true;
    }
  return false;
}

}  // namespace

TEST_CASE("conic: y² = q(t) by a parameter, or a prime for which there is no point") {
  test::Random random(20262);
  long solved = 0;
  long refused = 0;
  for (int round = 0; round < 60; ++round) {
    const long a = random.integer(1, 60);
    const long b = random.integer(-9, 9);
    const long c = b * b / (4 * a) + random.integer(1, 50);
    const Rational unit(1, random.integer(1, 3));
    const Polynomial q{unit * c, unit * b, unit * a};
    CAPTURE(q);
    const ConicParameters found = conic_parameters(q);
    if (found.form) {
      ++solved;
      const auto& [t, y] = *found.form;
      CHECK(y * y == compose(RationalFunction(q), t));
      CHECK(t.numerator().degree() <= 2);
      CHECK(t.denominator().degree() <= 2);
      CHECK(!constant(t));
      continue;
    }
    ++refused;
    REQUIRE(found.prime > 2);
    const Rational lead = unit * a;
    CHECK(squarefree_rest(numerator(lead) * denominator(lead)) == found.radicand);
    const Rational gap = unit * unit * (4 * a * c - b * b);
    const auto p = static_cast<long>(found.prime);
    if (p < 8)
      CHECK_FALSE(has_solution_modulo(squarefree_rest(numerator(lead) * denominator(lead)),
                                      -squarefree_rest(numerator(gap) * denominator(gap)), p));
  }
  CHECK(solved > 10);
  CHECK(refused > 10);
}

TEST_CASE("conic: the parabola's, one with a point far away, none, and one too large to factor") {
  // 1 + 4t² is y² for t = (1 − m²)/(4m).
  const auto parabola = conic_parameters({1, 0, 4});
  REQUIRE(parabola.form);
  CHECK((*parabola.form)[0] == RationalFunction(Polynomial{1, 0, -1}, Polynomial{0, 4}));
  // 3t² + 1 has the point (0, 1); 3t² + 2 is 2 modulo 3 at all t without a 3 below.
  CHECK(conic_parameters({1, 0, 3}).form);
  const auto none = conic_parameters({2, 0, 3});
  CHECK_FALSE(none.form);
  CHECK(none.prime == 3);
  CHECK(none.radicand == 3);
  // Through a point with large numbers, of which the search cannot know.
  const Integer p("1000000000000000000117");
  const Rational t(123456789, 987654321), y(1234567890123, 7);
  const Polynomial q{y * y - 23 * t * t - t * Rational(p), Rational(p), 23};
  if (4 * 23 * q.coefficient(0) > q.coefficient(1) * q.coefficient(1)) {
    const auto far = conic_parameters(q);
    if (far.form)
      CHECK((*far.form)[1] * (*far.form)[1] == compose(RationalFunction(q), (*far.form)[0]));
  }
  const Integer large = (pow(Integer(10), 45) + 9) * (pow(Integer(10), 47) + 63);
  const auto unknown =
      conic_parameters({2 * Rational(large), 0, 3 * Rational(large) * Rational(large + 2)});
  CHECK_FALSE(unknown.form);
}

}  // namespace conic_test
