#include "phrame/algebra/linear_system.hpp"

#include "support/random.hpp"

using namespace phrame;

TEST_CASE("linear system: a known solution; singular and non-square systems have none") {
  // x·(1 + t) + y·(1 − t) = 3 + t: x = 2, y = 1.
  const auto x = solve_for_coefficients({Polynomial{1, 1}, Polynomial{1, -1}}, {3, 1}, 2);
  REQUIRE(x.has_value());
  CHECK(*x == std::vector<Rational>{2, 1});
  CHECK_FALSE(solve_for_coefficients({Polynomial{1, 1}, Polynomial{2, 2}}, {3, 1}, 2));
  CHECK_FALSE(solve_for_coefficients({Polynomial{1}}, {1}, 2));
}

TEST_CASE("linear system: law: the solution satisfies the system") {
  test::for_samples(60, [](test::Random& random) {
    const long n = random.integer(1, 6);
    std::vector<Polynomial> columns;
    for (long k = 0; k < n; ++k) columns.push_back(random.polynomial(n - 1));
    const Polynomial right = random.polynomial(n - 1);
    const auto x = solve_for_coefficients(columns, right, n);
    if (!x) return;
    Polynomial sum;
    for (std::size_t k = 0; k < columns.size(); ++k) sum += (*x)[k] * columns[k];
    CHECK(sum == right);
  });
}
