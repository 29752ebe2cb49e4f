#include "phrame/algebra/least_squares.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

namespace phrame::inline v0 {
namespace {

constexpr double rounding = 1e-12;

void check_near(const std::vector<double>& found, const std::vector<double>& wanted) {
  REQUIRE(found.size() == wanted.size());
  for (std::size_t k = 0; k < found.size(); ++k) {
    CAPTURE(k);
    CHECK(std::abs(found[k] - wanted[k]) < rounding);
  }
}

/// The columns of the pseudo-inverse, times its denominator.
void check_inverse(const DoubleRows& matrix, const DoubleRows& wanted, double denominator) {
  const LeastSquares inverse(matrix, 1e-12);
  for (std::size_t k = 0; k < matrix.size(); ++k) {
    std::vector<double> unit(matrix.size(), 0.0);
    unit[k] = 1;
    std::vector<double> column;
    for (const auto& row : wanted) column.push_back(row[k] / denominator);
    check_near(inverse(unit), column);
  }
}

}  // namespace

// The inverses are those of SymPy's Matrix.pinv().
TEST_CASE("the pseudo-inverse of more, fewer and dependent equations") {
  check_inverse({{1, 2}, {3, 4}, {5, 7}}, {{-29, 11, 2}, {21, -7, 0}}, 14);
  check_inverse({{1, 2, 0, 1}, {0, 1, 1, 3}}, {{11, -5}, {17, -4}, {-5, 6}, {-4, 13}}, 41);
  check_inverse({{1, 2, 3}, {4, 5, 6}, {7, 8, 9}}, {{-23, -6, 11}, {-2, 0, 2}, {19, 6, -7}}, 36);
  check_inverse({{0, 0}, {0, 0}, {0, 0}}, {{0, 0, 0}, {0, 0, 0}}, 1);
  check_inverse({{2, 2, 2}, {2, 2, 2}}, {{1, 1}, {1, 1}, {1, 1}}, 12);
  check_inverse({{-5}}, {{1}}, -5);
}

TEST_CASE("what is small beside the greatest is nothing, if that is wanted") {
  const DoubleRows nearly{{1, 0}, {0, 1e-8}};
  check_near(LeastSquares(nearly, 1e-6)(std::vector{1.0, 1.0}), {1, 0});
  const std::vector<double> found = LeastSquares(nearly, 1e-10)(std::vector{1.0, 1.0});
  CHECK(found[1] == doctest::Approx(1e8));
}

TEST_CASE("the least singular vector") {
  const auto up_to_sign = [](const DoubleRows& matrix, std::vector<double> wanted) {
    const std::vector<double> x = least_singular_vector(matrix);
    CHECK(euclidean_norm(x) == doctest::Approx(1));
    if (x[0] * wanted[0] < 0)
      for (double& w : wanted) w = -w;
    check_near(x, wanted);
  };
  // The kernels of Gauss's elimination.
  up_to_sign({{1, 2, 3}, {4, 5, 6}, {7, 8, 9}},
             {1 / std::sqrt(6), -2 / std::sqrt(6), 1 / std::sqrt(6)});
  up_to_sign({{1, 0, -1}, {0, 1, -1}}, {1 / std::sqrt(3), 1 / std::sqrt(3), 1 / std::sqrt(3)});
  up_to_sign({{0, 1}, {0, 2}, {0, 3}}, {1, 0});
  // Strang, Linear Algebra, 7.1: singular values 3√5 and √5.
  const std::vector<double> x = least_singular_vector({{3, 0}, {4, 5}});
  CHECK(std::hypot(3 * x[0], 4 * x[0] + 5 * x[1]) < 1.01 * std::sqrt(5));
}

TEST_CASE("elimination leaves what is apart as it is") {
  check_near(eliminated({{0, 2, 0}, {1, 1, 0}, {0, 0, 3}}, {4, 5, 7}), {3, 2, 7.0 / 3});
  const std::vector<double> alone =
      eliminated({{0.1, 0.7, 0}, {0.3, 0.2, 0}, {0, 0, 3}}, {1, 1, 0});
  CHECK(alone[2] == 0);
  CHECK(!std::isfinite(eliminated({{1, 1}, {1, 1}}, {1, 2})[0]));
}

TEST_CASE("no number gives no number, or no change") {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double x : LeastSquares({{nan, 1}, {1, nan}}, 1e-10)(std::vector{1.0, 1.0}))
    CHECK((x == 0 || !std::isfinite(x)));
}

}  // namespace phrame
