#include "phrame/ph/curve/end_point.hpp"

#include <cstddef>
#include <vector>

#include "phrame/ph/curve/vector.hpp"

namespace phrame::inline v0 {
namespace {

/// Integers over their least common denominator.
struct OverOneDenominator {
  std::vector<Integer> numerators;
  Integer denominator = 1;
};

OverOneDenominator over_one_denominator(const std::vector<Rational>& list) {
  OverOneDenominator result;
  for (const Rational& x : list) {
    const Integer d = denominator(x);
    if (result.denominator % d != 0) result.denominator = lcm(result.denominator, d);
  }
  for (const Rational& x : list)
    result.numerators.push_back(numerator(x) * (result.denominator / denominator(x)));
  return result;
}

}  // namespace

// With r′ = Σ_n f·c_n tⁿ it is start + Σ_n c_n·w_n, w_n = Σ_k f_k/(n + k + 1).
Vector<Rational> end_point(const Curve& curve) {
  if (!curve.is_polynomial())
    return Rational(1 / curve.weight()(1)) * evaluate(numerator(curve), 1);
  const QuaternionPolynomial& a = curve.preimage();
  const auto m = static_cast<std::size_t>(preimage_degree(curve));
  std::vector<Rational> list;
  for (std::size_t k = 0; k <= m; ++k)
    for (const Polynomial* p : {&a.u, &a.v, &a.p, &a.q})
      list.push_back(p->coefficient(static_cast<long>(k)));
  const OverOneDenominator parts = over_one_denominator(list);
  const std::vector<Integer>& x = parts.numerators;
  std::vector<Rational> weights(2 * m + 1);
  for (long n = 0; n <= static_cast<long>(2 * m); ++n)
    for (long k = 0; k <= curve.multiplier().degree(); ++k)
      weights[static_cast<std::size_t>(n)] += curve.multiplier().coefficient(k) / (n + k + 1);
  const OverOneDenominator w = over_one_denominator(weights);
  Vector<Integer> sum;
  for (std::size_t i = 0; i <= m; ++i)
    for (std::size_t j = i; j <= m; ++j) {
      // S(A_i, A_j), which is there twice for i ≠ j.
      const Integer* const b = &x[4 * i];
      const Integer* const c = &x[4 * j];
      const Integer weight = (i == j ? 1 : 2) * w.numerators[i + j];
      sum[0] += weight * (b[0] * c[0] + b[1] * c[1] - b[2] * c[2] - b[3] * c[3]);
      sum[1] += weight * (b[0] * c[3] + b[3] * c[0] + b[1] * c[2] + b[2] * c[1]);
      sum[2] += weight * (b[1] * c[3] + b[3] * c[1] - b[0] * c[2] - b[2] * c[0]);
    }
  const Integer below = parts.denominator * parts.denominator * w.denominator;
  Vector<Rational> end = curve.start();
  for (std::size_t k = 0; k < 3; ++k) end[k] += Rational(sum[k], below);
  return end;
}

}  // namespace phrame
