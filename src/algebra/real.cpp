#include "phrame/algebra/real.hpp"

#include <algorithm>
#include <ostream>

#include "phrame/algebra/algebraic_angle.hpp"
#include "phrame/algebra/shared.hpp"

namespace phrame::inline v0 {
namespace {

/// Of x + y and x·y, of which one at most is exact, and that one not 0 in a product.
Real::Origin of_both(const Real& x, const Real& y) {
  const Real::Origin a = x.origin();
  const Real::Origin b = y.origin();
  constexpr long enough = 1L << 20;  // a number may be made from itself, many times
  return {(x.exact() && b.is_irrational) || (y.exact() && a.is_irrational),
          std::min(a.bits + b.bits, std::max({a.bits, b.bits, enough}))};
}

/// What is known of it as an angle; null where that is nothing.
std::shared_ptr<const AngleForm> angle_form(const Real& x) {
  if (!x.exact()) return x.origin().angle;
  return std::make_shared<const AngleForm>(AngleForm{*x.exact(), [] { return AlgebraicAngle(); }});
}

AngleForm sum_of(const std::shared_ptr<const AngleForm>& a,
                 const std::shared_ptr<const AngleForm>& b) {
  return {a->radians + b->radians, [a, b]() -> std::optional<AlgebraicAngle> {
            const auto x = a->rest();
            const auto y = x ? b->rest() : std::nullopt;
            return y ? std::optional(*x + *y) : std::nullopt;
          }};
}

std::shared_ptr<const AngleForm> opposite(const std::shared_ptr<const AngleForm>& a) {
  if (!a) return nullptr;
  return std::make_shared<const AngleForm>(
      AngleForm{-a->radians, [a]() -> std::optional<AlgebraicAngle> {
                  const auto x = a->rest();
                  return x ? std::optional(-*x) : std::nullopt;
                }});
}

}  // namespace

long bits_of(const Rational& x) {
  return static_cast<long>(fmpz_bits(fmpq_numref(x.raw())) + fmpz_bits(fmpq_denref(x.raw())));
}

Real operator-(const Real& x) {
  if (x.exact()) return Rational(-*x.exact());
  Real::Origin origin = x.origin();
  origin.angle = opposite(origin.angle);
  return {[x](long bits) { return subtract(RealBall(), x.enclose(bits), bits); },
          std::move(origin)};
}

Real operator+(const Real& x, const Real& y) {
  if (x.exact() && y.exact()) return Rational(*x.exact() + *y.exact());
  if (x.exact() == Rational(0)) return y;
  if (y.exact() == Rational(0)) return x;
  Real::Enclosure enclosure = [x, y](long bits) {
    return add(x.enclose(bits + 8), y.enclose(bits + 8), bits + 8);
  };
  const auto a = angle_form(x);
  const auto b = a ? angle_form(y) : nullptr;
  const Real::Origin origin = of_both(x, y);
  if (a && b) return real_angle(std::move(enclosure), sum_of(a, b), origin.bits);
  return {std::move(enclosure), origin};
}

Real operator*(const Real& x, const Real& y) {
  if (x.exact() && y.exact()) return Rational(*x.exact() * *y.exact());
  if (x.exact() == Rational(0) || y.exact() == Rational(0)) return Rational(0);
  if (x.exact() == Rational(1)) return y;
  if (y.exact() == Rational(1)) return x;
  if (x.exact() == Rational(-1)) return -y;
  if (y.exact() == Rational(-1)) return -x;
  return {
      [x, y](long bits) { return multiply(x.enclose(bits + 8), y.enclose(bits + 8), bits + 8); },
      of_both(x, y)};
}

Real cached(const Real& x) {
  if (x.exact()) return x;
  return {[x, known = Refined<RealBall>()](long bits) {
            return *known.get(bits, [&](const RealBall*) { return x.enclose(bits); });
          },
          x.origin()};
}

Real known_irrational(const Real& x) {
  return {[x](long bits) { return x.enclose(bits); }, {true, x.origin().bits}};
}

Real square_root_of(const Rational& x) {
  if (const auto root = square_root(x)) return *root;
  return {[x](long bits) { return sqrt(RealBall(x, bits + 8), bits + 8); }, {true, bits_of(x)}};
}

Real square_root_of(const Real& x) {
  if (x.exact()) return square_root_of(*x.exact());
  return {[x](long bits) { return sqrt_of_nonnegative(x.enclose(bits + 8), bits + 8); },
          {x.origin().is_irrational, x.origin().bits}};
}

std::ostream& operator<<(std::ostream& out, const Real& x) {
  return x.exact() ? out << *x.exact() : out << x.enclose(64);
}

}  // namespace phrame
