#include "phrame/integrate/absolute_integral.hpp"

#include "phrame/algebra/ball_order.hpp"

// With the changes c₁ < … < cₙ before t and the sign s at the start, ∫₀ᵗ |f| is
//   s·(F(c₁) − (F(c₂) − F(c₁)) + … ± (F(t) − F(cₙ))) = s·(2F(c₁) − 2F(c₂) + … + (−1)ⁿ·F(t)).

namespace phrame::inline v0 {

AbsoluteIntegral::AbsoluteIntegral(const RootQuotient& f) : integral_(f) {
  const Polynomial& N = integral_.integrand().numerator;
  if (N.is_zero()) return;
  first_sign_ = sign_after_zero(N);
  for (const RealRoot& root : real_roots(N, open_interval(0, 1))) {
    if (root.order % 2 == 0) continue;
    changes_.push_back(root.at);
    change_at_.push_back(cached(to_real(root.at)));
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
  if (changes_.empty()) return up_to(t, 0, bits);
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

std::optional<Surd> AbsoluteIntegral::algebraic_value(const Rational& t) const {
  if (integral_.integrand().numerator.is_zero()) return Surd();
  const auto& F = algebraic_.get([&] { return algebraic_integral(integral_.integrand()); });
  if (!F) return std::nullopt;
  Surd sum = -(*F)(0);
  Rational sign = 1;
  for (const RealAlgebraic& change : changes_) {
    if (!(change < RealAlgebraic(t))) break;
    if (!change.is_rational()) return std::nullopt;
    sum = sum + Rational(2 * sign) * (*F)(*change.rational());
    sign = -sign;
  }
  return Rational(first_sign_) * (sum + sign * (*F)(t));
}

Real AbsoluteIntegral::value(const Real& t) const {
  if (integral_.integrand().numerator.is_zero()) return Rational(0);
  if (t.exact() && (*t.exact() < 0 || *t.exact() > 1)) return integral_.value(*t.exact());
  // With a denominator, as energies have it, the linear system is great.
  const bool is_asked = t.exact() && integral_.integrand().denominator.is_constant();
  const auto known = is_asked ? algebraic_value(*t.exact()) : std::nullopt;
  if (known && known->is_rational()) return known->rational_part();
  return Real([*this, t](long bits) { return enclose(t, bits); },
              {known.has_value(), t.origin().bits});
}

}  // namespace phrame
