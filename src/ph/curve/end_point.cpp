#include "phrame/ph/curve/end_point.hpp"

#include <array>
#include <cmath>
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
    if (d != 1 && result.denominator % d != 0) result.denominator = lcm(result.denominator, d);
  }
  result.numerators.reserve(list.size());
  for (const Rational& x : list)
    result.numerators.push_back(result.denominator == 1
                                    ? numerator(x)
                                    : numerator(x) * (result.denominator / denominator(x)));
  return result;
}

/// With r′ = Σ_n f·c_n tⁿ, r(1) − r(0) = Σ_n c_n·w_n, w_n = Σ_k f_k/(n + k + 1).
class Displacement {
 public:
  explicit Displacement(const Curve& curve)
      : m_(static_cast<std::size_t>(preimage_degree(curve))),
        parts_(parts(curve)),
        weights_(weights(curve)),
        below_(parts_.denominator * parts_.denominator * weights_.denominator) {}

  Rational operator[](std::size_t coordinate) const {
    Integer sum;
    for (std::size_t i = 0; i <= m_; ++i)
      for (std::size_t j = i; j <= m_; ++j)
        // S(A_i, A_j), which is there twice for i ≠ j.
        sum += (i == j ? 1 : 2) * weights_.numerators[i + j] *
               product(&parts_.numerators[4 * i], &parts_.numerators[4 * j], coordinate);
    return {sum, below_};
  }

 private:
  static OverOneDenominator parts(const Curve& curve) {
    const QuaternionPolynomial& a = curve.preimage();
    std::vector<Rational> list;
    for (long k = 0; k <= preimage_degree(curve); ++k)
      for (const Polynomial* p : {&a.u, &a.v, &a.p, &a.q}) list.push_back(p->coefficient(k));
    return over_one_denominator(list);
  }
  static OverOneDenominator weights(const Curve& curve) {
    const long degree = 2 * preimage_degree(curve);
    std::vector<Rational> list(static_cast<std::size_t>(degree + 1));
    for (long n = 0; n <= degree; ++n)
      for (long k = 0; k <= curve.multiplier().degree(); ++k)
        list[static_cast<std::size_t>(n)] += curve.multiplier().coefficient(k) / (n + k + 1);
    return over_one_denominator(list);
  }
  /// The coordinate of S(b, c) = (b i c* + c i b*)/2.
  static Integer product(const Integer* b, const Integer* c, std::size_t coordinate) {
    if (coordinate == 0) return b[0] * c[0] + b[1] * c[1] - b[2] * c[2] - b[3] * c[3];
    if (coordinate == 1) return b[0] * c[3] + b[3] * c[0] + b[1] * c[2] + b[2] * c[1];
    return b[1] * c[3] + b[3] * c[1] - b[0] * c[2] - b[2] * c[0];
  }

  std::size_t m_;
  OverOneDenominator parts_;
  OverOneDenominator weights_;
  Integer below_;
};

/// A sum in doubles, and what its terms add up to without their signs.
struct RoughSum {
  double value = 0;
  double size = 0;

  RoughSum& operator+=(const RoughSum& term) {
    value += term.value;
    size += term.size;
    return *this;
  }
};
RoughSum rough(double x) { return {x, std::abs(x)}; }
RoughSum operator*(double factor, const RoughSum& x) {
  return {factor * x.value, std::abs(factor) * x.size};
}

/// x, where products of a few such numbers neither overflow nor underflow; else not a number.
double moderate_double(const Rational& x) {
  if (x == 0) return 0;
  const auto near = static_cast<double>(x);
  return std::abs(near) > 0x1p-200 && std::abs(near) < 0x1p200 ? near : NAN;
}

/// Is it seen in doubles that r(1) is not this point? By x′ = f·(u² + v² − p² − q²) only.
bool is_seen_elsewhere(const Curve& curve, const Vector<Rational>& point) {
  const auto count = static_cast<std::size_t>(preimage_degree(curve) + 1);
  std::vector<RoughSum> weights(2 * count - 1);
  for (long k = 0; k <= curve.multiplier().degree(); ++k) {
    const double f = moderate_double(curve.multiplier().coefficient(k));
    for (std::size_t n = 0; n < weights.size(); ++n)
      weights[n] += rough(f / static_cast<double>(n + static_cast<std::size_t>(k) + 1));
  }
  RoughSum x;
  const QuaternionPolynomial& a = curve.preimage();
  std::vector<double> part(count);
  for (const Polynomial* p : {&a.u, &a.v, &a.p, &a.q}) {
    for (std::size_t k = 0; k < count; ++k)
      part[k] = moderate_double(p->coefficient(static_cast<long>(k)));
    const double sign = p == &a.u || p == &a.v ? 1 : -1;
    for (std::size_t i = 0; i < count; ++i)
      for (std::size_t j = 0; j < count; ++j) x += sign * part[i] * part[j] * weights[i + j];
  }
  x += rough(moderate_double(curve.start()[0]));
  x += rough(-moderate_double(point[0]));
  // A sum of N terms is off by N·2^−53 of its size; weights are such sums, and a term rounds ten
  // times.
  const auto terms = 4 * count * count + static_cast<std::size_t>(curve.multiplier().degree()) + 64;
  return std::abs(x.value) > static_cast<double>(terms) * 0x1p-50 * x.size;
}

Vector<Rational> rational_end_point(const Curve& curve) {
  return Rational(1 / curve.weight()(1)) * evaluate(numerator(curve), 1);
}

}  // namespace

Vector<Rational> end_point(const Curve& curve) {
  if (!curve.is_polynomial()) return rational_end_point(curve);
  const Displacement displacement(curve);
  Vector<Rational> end = curve.start();
  for (std::size_t k = 0; k < 3; ++k) end[k] += displacement[k];
  return end;
}

bool ends_at(const Curve& curve, const Vector<Rational>& point) {
  if (!curve.is_polynomial()) return rational_end_point(curve) == point;
  if (is_seen_elsewhere(curve, point)) return false;
  const Displacement displacement(curve);
  for (std::size_t k = 0; k < 3; ++k)
    if (curve.start()[k] + displacement[k] != point[k]) return false;
  return true;
}

}  // namespace phrame
