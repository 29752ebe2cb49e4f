#include "phrame/algebra/piece_groups.hpp"

#include <algorithm>
#include <limits>

#include "support/random.hpp"

using namespace phrame;
using test::for_samples;
using test::Random;

namespace piece_groups_test {

/// So many pieces on [0, 3], narrow near 1.
PiecewisePolynomial pieces(double least) {
  return {0, 3, plain_shape(1), [=](double low, double high) {
            auto piece = empty_piece(low, high);
            if (!piece || high - low > std::max({low - 1, 1 - high, least})) piece.reset();
            if (piece) piece->coefficients.assign(14, 0);
            return piece;
          }};
}

std::vector<double> parameters(Random& random, const PiecewisePolynomial& p, std::size_t count) {
  std::vector<double> t;
  while (t.size() < count) {
    const double x = std::ldexp(static_cast<double>(random.integer(0, 3L << 40)), -40);
    const std::size_t end = static_cast<std::size_t>(random.integer(0, 1L << 40)) % p.ends().size();
    t.push_back(random.chance(4) ? p.ends()[end] : random.chance(5) ? 3 : x);
    if (random.chance(5) && t.back() > 0) t.back() = std::nextafter(t.back(), 0.0);
  }
  return t;
}

// The pieces are found by their ends alone.
TEST_CASE("piece groups: law: each t is in one group, once, which is of its piece") {
  for_samples(12, [](Random& random) {
    const PiecewisePolynomial p = pieces(random.chance(2) ? 1e-3 : 3);
    for (const std::size_t count : {0, 1, 5, 100, 4096, 9000}) {
      std::vector<double> t = parameters(random, p, count);
      if (random.chance(2)) std::sort(t.begin(), t.end());
      std::vector<int> seen(count);
      for_each_group(p, t, [&](const PieceGroup& group) {
        const auto number = static_cast<std::size_t>(&group.piece - p.pieces().data());
        const bool is_last = number + 1 == p.pieces().size();
        REQUIRE(group.at.size() == group.t.size());
        REQUIRE(!group.t.empty());
        for (std::size_t k = 0; k < group.t.size(); ++k) {
          ++seen.at(group.at[k]);
          CHECK(group.t[k] == t[group.at[k]]);
          CHECK(group.t[k] >= p.ends()[number]);
          CHECK((is_last ? group.t[k] <= 3 : group.t[k] < p.ends()[number + 1]));
        }
      });
      CHECK(std::count(seen.begin(), seen.end(), 1) == static_cast<std::ptrdiff_t>(count));
    }
  });
}

TEST_CASE("piece groups: ascending t are in runs, and others sorted by pieces, not one by one") {
  Random random(3);
  const PiecewisePolynomial p = pieces(1e-3);
  REQUIRE(p.pieces().size() > 10);
  std::vector<double> t = parameters(random, p, 4000);
  for (const bool is_sorted : {false, true}) {
    if (is_sorted) std::sort(t.begin(), t.end());
    std::size_t groups = 0;
    for_each_group(p, t, [&](const PieceGroup&) { ++groups; });
    CHECK(groups <= p.pieces().size());
  }
}

}  // namespace piece_groups_test
