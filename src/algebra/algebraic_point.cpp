#include "phrame/algebra/algebraic_point.hpp"

#include "phrame/algebra/as_written.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/algebra/modular.hpp"

// With the irreducible polynomial P of t, n(t)/d(t) = c ∈ ℚ if and only if P divides n − c·d, that
// is n ≡ c·d modulo P: the remainders of n and d are proportional. Then so they are modulo a prime:
// with integers and c = α/β, P, which is primitive, divides βn − αd in ℤ[t].

namespace phrame::inline v0 {
namespace {

/// Are n² and d²s seen not to be proportional modulo P?
bool is_square_seen_irrational(const Polynomial& n, const Polynomial& d, const Polynomial& s,
                               const Polynomial& modulus) {
  const Word prime = Primes().next();
  const auto there = [prime](const Polynomial& f) {
    return ModularPolynomial(prime, integer_numerator(f));
  };
  const ModularPolynomial q = there(primitive_part(modulus));
  if (q.degree() < 1) return false;
  const auto remainder = [&](const Polynomial& f) {
    ModularPolynomial r = there(f);
    reduce(r, q);
    return r;
  };
  const auto product = [&](const ModularPolynomial& x, const ModularPolynomial& y) {
    return multiply_modulo(x, y, q);
  };
  const ModularPolynomial divisor = remainder(d);
  const ModularPolynomial numerator = remainder(n);
  ModularPolynomial x = product(numerator, numerator);
  ModularPolynomial y = product(product(divisor, divisor), remainder(s));
  if (x.is_zero() || y.is_zero() || x.degree() != y.degree()) return !x.is_zero() && !y.is_zero();
  const Word leading = x.coefficient(x.degree());
  x *= y.coefficient(y.degree());
  y *= leading;
  x -= y;
  return !x.is_zero();
}

}  // namespace

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

Real AlgebraicPoint::over_square_root(const Polynomial& n, const Polynomial& d,
                                      const Polynomial& s) const {
  if (t_.rational() || !is_square_seen_irrational(n, d, s, t_.polynomial())) {
    const Real root = square_root(RationalFunction(n * n, d * d * s));
    return sign_at(n, t_) < 0 ? -root : root;
  }
  const auto enclosure = [point = *this, n, d, s](long bits) {
    const long more = bits + 16;
    const RealBall t = point.enclose(more);
    const RealBall divisor = multiply(evaluate(d, t, more), sqrt(evaluate(s, t, more), more), more);
    return divide(evaluate(n, t, more), divisor, more);
  };
  return {enclosure, {true, bits_of(t_)}};
}

}  // namespace phrame
