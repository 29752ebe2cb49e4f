// While arg γ rises through π/2 + kπ the quotient y/x jumps from +∞ to −∞. Hence, with x ≠ 0 at
// both ends, arg γ(b) − arg γ(a) = arctan(y/x)(b) − arctan(y/x)(a) − π·Ind(y/x; a, b).
#include "phrame/algebra/argument.hpp"

#include "phrame/algebra/error.hpp"

namespace phrame {
namespace {

/// γ·conj γ(0).
GaussianPolynomial started_on_the_positive_axis(const GaussianPolynomial& gamma) {
  const Polynomial common = gcd(gamma.re, gamma.im);
  if (common.is_zero()) throw DomainError("ContinuousArgument: the argument of 0 is undefined");
  if (count_real_roots(common, real_line()) > 0)
    throw DomainError("ContinuousArgument: the polynomial has a real zero");
  const GaussianPolynomial start{{gamma.re.coefficient(0)}, {gamma.im.coefficient(0)}};
  return gamma * conjugate(start);
}

}  // namespace

ContinuousArgument::ContinuousArgument(const GaussianPolynomial& gamma) {
  auto [x, y] = started_on_the_positive_axis(gamma);
  straight_ = {std::move(x), std::move(y), std::nullopt};
}

long ContinuousArgument::Coordinates::half_turns(const Rational& t) {
  if (!chain) chain.emplace(x, y);
  return t >= 0 ? -cauchy_index(*chain, 0, t) : cauchy_index(*chain, t, 0);
}

RealBall ContinuousArgument::difference(const Rational& t, long bits) {
  const auto angle = [&](Coordinates& c) {
    RealBall value(c.y(t) / c.x(t), bits);
    arb_atan(value.raw(), value.raw(), bits);
    arb_addmul_si(value.raw(), pi(bits).raw(), c.half_turns(t), bits);
    return value;
  };
  if (straight_.x(t) != 0) return angle(straight_);
  // On the imaginary axis: turn everything by π/4 first. Rare, so the second chain is not kept.
  auto [x, y] = GaussianPolynomial{straight_.x, straight_.y} * GaussianPolynomial{{1}, {1}};
  Coordinates turned{std::move(x), std::move(y), std::nullopt};
  RealBall quarter = pi(bits);
  arb_mul_2exp_si(quarter.raw(), quarter.raw(), -2);
  return subtract(angle(turned), quarter, bits);
}

}  // namespace phrame
