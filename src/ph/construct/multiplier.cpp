#include "phrame/ph/construct/multiplier.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "phrame/algebra/rounding.hpp"
#include "phrame/ph/construct/preimage.hpp"

// With f + Σ x_k B_k, B_k the Bernstein polynomials that are free, and the moments
// c_k = ∫ B_k·A i A*, the condition is Σ x_k c_k = e, e = displacement − ∫ f·A i A*. Its solution
// of least Σ x_k² is x_k = c_k·y with (Σ c_k c_kᵀ) y = e, whether the moments span space or not.

namespace phrame::inline v0 {
namespace {

Rational integral(const Polynomial& p) { return antiderivative(p)(1); }

/// A solution of M y = e, M symmetric and ≥ 0, by elimination; no value where there is none.
std::optional<Vector<Rational>> solved(std::array<Vector<Rational>, 3> m, Vector<Rational> e) {
  std::array<bool, 3> is_used{};
  std::array<std::optional<std::size_t>, 3> row_of;
  for (std::size_t x = 0; x < 3; ++x) {
    std::size_t y = 0;
    while (y < 3 && (is_used[y] || m[y][x] == 0)) ++y;
    if (y == 3) continue;
    is_used[y] = true;
    row_of[x] = y;
    for (std::size_t other = 0; other < 3; ++other) {
      if (other == y || m[other][x] == 0) continue;
      const Rational factor = m[other][x] / m[y][x];
      m[other] = m[other] - factor * m[y];
      e[other] -= factor * e[y];
    }
  }
  for (std::size_t y = 0; y < 3; ++y)
    if (!is_used[y] && e[y] != 0) return std::nullopt;
  Vector<Rational> result;
  for (std::size_t x = 0; x < 3; ++x)
    if (row_of[x]) result[x] = e[*row_of[x]] / m[*row_of[x]][x];
  return result;
}

}  // namespace

std::optional<std::vector<Rational>> multiplier_with(const QuaternionPolynomial& a,
                                                     const std::vector<Rational>& f,
                                                     const Vector<Rational>& displacement,
                                                     MultiplierFreedom freedom) {
  const std::size_t ends = freedom == MultiplierFreedom::all ? 0 : 1;
  const std::size_t degree = std::max(f.size() - 1, std::size_t{2} + 2 * ends);
  const Vector<Polynomial> hodograph = rotated_i(a);
  const auto integral_with = [&](const Polynomial& g) -> Vector<Rational> {
    return {integral(g * hodograph[0]), integral(g * hodograph[1]), integral(g * hodograph[2])};
  };
  std::vector<Vector<Rational>> moments;
  std::array<Vector<Rational>, 3> matrix;
  for (std::size_t k = ends; k + ends <= degree; ++k) {
    std::vector<Rational> unit(degree + 1, 0);
    unit[k] = 1;
    const Vector<Rational> c = integral_with(from_bernstein(unit));
    for (std::size_t y = 0; y < 3; ++y) matrix[y] = matrix[y] + c[y] * c;
    moments.push_back(c);
  }
  const Polynomial before = from_bernstein(f);
  const auto y = solved(matrix, displacement - integral_with(before));
  if (!y) return std::nullopt;
  std::vector<Rational> after = to_bernstein(before, static_cast<long>(degree));
  for (std::size_t k = 0; k < moments.size(); ++k) after[k + ends] += dot(moments[k], *y);
  return after;
}

std::optional<std::vector<Rational>> slight_multiplier(const QuaternionPolynomial& a,
                                                       const std::vector<Rational>& f,
                                                       const Vector<Rational>& displacement,
                                                       MultiplierFreedom freedom) {
  constexpr long least_bits = 20;
  auto after = multiplier_with(a, f, displacement, freedom);
  if (!after) return std::nullopt;
  const std::vector<Rational> before =
      to_bernstein(from_bernstein(f), static_cast<long>(after->size()) - 1);
  const Rational most = *std::ranges::max_element(before) * power_of_two(-least_bits);
  for (std::size_t k = 0; k < before.size(); ++k)
    if (abs((*after)[k] - before[k]) > most) return std::nullopt;
  const bool are_positive = std::ranges::all_of(*after, [](const Rational& x) { return x >= 0; });
  if (!are_positive && multiplier_signs(Curve(a, from_bernstein(*after))).negative)
    return std::nullopt;
  return after;
}

}  // namespace phrame
