#include "phrame/integrate/quadrature.hpp"

namespace phrame::inline v0 {
namespace {

/// Is d = p(z) so inexact because more precision is needed, and not because z is a large ball?
bool lacks_precision(const IntegrandPolynomial& p, const ComplexBall& z, const ComplexBall& d,
                     long bits, long precision) {
  if (is_point(z, precision)) return d.accuracy_bits() < bits;
  constexpr long few = 16;
  if (d.accuracy_bits() >= few) return false;
  return p(z.midpoint(), precision).accuracy_bits() < few;
}

}  // namespace

// Next to a pole the denominator is small, so that it loses its digits, and the points those of
// their distance to the pole. Once that is seen, the values that are still asked for are infinite,
// which costs little, and all begins anew.
RealBall quadrature(const RationalFunction& f, const Rational& a, const Rational& b, long bits,
                    long most_points) {
  constexpr long most_precision = 1 << 14;
  for (long more = 64;; more *= 4) {
    const long precision = bits + more;
    const IntegrandPolynomial numerator(BallPolynomial(f.numerator(), precision));
    const IntegrandPolynomial denominator(BallPolynomial(f.denominator(), precision));
    bool is_imprecise = false;
    const auto quotient = [&](const ComplexBall& z, long working) {
      if (is_imprecise) return ComplexBall::unknown();
      --most_points;
      const ComplexBall d = denominator(z, working);
      is_imprecise = lacks_precision(denominator, z, d, bits, working);
      return is_imprecise ? ComplexBall::unknown() : divide(numerator(z, working), d, working);
    };
    RealBall value = numerical_integral(quotient, RealBall(a, precision), RealBall(b, precision),
                                        {bits, precision, most_points});
    if (!is_imprecise || most_points <= 0 || more >= most_precision) return value;
  }
}

RealBall quadrature(const AnalyticFunction& f, long bits, long more, long most_points) {
  const long precision = bits + 64 + more;
  return numerical_integral(f, RealBall(0, precision), RealBall(1, precision),
                            {bits, precision, most_points});
}

}  // namespace phrame
