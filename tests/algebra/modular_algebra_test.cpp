#include "phrame/algebra/modular_algebra.hpp"

#include "phrame/algebra/rational_lift.hpp"
#include "support/random.hpp"

namespace modular_algebra_test {

using namespace phrame;
using test::for_samples;
using test::Random;

namespace {

constexpr ulong prime = 1'000'003;

__extension__ using Wide = unsigned __int128;

ulong product(ulong a, ulong b, ulong p) {
  return static_cast<ulong>(static_cast<Wide>(a) * b % p);
}

ulong power(ulong a, ulong n, ulong p) {
  ulong result = 1;
  for (ulong k = 0; k < n; ++k) result = product(result, a, p);
  return result;
}

/// By Fermat's theorem.
ulong inverse(ulong a, ulong p) {
  ulong result = 1;
  for (ulong n = p - 2; n > 0; n /= 2) {
    if (n % 2 == 1) result = product(result, a, p);
    a = product(a, a, p);
  }
  return result;
}

ulong value(const std::vector<ulong>& ascending, ulong t) {
  ulong sum = 0;
  for (auto c = ascending.rbegin(); c != ascending.rend(); ++c)
    sum = (product(sum, t, prime) + *c) % prime;
  return sum;
}

/// ∏(t − r).
std::vector<ulong> of_roots(const std::vector<ulong>& roots) {
  std::vector<ulong> result{1};
  for (const ulong r : roots) {
    result.insert(result.begin(), 0);
    for (std::size_t k = 0; k + 1 < result.size(); ++k)
      result[k] = (result[k] + product(prime - r, result[k + 1], prime)) % prime;
  }
  return result;
}

std::vector<ulong> different_numbers(Random& random, long count) {
  std::vector<ulong> result;
  for (ulong next = 1; static_cast<long>(result.size()) < count; ++next) {
    next += static_cast<ulong>(random.integer(0, 999));
    result.push_back(next);
  }
  return result;
}

}  // namespace

// Where d has its roots in 𝔽ₚ all is a sum over them.
TEST_CASE("modular algebra: law: traces and residues are sums over the roots") {
  for_samples(30, [](Random& random) {
    const long n = random.integer(1, 12);
    const auto roots = different_numbers(random, n);
    const auto d = of_roots(roots);
    const auto algebra = ModularAlgebra::make(ModularPolynomial(prime, d), n);
    REQUIRE(algebra);
    CHECK(algebra->size() == n);
    CHECK(algebra->prime() == prime);

    std::vector<ulong> c;
    std::vector<ulong> numerator;
    for (long k = 0; k < n; ++k) {
      c.push_back(static_cast<ulong>(random.integer(0, prime - 1)));
      numerator.push_back(static_cast<ulong>(random.integer(0, prime - 1)));
    }
    const ModularPolynomial element(prime, c);
    const ModularPolynomial trace = algebra->trace();
    const auto powers = values_of_powers(*algebra, trace, element, 2 * n + 1);
    REQUIRE(powers.size() == static_cast<std::size_t>(2 * n + 1));
    const ModularPolynomial composed = algebra->compose(trace, element);
    for (long k = 0; k <= 2 * n; ++k) {
      ulong of_variable = 0;
      ulong of_element = 0;
      ulong of_both = 0;
      for (const ulong r : roots) {
        const ulong at = value(c, r);
        of_variable += power(r, static_cast<ulong>(k), prime);
        of_element += power(at, static_cast<ulong>(k), prime);
        of_both += product(at, power(r, static_cast<ulong>(k), prime), prime);
      }
      if (k < n) CHECK(trace.coefficient(k) == of_variable % prime);
      CHECK(powers[static_cast<std::size_t>(k)] == of_element % prime);
      if (k < n) CHECK(composed.coefficient(k) == of_both % prime);
    }

    const ModularPolynomial residue = algebra->residue(ModularPolynomial(prime, numerator));
    ulong discriminant = 1;  // res(d, d′) = ∏ d′(r)
    for (const ulong r : roots) {
      ulong slope = 1;
      for (const ulong s : roots)
        if (s != r) slope = product(slope, (r + prime - s) % prime, prime);
      discriminant = product(discriminant, slope, prime);
      std::vector<ulong> found;
      for (long k = 0; k < n; ++k) found.push_back(residue.coefficient(k));
      CHECK(product(value(found, r), slope, prime) == value(numerator, r));
    }
    CHECK(algebra->discriminant() == discriminant);
  });
}

TEST_CASE("modular algebra: law: values of polynomials at an element, and of forms at it") {
  for_samples(40, [](Random& random) {
    const long n = random.integer(1, 9);
    const std::vector<ulong> roots = different_numbers(random, n);
    const auto algebra = ModularAlgebra::make(ModularPolynomial(prime, of_roots(roots)), n);
    REQUIRE(algebra);
    const auto random_list = [&](long length) {
      std::vector<ulong> list;
      for (long k = 0; k < length; ++k)
        list.push_back(static_cast<ulong>(random.integer(0, 999'999)));
      return list;
    };
    const std::vector<ulong> c = random_list(n);
    std::vector<std::vector<ulong>> lists = {{}, {7}};
    for (long k = random.integer(0, 4); k > 0; --k)
      lists.push_back(random_list(random.integer(1, 30)));
    std::vector<ModularPolynomial> polynomials;
    for (const auto& list : lists) polynomials.emplace_back(prime, list);
    const auto values = values_at(*algebra, polynomials, ModularPolynomial(prime, c));
    REQUIRE(values.size() == lists.size());
    for (std::size_t k = 0; k < lists.size(); ++k) {
      ulong trace = 0;
      for (const ulong r : roots) {
        const ulong expected = value(lists[k], value(c, r));
        ulong found = 0;
        for (long j = n; j-- > 0;)
          found = (product(found, r, prime) + values[k].coefficient(j)) % prime;
        CHECK(found == expected);
        trace += expected;
      }
      CHECK(value_of(algebra->trace(), values[k]) == trace % prime);
    }
  });
}

TEST_CASE("modular algebra: none of a polynomial with a double root, or of another degree") {
  CHECK_FALSE(ModularAlgebra::make(ModularPolynomial(prime, of_roots({3, 5, 3})), 3));
  CHECK_FALSE(ModularAlgebra::make(ModularPolynomial(prime, of_roots({3, 5})), 3));
  CHECK(ModularAlgebra::make(ModularPolynomial(prime, of_roots({3, 5, 4})), 3));
}

TEST_CASE("rational lift: fractions come back from their residues, and one prime confirms them") {
  const std::vector<std::pair<long, long>> fractions{
      {0, 1}, {-7, 3}, {1'234'567'890'123'456'789, 987'654'321'987'654'321}, {-5, 1}};
  RationalLift lift(fractions.size());
  Primes primes;
  std::optional<std::vector<Rational>> found;
  int asked = 0;
  while (!found && asked < 20) {
    const ulong p = primes.next();
    std::vector<ulong> residues;
    for (const auto& [n, d] : fractions) {
      const ulong size = static_cast<ulong>(n < 0 ? -n : n) % p;
      residues.push_back(
          product(n < 0 ? (p - size) % p : size, inverse(static_cast<ulong>(d) % p, p), p));
    }
    found = lift.include(residues, p);
    ++asked;
    if (asked == 1) CHECK_FALSE(found);  // a prime of 62 bits does not tell them
  }
  REQUIRE(found);
  CHECK(asked >= 3);  // numerator and denominator have 60 bits each
  for (std::size_t k = 0; k < fractions.size(); ++k)
    CHECK((*found)[k] == Rational(fractions[k].first, fractions[k].second));
}

}  // namespace modular_algebra_test
