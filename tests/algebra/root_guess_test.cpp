#include "phrame/algebra/root_guess.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

namespace phrame::inline v0 {
namespace {

/// Sorted by their real parts, each with its relative distance to what is wanted.
void check_roots(const std::vector<double>& f, const std::vector<double>& wanted, double near) {
  auto found = guess_roots(f);
  std::ranges::sort(found, {}, [](const auto& z) { return z.real(); });
  REQUIRE(found.size() == wanted.size());
  for (std::size_t k = 0; k < found.size(); ++k) {
    CAPTURE(k);
    CHECK(std::abs(found[k] - wanted[k]) <= near * std::abs(wanted[k]));
  }
}

}  // namespace

TEST_CASE("roots of a polynomial in doubles") {
  check_roots({24, -50, 35, -10, 1}, {1, 2, 3, 4}, 1e-12);
  check_roots({0, 0, -6, 1, 1}, {-3, 0, 0, 2}, 1e-12);
  check_roots({5}, {}, 0);
  check_roots({}, {}, 0);
  check_roots({0, 0}, {}, 0);
  check_roots({2, 2, 0, 0}, {-1}, 1e-15);
  check_roots({1, -2, 1}, {1, 1}, 1e-6);  // a double one has half of the digits
  // (1 − 10¹⁰⁰t)(1 − t)(1 − 10⁻¹⁰⁰t)
  check_roots({1, -1e100, 1e100, -1}, {1e-100, 1, 1e100}, 1e-12);
}

TEST_CASE("complex roots come in pairs") {
  auto found = guess_roots(std::vector<double>{5, -2, 1});  // 1 ± 2i
  REQUIRE(found.size() == 2);
  if (found[0].imag() < 0) std::swap(found[0], found[1]);
  CHECK(std::abs(found[0] - std::complex(1.0, 2.0)) < 1e-14);
  CHECK(std::abs(found[1] - std::complex(1.0, -2.0)) < 1e-14);
}

}  // namespace phrame
