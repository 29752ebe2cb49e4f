#include "phrame/algebra/real.hpp"

#include <memory>

namespace phrame {

Real operator-(const Real& x) {
  if (x.exact()) return Rational(-*x.exact());
  return Real([x](long bits) { return subtract(RealBall(), x.enclose(bits), bits); });
}

Real operator+(const Real& x, const Real& y) {
  if (x.exact() && y.exact()) return Rational(*x.exact() + *y.exact());
  if (x.exact() == Rational(0)) return y;
  if (y.exact() == Rational(0)) return x;
  return Real(
      [x, y](long bits) { return add(x.enclose(bits + 8), y.enclose(bits + 8), bits + 8); });
}

Real operator*(const Real& x, const Real& y) {
  if (x.exact() && y.exact()) return Rational(*x.exact() * *y.exact());
  if (x.exact() == Rational(0) || y.exact() == Rational(0)) return Rational(0);
  if (x.exact() == Rational(1)) return y;
  if (y.exact() == Rational(1)) return x;
  return Real(
      [x, y](long bits) { return multiply(x.enclose(bits + 8), y.enclose(bits + 8), bits + 8); });
}

Real remembered(const Real& x) {
  if (x.exact()) return x;
  struct Known {
    long bits = 0;
    RealBall ball;
  };
  return Real([x, known = std::make_shared<Known>()](long bits) {
    if (known->bits < bits) *known = {bits, x.enclose(bits)};
    return known->ball;
  });
}

Real square_root_of(const Rational& x) {
  if (const auto root = square_root(x)) return *root;
  return Real([x](long bits) { return sqrt(RealBall(x, bits + 8), bits + 8); });
}

}  // namespace phrame
