#include "phrame/ph/curve/hodograph_fraction.hpp"

#include "phrame/ph/curve/vector.hpp"

namespace phrame::inline v0 {
namespace {

/// N/W².
HodographFraction in_lowest_terms(Vector<Polynomial> numerator, const Polynomial& weight) {
  HodographFraction r{std::move(numerator), Polynomial{1}};
  if (weight == Polynomial{1}) return r;
  const Polynomial square = weight * weight;
  const Polynomial common = gcd(gcd(r.numerator), square);
  r.denominator = exact_quotient(square, common);
  const Rational scale = 1 / r.denominator(0);
  r.denominator *= scale;
  for (Polynomial& x : r.numerator) x = scale * exact_quotient(x, common);
  return r;
}

}  // namespace

HodographFraction hodograph_fraction(const Curve& curve) {
  return in_lowest_terms(hodograph_numerator(curve), curve.weight());
}

HodographFraction hodograph_fraction(const Vector<Polynomial>& position, const Polynomial& weight) {
  Vector<Polynomial> numerator = differentiate(position);
  const Polynomial slope = differentiate(weight);
  for (std::size_t k = 0; k < 3; ++k) numerator[k] = numerator[k] * weight - position[k] * slope;
  return in_lowest_terms(std::move(numerator), weight);
}

}  // namespace phrame
