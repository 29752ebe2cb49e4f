#include <algorithm>

#include "phrame/algebra/ehrlich_aberth.hpp"

#include "phrame/algebra/rounding.hpp"
#include "support/random.hpp"

using namespace phrame;
using test::for_samples;
using test::Random;

TEST_CASE("enclose roots: law: one known root in each enclosure, whatever the start") {
  for_samples(60, [](Random& random) {
    std::vector<std::pair<Rational, Rational>> known;
    Polynomial p{1};
    const auto append = [&](const Rational& x, const Rational& y) {
      const Polynomial factor =
          y == 0 ? Polynomial{-x, 1} : Polynomial{Rational(x * x + y * y), Rational(-2 * x), 1};
      if ((p % factor).is_zero()) return;
      p *= factor;
      known.emplace_back(x, y);
      if (y != 0) known.emplace_back(x, -y);
    };
    for (long k = random.integer(1, 4); k > 0; --k)
      if (const Rational x = random.rational(); x != 0) append(x, 0);
    // Pairs next to the real axis.
    for (long k = random.integer(0, 4); k > 0; --k)
      append(random.rational(),
             (abs(random.rational()) + 1) * power_of_ten(-random.integer(0, 30)));

    if (p.is_constant()) return;
    CAPTURE(to_string(p));
    // From the real axis no step leads to a conjugate pair; two points are the same.
    std::vector<ComplexBall> start;
    for (std::size_t k = 0; k < known.size(); ++k)
      start.emplace_back(RealBall(Rational(static_cast<long>(k / 2 * 2)), 64), RealBall());
    for (const long bits : {0L, 300L}) {
      const auto found = enclose_roots(integer_primitive_part(p), start, bits);
      REQUIRE(found.size() == known.size());
      for (const auto& root : known)
        CHECK(std::count_if(found.begin(), found.end(), [&](const ComplexBall& z) {
                return z.re().contains(root.first) && z.im().contains(root.second);
              }) == 1);
      for (const ComplexBall& z : found)
        CHECK((bits == 0 || acb_rel_accuracy_bits(z.raw()) >= bits));
    }
  });
}
