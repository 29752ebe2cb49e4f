#include "phrame/ph/curve/end_point.hpp"

#include "support/random.hpp"

namespace end_point_test {

using namespace phrame;
using test::for_samples;
using test::Random;

// The polynomial r at 1 is another way.
TEST_CASE("end_point: r(1), for all degrees of A and f") {
  for_samples(30, [](Random& random) {
    const auto polynomial = [&](long degree) {
      std::vector<Rational> c;
      for (long k = 0; k <= degree; ++k)
        c.emplace_back(random.integer(-99, 99), random.integer(1, 9));
      c.back() += 1000;
      return Polynomial(c);
    };
    const long m = random.integer(0, 5);
    const QuaternionPolynomial a{polynomial(m), polynomial(random.integer(0, m)), polynomial(m),
                                 polynomial(random.integer(0, m))};
    const Curve curve(a, polynomial(random.integer(0, 4)), {1, Rational(2, 3), -5});
    const Vector<Rational> end = evaluate(position(curve), 1);
    CHECK(end_point(curve) == end);
    CHECK(ends_at(curve, end));
    Vector<Rational> other = end;
    other[static_cast<std::size_t>(random.integer(0, 2))] += Rational(1, 1000);
    CHECK_FALSE(ends_at(curve, other));
  });
  CHECK(end_point(Curve({{}, {}, {}, {0, 1}})) == Vector<Rational>{Rational(-1, 3), 0, 0});
}

}  // namespace end_point_test
