// While arg γ rises through π/2 + kπ the quotient y/x jumps from +∞ to −∞. Hence, with x ≠ 0 at
// both ends, arg γ(b) − arg γ(a) = arctan(y/x)(b) − arctan(y/x)(a) − π·Ind(y/x; a, b).
#include "phrame/algebra/argument.hpp"

#include "phrame/algebra/error.hpp"

namespace phrame::inline v0 {
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

ContinuousArgument::ContinuousArgument(const GaussianPolynomial& gamma)
    : straight_(started_on_the_positive_axis(gamma)) {}

GaussianPolynomial ContinuousArgument::coordinates(const Rational& t) const {
  return straight_.re(t) != 0 ? straight_ : straight_ * GaussianPolynomial{{1}, {1}};
}

const SturmChain& ContinuousArgument::chain_at(const Rational& t) const {
  const Lazy<SturmChain>& chain = straight_.re(t) != 0 ? chain_ : turned_chain_;
  return chain.get([&] {
    const auto [x, y] = coordinates(t);
    return SturmChain(x, y);
  });
}

RealBall ContinuousArgument::difference(const Rational& t, long bits) const {
  const GaussianPolynomial xy = coordinates(t);
  const auto arctan = [&](const Rational& at) {
    RealBall value(xy.im(at) / xy.re(at), bits);
    arb_atan(value.raw(), value.raw(), bits);
    return value;
  };
  RealBall value = subtract(arctan(t), arctan(0), bits);
  arb_submul_si(value.raw(), pi(bits).raw(), cauchy_index(chain_at(t), 0, t), bits);
  return value;
}

TurnCount ContinuousArgument::turn(const Rational& t) const {
  const auto text = [&](const Rational& at) {
    std::string list;
    for (const int sign : chain_at(t).signs(at)) list += sign > 0 ? '+' : sign < 0 ? '-' : '0';
    return list;
  };
  return {cauchy_index(chain_at(t), 0, t), text(0), text(t)};
}

}  // namespace phrame
