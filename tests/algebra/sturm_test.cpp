#include "phrame/algebra/sturm.hpp"

#include <algorithm>
#include <set>

#include "phrame/algebra/error.hpp"
#include "support/random.hpp"

namespace sturm_test {

using namespace phrame;
using test::for_samples;
using test::Random;

namespace {

struct Known {
  Polynomial p{1};
  std::set<Rational> roots;
};

/// Rational roots with multiplicities, times quadratics without real roots.
Known known_roots(Random& random) {
  Known known;
  for (long k = random.integer(0, 5); k > 0; --k) {
    const Rational root = random.rational();
    known.roots.insert(root);
    known.p *= pow(Polynomial{-root, 1}, random.integer(1, 3));
  }
  for (long k = random.integer(0, 2); k > 0; --k)
    known.p *= Polynomial{1 + random.integer(0, 5), 1, 1};
  if (random.chance(2)) known.p *= Polynomial{-3};
  return known;
}

Interval random_interval(Random& random) {
  Interval interval{random.rational(), random.rational(), random.chance(2), random.chance(2)};
  if (*interval.lower > *interval.upper) std::swap(interval.lower, interval.upper);
  if (random.chance(4)) interval.lower.reset();
  if (random.chance(4)) interval.upper.reset();
  return interval;
}

bool contains(const Interval& i, const Rational& t) {
  const bool above = !i.lower || (i.lower_closed ? *i.lower <= t : *i.lower < t);
  const bool below = !i.upper || (i.upper_closed ? t <= *i.upper : t < *i.upper);
  return above && below;
}

}  // namespace

TEST_CASE("sturm: roots at the ends count where the end is closed") {
  const Polynomial p{0, -1, 1};  // t(t − 1)
  CHECK(count_real_roots(p, closed_interval(0, 1)) == 2);
  CHECK(count_real_roots(p, open_interval(0, 1)) == 0);
  CHECK(count_real_roots(p, {0, 1, false, true}) == 1);
  CHECK(count_real_roots(p, closed_interval(1, 1)) == 1);
  CHECK(count_real_roots(p, open_interval(1, 1)) == 0);
  CHECK(count_real_roots(p, closed_interval(1, 0)) == 0);
  CHECK(count_real_roots(p, real_line()) == 2);
  CHECK(count_real_roots({7}, real_line()) == 0);
  CHECK_THROWS_AS(count_real_roots({}, real_line()), DomainError);
}

TEST_CASE("sturm: roots closer than 10^-30 are told apart, near misses are no roots") {
  const Rational tiny = parse_rational("1e-30");
  const Rational third(1, 3);
  const Polynomial close = Polynomial{-third, 1} * Polynomial{-third - tiny, 1};
  CHECK(count_real_roots(close, closed_interval(0, 1)) == 2);
  CHECK(isolate_real_roots(close, closed_interval(0, 1)).size() == 2);
  const Polynomial miss = Polynomial{third * third + tiny, -2 * third, 1};  // (t − 1/3)² + 10^-30
  CHECK(count_real_roots(miss, real_line()) == 0);
}

TEST_CASE("sturm: roots that take thousands of bisections to part are isolated") {
  const Rational tiny = Rational(1) / Rational(pow(Integer(10), 800));
  const Polynomial p = Polynomial{-1, 1} * Polynomial{-tiny, 1} * Polynomial{-2 * tiny, 1};
  const auto found = isolate_real_roots(p, open_interval(0, 1));
  REQUIRE(found.size() == 2);
  CHECK((*found[0].lower <= tiny && tiny <= *found[0].upper));
  CHECK((*found[1].lower <= 2 * tiny && 2 * tiny <= *found[1].upper));
}

TEST_CASE("sturm: law: counts and isolation agree with the roots put in") {
  for_samples(300, [](Random& random) {
    const Known known = known_roots(random);
    const Interval interval = random_interval(random);
    std::vector<Rational> inside;
    for (const Rational& root : known.roots)
      if (contains(interval, root)) inside.push_back(root);
    CHECK(count_real_roots(known.p, interval) == static_cast<long>(inside.size()));
    const auto found = isolate_real_roots(known.p, interval);
    REQUIRE(found.size() == inside.size());
    for (std::size_t k = 0; k < found.size(); ++k) {
      CHECK(contains(found[k], inside[k]));
      for (std::size_t j = 0; j < inside.size(); ++j)
        if (j != k) CHECK_FALSE(contains(found[k], inside[j]));
      const Interval narrow = narrowed(known.p, found[k], Rational(1, 1000));
      CHECK(*narrow.upper - *narrow.lower <= Rational(1, 1000));
      CHECK(contains(narrow, inside[k]));
      if (k > 0) CHECK(*found[k - 1].upper <= *found[k].lower);
    }
  });
}

TEST_CASE("sturm: located roots are points where they are rational, else narrow") {
  // (t − 1/3)(t² − 2)
  const auto found = located_real_roots(Polynomial{-1, 3} * Polynomial{-2, 0, 1}, real_line());
  REQUIRE(found.size() == 3);
  CHECK(found[1] == closed_interval(Rational(1, 3), Rational(1, 3)));
  CHECK(*found[2].upper - *found[2].lower <= Rational(1, 1 << 20));
  CHECK(*found[2].lower * *found[2].lower < 2);
  CHECK(*found[2].upper * *found[2].upper > 2);
}

TEST_CASE("sturm: law: the variations of (p, p′) count the distinct roots, Descartes aside") {
  for_samples(100, [](Random& random) {
    const Known known = known_roots(random);
    const SturmChain chain(known.p, differentiate(known.p));
    Rational beyond = 1;
    for (const Rational& root : known.roots) beyond += abs(root);
    CHECK(chain.variations(-beyond) - chain.variations(beyond) ==
          static_cast<long>(known.roots.size()));
  });
}

TEST_CASE(
    "sturm: law: the Cauchy index of Σ cₖ/(t − rₖ) is the sum of the signs of the cₖ inside") {
  for_samples(200, [](Random& random) {
    Polynomial p{1};
    Polynomial q;
    std::vector<std::pair<Rational, Rational>> terms;
    for (long k = random.integer(1, 4); k > 0; --k) {
      const Rational root = random.integer(-20, 20);
      if (p(root) == 0) continue;
      const Rational c = random.chance(2) ? 1 + random.integer(0, 9) : -1 - random.integer(0, 9);
      q = q * Polynomial{-root, 1} + c * p;
      p *= Polynomial{-root, 1};
      terms.emplace_back(root, c);
    }
    const Rational a = Rational(2 * random.integer(-21, 20) + 1, 2);
    const Rational b = a + random.integer(0, 20);
    long index = 0;
    for (const auto& [root, c] : terms)
      if (a < root && root < b) index += c > 0 ? 1 : -1;
    CHECK(cauchy_index(SturmChain(p, q), a, b) == index);
  });
}

}  // namespace sturm_test
