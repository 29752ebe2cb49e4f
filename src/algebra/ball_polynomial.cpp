#include "phrame/algebra/ball_polynomial.hpp"

#include <algorithm>

#include "phrame/algebra/rounding.hpp"

namespace phrame {
namespace {

/// A part [start, start + width] of [0, 1], and the Bernstein coefficients there.
struct Part {
  Rational start;
  Rational width;
  std::vector<RealBall> coefficients;
};

/// The common sign of all of them, or 0.
int common_sign(const std::vector<RealBall>& coefficients) {
  const int first = sign(coefficients.front());
  const bool agree = std::all_of(coefficients.begin(), coefficients.end(),
                                 [first](const RealBall& c) { return sign(c) == first; });
  return agree ? first : 0;
}

/// Does the polynomial increase, or decrease, on the whole part?
bool is_monotone(const std::vector<RealBall>& coefficients, long bits) {
  std::vector<RealBall> differences;
  for (std::size_t k = 0; k + 1 < coefficients.size(); ++k)
    differences.push_back(subtract(coefficients[k + 1], coefficients[k], bits));
  return !differences.empty() && common_sign(differences) != 0;
}

/// The zero in a part at whose ends p has different signs and on which it is monotone, halved down
/// to 2^−bits as far as the signs of p are certain.
RealBall narrowed(const BallPolynomial& p, const Part& part, long bits, long precision) {
  Rational a = part.start;
  Rational width = part.width;
  const int at_a = sign(part.coefficients.front());
  const Rational goal = power_of_two(-bits);
  const auto sign_after = [&](const Rational& step) {
    return sign(evaluate(p, RealBall(Rational(a + step), precision), precision));
  };
  while (width > goal) {
    Rational step = width / 2;
    int there = sign_after(step);
    if (there == 0) {  // perhaps it is the zero
      step = width * Rational(7, 16);
      there = sign_after(step);
    }
    if (there == 0) break;
    if (there == at_a) {
      a += step;
      width -= step;
    } else {
      width = step;
    }
  }
  return hull(a, Rational(a + width), precision);
}

}  // namespace

BallPolynomial::BallPolynomial(const Polynomial& p, long bits) {
  arb_poly_set_fmpq_poly(raw(), p.raw(), bits);
}

BallPolynomial::BallPolynomial(const std::vector<RealBall>& ascending) {
  for (std::size_t k = 0; k < ascending.size(); ++k)
    arb_poly_set_coeff_arb(raw(), static_cast<slong>(k), ascending[k].raw());
}

RealBall BallPolynomial::coefficient(long k) const {
  RealBall c;
  arb_poly_get_coeff_arb(c.raw(), raw(), k);
  return c;
}

BallPolynomial add(const BallPolynomial& p, const BallPolynomial& q, long bits) {
  BallPolynomial sum;
  arb_poly_add(sum.raw(), p.raw(), q.raw(), bits);
  return sum;
}

BallPolynomial subtract(const BallPolynomial& p, const BallPolynomial& q, long bits) {
  BallPolynomial difference;
  arb_poly_sub(difference.raw(), p.raw(), q.raw(), bits);
  return difference;
}

BallPolynomial multiply(const BallPolynomial& p, const BallPolynomial& q, long bits) {
  BallPolynomial product;
  arb_poly_mul(product.raw(), p.raw(), q.raw(), bits);
  return product;
}

BallPolynomial multiply(const RealBall& c, const BallPolynomial& p, long bits) {
  BallPolynomial product;
  arb_poly_scalar_mul(product.raw(), p.raw(), c.raw(), bits);
  return product;
}

BallPolynomial differentiate(const BallPolynomial& p, long bits) {
  BallPolynomial derivative;
  arb_poly_derivative(derivative.raw(), p.raw(), bits);
  return derivative;
}

RealBall evaluate(const BallPolynomial& p, const RealBall& x, long bits) {
  RealBall value;
  arb_poly_evaluate(value.raw(), p.raw(), x.raw(), bits);
  return value;
}

RealBall range(const BallPolynomial& p, const Rational& a, const Rational& b, long bits) {
  BallPolynomial taylor;
  const Rational middle = (a + b) / 2;
  arb_poly_taylor_shift(taylor.raw(), p.raw(), RealBall(middle, bits).raw(), bits);
  return evaluate(taylor, hull(Rational(a - middle), Rational(b - middle), bits), bits);
}

std::vector<RealBall> to_bernstein(const BallPolynomial& p, long n, long bits) {
  // b_r = Σ_k C(r, k) p_k/C(n, k): sums of p_k/C(n, k), n times over.
  std::vector<RealBall> b;
  Integer binomial = 1;
  for (long k = 0; k <= n; ++k) {
    b.push_back(divide(p.coefficient(k), RealBall(Rational(binomial), bits), bits));
    binomial = binomial * (n - k) / (k + 1);
  }
  for (std::size_t i = 1; i < b.size(); ++i)
    for (std::size_t k = b.size() - 1; k >= i; --k) b[k] = add(b[k], b[k - 1], bits);
  return b;
}

std::pair<std::vector<RealBall>, std::vector<RealBall>> split(
    const std::vector<RealBall>& coefficients, const Rational& share, long bits) {
  const RealBall right_weight(share, bits);
  std::vector<RealBall> row = coefficients;
  std::vector<RealBall> left;
  std::vector<RealBall> right(row.size());
  for (std::size_t length = row.size(); length > 0; --length) {
    left.push_back(row.front());
    right[length - 1] = row[length - 1];
    for (std::size_t k = 0; k + 1 < length; ++k) {
      const RealBall step = subtract(row[k + 1], row[k], bits);
      arb_addmul(row[k].raw(), right_weight.raw(), step.raw(), bits);
    }
  }
  return {std::move(left), std::move(right)};
}

BallPolynomial from_bernstein(std::vector<RealBall> c, long bits) {
  const std::size_t n = c.size() - 1;
  for (std::size_t i = 1; i <= n; ++i)
    for (std::size_t k = n; k >= i; --k) c[k] = subtract(c[k], c[k - 1], bits);
  Integer binomial = 1;
  for (std::size_t k = 0; k <= n; ++k) {
    c[k] = multiply(c[k], RealBall(Rational(binomial), bits), bits);
    binomial = binomial * (n - k) / (k + 1);
  }
  return BallPolynomial(c);
}

SignChanges sign_changes(const BallPolynomial& p, long bits) {
  SignChanges found;
  if (p.degree_bound() < 0) return found;
  const long precision = bits + 64 + 2 * p.degree_bound();
  std::vector<Part> parts{{0, 1, to_bernstein(p, p.degree_bound(), precision)}};
  const Rational narrow = power_of_two(-bits);
  for (long looked_at = 0; !parts.empty(); ++looked_at) {
    const Part part = std::move(parts.back());
    parts.pop_back();
    if (common_sign(part.coefficients) != 0) continue;
    const int before = sign(part.coefficients.front());
    const int after = sign(part.coefficients.back());
    if (before * after != 0 && is_monotone(part.coefficients, precision)) {
      if (before != after) found.at.push_back(narrowed(p, part, bits, precision));
      continue;
    }
    // A polynomial that is nearly 0, or known badly, has undecided parts everywhere.
    if (part.width < narrow || looked_at > 20 * bits) {
      found.undecided.push_back(hull(part.start, Rational(part.start + part.width), precision));
      continue;
    }
    Rational share(1, 2);
    auto halves = split(part.coefficients, share, precision);
    if (sign(halves.second.front()) == 0) {  // a zero there would belong to neither half
      share = Rational(7, 16);
      halves = split(part.coefficients, share, precision);
    }
    const Rational width = share * part.width;
    parts.push_back({part.start + width, part.width - width, std::move(halves.second)});
    parts.push_back({part.start, width, std::move(halves.first)});
  }
  return found;
}

}  // namespace phrame
