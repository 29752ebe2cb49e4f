#include "phrame/algebra/algebraic_image.hpp"

#include <algorithm>

#include "phrame/algebra/bivariate.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/algebra/resultant.hpp"

namespace phrame::inline v0 {

RealAlgebraic affine(const RealAlgebraic& x, const Rational& factor, const Rational& shift) {
  if (factor == 0) throw DomainError("affine: the factor 0");
  if (const auto r = x.rational()) return Rational(factor * *r + shift);
  const Interval& i = x.interval();
  Rational low = factor * *i.lower + shift;
  Rational high = factor * *i.upper + shift;
  if (factor < 0) std::swap(low, high);
  return real_root(compose(x.polynomial(), Polynomial{-shift / factor, 1 / factor}),
                   open_interval(low, high));
}

RealAlgebraic image(const Polynomial& y, const RealAlgebraic& x) {
  const QuotientRing ring(x.polynomial());
  const Polynomial value = ring.reduce(y);
  if (value.is_constant()) return value.coefficient(0);
  // The residues of value·p′/p are the conjugates of y(x).
  const Polynomial p = squarefree_part(
      residue_polynomial(ring.multiply(value, differentiate(x.polynomial())), x.polynomial()));
  for (long bits = 64;; bits *= 2) {
    const RealBall ball = evaluate(value, enclose(x, bits), bits);
    if (!ball.is_finite()) continue;
    const Interval around = closed_interval(ball.lower(), ball.upper());
    if (count_real_roots(p, around) == 1) return real_root(p, around);
  }
}

RealAlgebraic image(const RationalFunction& f, const RealAlgebraic& x) {
  const QuotientRing ring(x.polynomial());
  const Polynomial d = ring.reduce(f.denominator());
  if (d.is_zero()) throw DomainError("image: a pole");
  return image(ring.divide(f.numerator(), d), x);
}

}  // namespace phrame
