#include "phrame/ph/curve/hodograph_fraction.hpp"

#include "phrame/ph/curve/vector.hpp"

namespace phrame::inline v0 {

HodographFraction hodograph_fraction(const Curve& curve) {
  HodographFraction r{hodograph_numerator(curve), Polynomial{1}};
  if (curve.is_polynomial()) return r;
  const Polynomial square = curve.weight() * curve.weight();
  const Polynomial common = gcd(gcd(r.numerator), square);
  r.denominator = exact_quotient(square, common);
  const Rational scale = 1 / r.denominator(0);
  r.denominator *= scale;
  for (Polynomial& x : r.numerator) x = scale * exact_quotient(x, common);
  return r;
}

}  // namespace phrame
