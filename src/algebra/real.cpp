#include "phrame/algebra/real.hpp"

#include <ostream>

#include "phrame/algebra/shared.hpp"

namespace phrame {
namespace {

/// Of x + y and x·y, of which one at most is exact, and that one not 0 in a product.
Real::Origin of_both(const Real& x, const Real& y) {
  const Real::Origin a = x.origin();
  const Real::Origin b = y.origin();
  return {(x.exact() && b.is_irrational) || (y.exact() && a.is_irrational), a.bits + b.bits};
}

}  // namespace

long bits_of(const Rational& x) {
  return static_cast<long>(fmpz_bits(fmpq_numref(x.raw())) + fmpz_bits(fmpq_denref(x.raw())));
}

Real operator-(const Real& x) {
  if (x.exact()) return Rational(-*x.exact());
  return {[x](long bits) { return subtract(RealBall(), x.enclose(bits), bits); }, x.origin()};
}

Real operator+(const Real& x, const Real& y) {
  if (x.exact() && y.exact()) return Rational(*x.exact() + *y.exact());
  if (x.exact() == Rational(0)) return y;
  if (y.exact() == Rational(0)) return x;
  return {[x, y](long bits) { return add(x.enclose(bits + 8), y.enclose(bits + 8), bits + 8); },
          of_both(x, y)};
}

Real operator*(const Real& x, const Real& y) {
  if (x.exact() && y.exact()) return Rational(*x.exact() * *y.exact());
  if (x.exact() == Rational(0) || y.exact() == Rational(0)) return Rational(0);
  if (x.exact() == Rational(1)) return y;
  if (y.exact() == Rational(1)) return x;
  return {
      [x, y](long bits) { return multiply(x.enclose(bits + 8), y.enclose(bits + 8), bits + 8); },
      of_both(x, y)};
}

Real remembered(const Real& x) {
  if (x.exact()) return x;
  return {[x, known = Refined<RealBall>()](long bits) {
            return *known.get(bits, [&](const RealBall*) { return x.enclose(bits); });
          },
          x.origin()};
}

Real square_root_of(const Rational& x) {
  if (const auto root = square_root(x)) return *root;
  return {[x](long bits) { return sqrt(RealBall(x, bits + 8), bits + 8); }, {true, bits_of(x)}};
}

std::ostream& operator<<(std::ostream& out, const Real& x) {
  return x.exact() ? out << *x.exact() : out << x.enclose(64);
}

}  // namespace phrame
