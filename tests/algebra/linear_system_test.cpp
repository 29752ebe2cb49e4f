#include "phrame/algebra/linear_system.hpp"

#include "support/random.hpp"

using namespace phrame;

TEST_CASE("linear relations: of t, t² − t, t² and 1, and of none") {
  using Relations = std::vector<std::vector<Rational>>;
  // t + (t² − t) − t² = 0.
  CHECK(linear_relations({{0, 1}, {0, -1, 1}, {0, 0, 1}, {1}}) == Relations{{-1, -1, 1, 0}});
  CHECK(linear_relations({{1, 1}, {1, -1}}).empty());
  CHECK(linear_relations({{}, {}}) == Relations{{1, 0}, {0, 1}});
  CHECK(linear_relations({}).empty());
}

TEST_CASE("linear relations: law: they hold, and without the dependent ones there are none") {
  test::for_samples(60, [](test::Random& random) {
    std::vector<Polynomial> p;
    for (long k = random.integer(1, 5); k > 0; --k) p.push_back(random.polynomial(4));
    if (random.chance(2)) p.push_back(random.rational() * p[0] + p.back());
    const auto relations = linear_relations(p);
    std::vector<Polynomial> others = p;
    for (const auto& relation : relations) {
      Polynomial sum;
      for (std::size_t k = 0; k < p.size(); ++k) sum += relation[k] * p[k];
      CHECK(sum.is_zero());
      std::size_t last = p.size() - 1;
      while (relation[last] == 0) --last;
      CHECK(relation[last] == 1);
      others[last] = Polynomial::monomial(1, 100 + static_cast<long>(last));
    }
    CHECK(linear_relations(others).empty());
  });
}
