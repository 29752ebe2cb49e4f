#include "phrame/integrate/absolute_integral.hpp"

#include "phrame/algebra/ball_order.hpp"

// With the changes c₁ < … < cₙ before t and the sign s at the start, ∫₀ᵗ |f| is
//   s·(F(c₁) − (F(c₂) − F(c₁)) + … ± (F(t) − F(cₙ))) = s·(2F(c₁) − 2F(c₂) + … + (−1)ⁿ·F(t)).

namespace phrame {

AbsoluteIntegral::AbsoluteIntegral(const RootQuotient& f) : integral_(f) {
  const Polynomial& N = integral_.integrand().numerator;
  if (N.is_zero()) return;
  first_sign_ = sign_after_zero(N);
  for (const RealRoot& root : real_roots(N, open(0, 1))) {
    if (root.order % 2 == 0) continue;
    changes_.push_back(root.at);
    change_at_.push_back(remembered(to_real(root.at)));
  }
}

RealBall AbsoluteIntegral::up_to(const Real& t, std::size_t changes_before, long bits) const {
  const auto at = [&](const Real& x) {
    return x.exact() ? integral_.enclose(*x.exact(), bits)
                     : integral_.enclose(x.enclose(bits + 16), bits);
  };
  RealBall sum;
  for (std::size_t k = 0; k < changes_before; ++k) {
    const RealBall part = times_power_of_two(at(change_at_[k]), 1);
    sum = k % 2 == 0 ? add(sum, part, bits) : subtract(sum, part, bits);
  }
  const RealBall last = at(t);
  sum = changes_before % 2 == 0 ? add(sum, last, bits) : subtract(sum, last, bits);
  return first_sign_ < 0 ? subtract({}, sum, bits) : sum;
}

// Where t is not told from a change, both sums hold the value: they differ by what lies between.
RealBall AbsoluteIntegral::enclose(const Real& t, long bits) const {
  const long more = bits + 16;
  std::size_t before = 0;
  bool is_certain = true;
  for (std::size_t k = 0; k < changes_.size(); ++k) {
    if (t.exact()) {
      if (changes_[k] < RealAlgebraic(*t.exact())) ++before;
      continue;
    }
    const RealBall change = change_at_[k].enclose(more);
    if (is_less(change, t.enclose(more)))
      ++before;
    else
      is_certain = is_certain && is_less(t.enclose(more), change);
  }
  const RealBall value = up_to(t, before, more);
  return is_certain ? value : hull(value, up_to(t, before + 1, more), more);
}

Real AbsoluteIntegral::value(const Real& t) const {
  if (t.exact()) {
    const Real last = integral_.value(*t.exact());
    if (integral_.integrand().numerator.is_zero()) return Rational(0);
    Real sum = Rational(0);
    bool is_exact = last.exact().has_value();
    long k = 0;
    for (const RealAlgebraic& change : changes_) {
      if (!(change < RealAlgebraic(*t.exact()))) break;
      is_exact = is_exact && change.is_rational();
      if (is_exact) sum = sum + Rational(k % 2 == 0 ? 2 : -2) * integral_.value(*change.rational());
      ++k;
    }
    if (is_exact) return Rational(first_sign_) * (sum + Rational(k % 2 == 0 ? 1 : -1) * last);
  }
  return Real([*this, t](long bits) { return enclose(t, bits); }, {false, t.origin().bits});
}

}  // namespace phrame
