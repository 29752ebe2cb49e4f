#include "phrame/algebra/rounded_polynomial.hpp"

#include <cmath>
#include <utility>

#include "phrame/algebra/rounding.hpp"

// Horner's rule, s ← s·t + c from the highest coefficient down, with s and c sums of two doubles
// and t a double. With u = 2^−53 and M ← M·|t| + |c|, which bounds all that is added, at every
// step:
// - the low part is at most 3.2(k + 1)·u·M after k steps, each of which adds the rounding errors of
//   a product, of a sum and the low part of c, each ≤ u·M(1 + 3u);
// - the operations on low parts round, six times for a step, each by at most 3.2(n + 2)·u²·M;
// - c itself is known to u²|c|.
// So that |s − p(t)| ≤ 20(n + 2)²·u²·M at the end. Below, 32 stands for 20, which covers the
// rounding of M; degree and range are such that underflow, 2^−1069 for a step and multiplied by
// |t| ≤ 2 in each that follows, is nothing beside 2^−190·M.

namespace phrame::inline v0 {
namespace {

constexpr long most_horner_steps = 64;
constexpr double largest_t = 2;
constexpr double largest_sum = 0x1p900;
constexpr double least_sum = 0x1p-800;

/// c = high + low up to u²|c|.
DoubleDouble as_two_doubles(const Rational& c) {
  const double high = round_to_double(c);
  if (!std::isfinite(high)) return {high, 0};
  return {high, round_to_double(Rational(c - exact_rational(high)))};
}

}  // namespace

RoundedPolynomial::RoundedPolynomial(Polynomial p) : exact_(std::move(p)) {
  if (exact_.degree() > most_horner_steps) return;
  for (long k = exact_.degree(); k >= 0; --k)
    coefficients_.push_back(as_two_doubles(exact_.coefficient(k)));
}

std::optional<double> RoundedPolynomial::near_value(double t) const {
  const double size = std::abs(t);
  if (!coefficients_.empty() && size <= largest_t) {
    DoubleDouble sum;
    double most = 0;
    for (const DoubleDouble& c : coefficients_) {
      sum = sum * DoubleDouble{t, 0} + c;
      most = most * size + std::abs(c.high);
      if (!(most <= largest_sum)) break;
    }
    if (most >= least_sum && most <= largest_sum) {
      const double steps = static_cast<double>(coefficients_.size() + 1);
      return common_double(sum, 32 * steps * steps * 0x1p-106 * most);
    }
  }
  return std::nullopt;
}

double RoundedPolynomial::operator()(double t) const {
  if (const auto found = rounding_to_nearest([&] { return near_value(t); })) return *found;
  return exact_.is_zero() ? 0 : round_to_double(exact_(exact_rational(t)));
}

}  // namespace phrame
