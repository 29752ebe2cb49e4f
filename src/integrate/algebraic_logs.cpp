// Σ c·log|v(b)/v(a)| + Σ e·arg v(b)/v(a), c and e rational. With real algebraic v(a), v(b), by
// Baker's theorem it is a rational multiple of π only where the first sum is 0, which is |G(b)| =
// |G(a)| for the product G of the powers v^(s·c), s a common denominator; and where with the
// product V of the powers v^(q·e) for a whole q the number V(b)/V(a) is real: that is so where Re
// V/Im V has equal values, infinite ones included. At ±∞ the monic v count as 1 (see LogChange), so
// that V is real.
#include "phrame/integrate/algebraic_logs.hpp"

#include <cmath>

#include "phrame/algebra/algebraic_image.hpp"
#include "phrame/algebra/ball_order.hpp"
#include "phrame/algebra/bivariate.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/algebra/power_product.hpp"

namespace phrame::inline v0 {
namespace {

constexpr long first_root_bits = 256;
constexpr long largest_denominator = 24;
constexpr long largest_exponent = 4096;

/// vᵏ modulo p, k ≥ 0.
GaussianPolynomial power(const GaussianPolynomial& v, long k, const Polynomial& p) {
  GaussianPolynomial result{{1}, {}};
  GaussianPolynomial square{v.re % p, v.im % p};
  for (; k > 0; k /= 2) {
    const auto times_square = [&](const GaussianPolynomial& x) {
      const GaussianPolynomial product = x * square;
      return GaussianPolynomial{product.re % p, product.im % p};
    };
    if (k % 2 == 1) result = times_square(result);
    square = times_square(square);
  }
  return result;
}

/// factor·scale, where it is a whole number that is not large.
std::optional<long> exponent(const Rational& factor, const Rational& scale) {
  const Rational k = factor * scale;
  if (denominator(k) != 1 || abs(k) > largest_exponent) return std::nullopt;
  return static_cast<long>(numerator(k));
}

/// The absolute value of ∏ v^(scale·factor) at a finite end.
std::optional<RealAlgebraic> size(const GaussianLogs& logs, const Rational& scale,
                                  const Endpoint& end) {
  const auto x = finite(end);
  if (!x) return RealAlgebraic(1);
  const QuotientRing ring(x->polynomial());
  Polynomial above{1};
  Polynomial below{1};
  for (const auto& [factor, v] : logs.logarithms) {
    const auto k = exponent(factor, scale);
    if (!k) return std::nullopt;
    Polynomial& product = *k > 0 ? above : below;
    product = ring.multiply(product, power({v, {}}, std::abs(*k), x->polynomial()).re);
  }
  RealAlgebraic value = image(ring.divide(above, below), *x);
  return compare(value, Rational(0)) < 0 ? affine(value, -1, 0) : value;
}

/// Where ∏ v^(scale·factor) points: Re/Im, no value for a real number.
struct Direction {
  std::optional<RealAlgebraic> slope;
  friend bool operator==(const Direction&, const Direction&) = default;
};

std::optional<Direction> direction(const GaussianLogs& logs, const Rational& scale,
                                   const Endpoint& end) {
  const auto x = finite(end);
  if (!x) return Direction{};
  const Polynomial& p = x->polynomial();
  GaussianPolynomial product{{1}, {}};
  for (const auto& [factor, v] : logs.arguments) {
    const auto k = exponent(factor, scale);
    if (!k) return std::nullopt;
    product = product * power(*k > 0 ? v : conjugate(v), std::abs(*k), p);
    product = {product.re % p, product.im % p};
  }
  if (product.im.is_zero()) return Direction{};
  return Direction{image(QuotientRing(p).divide(product.re, product.im), *x)};
}

/// A number by which all factors become whole.
template <class Terms>
Rational common_scale(const Terms& terms) {
  std::vector<Power> powers;
  for (const auto& term : terms) powers.push_back({{1, 0}, term.factor});
  return Rational(common_denominator(powers));
}

}  // namespace

std::optional<Rational> multiple_of_pi(const GaussianLogs& logs, const Endpoint& a,
                                       const Endpoint& b, const Real::Enclosure& enclose) {
  if (!logs.others.empty()) throw DomainError("multiple_of_pi: a residue is not in ℚ(i)");
  const RealBall turn = divide(enclose(first_root_bits), pi(first_root_bits), first_root_bits);
  // A multiple of 1/unit is looked for; most numbers are near none.
  const Rational scale = common_scale(logs.arguments);
  Rational unit = scale;
  const auto nearest = [&](const RealBall& x) -> std::optional<Rational> {
    const RealBall multiple = multiply(x, RealBall(unit, first_root_bits), first_root_bits);
    const auto whole = unique_integer(multiple);
    return whole ? std::optional(*whole / unit) : std::nullopt;
  };
  std::optional<Rational> found = nearest(turn);
  for (long q = 2; q <= largest_denominator && !found; ++q) {
    unit = q * scale;
    found = nearest(turn);
  }
  if (!found) return std::nullopt;

  const Rational of_sizes = common_scale(logs.logarithms);
  const auto size_at_a = size(logs, of_sizes, a);
  const auto size_at_b = size_at_a ? size(logs, of_sizes, b) : std::nullopt;
  if (!size_at_b || !(*size_at_a == *size_at_b)) return std::nullopt;
  const auto from = direction(logs, unit, a);
  const auto to = from ? direction(logs, unit, b) : std::nullopt;
  if (!to || !(*from == *to)) return std::nullopt;
  return found;
}

}  // namespace phrame
