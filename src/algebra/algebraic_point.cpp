#include "phrame/algebra/algebraic_point.hpp"

#include "phrame/algebra/as_written.hpp"
#include "phrame/algebra/error.hpp"

// With the irreducible polynomial P of t, n(t)/d(t) = c ∈ ℚ if and only if P divides n − c·d, that
// is n ≡ c·d modulo P: the remainders of n and d are proportional.

namespace phrame::inline v0 {

AlgebraicPoint::AlgebraicPoint(RealAlgebraic t) : t_(std::move(t)) {}

RealBall AlgebraicPoint::enclose(long bits) const {
  return *enclosure_.get(bits, [&](const RealBall*) { return phrame::enclose(t_, bits); });
}

Real AlgebraicPoint::value(const Polynomial& p) const { return value(RationalFunction(p)); }

Real AlgebraicPoint::value(const RationalFunction& f) const {
  if (const auto exact = t_.rational()) return f(*exact);
  const Polynomial n = f.numerator() % t_.polynomial();
  const Polynomial d = f.denominator() % t_.polynomial();
  if (d.is_zero())
    throw DomainError("value at the root of " + to_string(t_.polynomial()) + " in " +
                      to_string(t_.interval()) + ": the function has a pole there");
  const Rational ratio = n.leading_coefficient() / d.leading_coefficient();
  if (n == ratio * d) return ratio;
  const auto enclosure = [point = *this, n, d](long bits) {
    const RealBall t = point.enclose(bits + 16);
    const RealBall numerator = evaluate(n, t, bits + 16);
    return d.is_constant() ? divide(numerator, RealBall(d.coefficient(0), bits + 16), bits + 16)
                           : divide(numerator, evaluate(d, t, bits + 16), bits + 16);
  };
  return {enclosure, {true, bits_of(t_)}};
}

Real AlgebraicPoint::square_root(const RationalFunction& f) const {
  const Real square = value(f);
  if (!square.exact()) {
    if (sign_at(f.numerator() * f.denominator(), t_) < 0)
      throw DomainError("square root: a negative number");
    return {[square](long bits) { return sqrt(square.enclose(bits + 8), bits + 8); },
            square.origin()};
  }
  const Rational& x = *square.exact();
  if (x < 0) throw DomainError("square root: the negative number " + as_written(x));
  return square_root_of(x);
}

}  // namespace phrame
