#include "phrame/ph/curve/real_vector.hpp"

#include <bit>

namespace phrame::inline v0 {

Vector<Real> as_reals(const Vector<Rational>& v) { return {v[0], v[1], v[2]}; }

std::optional<Vector<Rational>> exactly(const Vector<Real>& v) {
  if (!v[0].exact() || !v[1].exact() || !v[2].exact()) return std::nullopt;
  return Vector<Rational>{*v[0].exact(), *v[1].exact(), *v[2].exact()};
}

Vector<Rational> near(const Vector<Real>& v) {
  constexpr long bits = 256;
  const auto number = [](const Real& x) {
    return x.exact() ? *x.exact() : x.enclose(bits).midpoint();
  };
  return {number(v[0]), number(v[1]), number(v[2])};
}

Vector<Real> cross(const Vector<Real>& u, const Vector<Real>& v) {
  const auto minor = [](const Real& a, const Real& d, const Real& b, const Real& c) {
    return a * d + -(b * c);
  };
  return {minor(u[1], v[2], u[2], v[1]), minor(u[2], v[0], u[0], v[2]),
          minor(u[0], v[1], u[1], v[0])};
}

Vector<Real> opposite(const Vector<Real>& v) { return {-v[0], -v[1], -v[2]}; }

Real quotient_of(const Real& a, const Real& b) {
  if (b.exact()) return a * Rational(1 / *b.exact());
  return Real(
      [a, b](long bits) { return divide(a.enclose(bits + 8), b.enclose(bits + 8), bits + 8); });
}

Real over_square_root(const Real& x, const Real& s) {
  if (x.exact() == Rational(0)) return Rational(0);
  const bool is_exact = x.exact() && s.exact();
  if (is_exact)
    if (const auto root = square_root(*s.exact())) return Rational(*x.exact() / *root);
  const auto enclosure = [x, s](long bits) {
    return divide(x.enclose(bits + 8), sqrt(s.enclose(bits + 8), bits + 8), bits + 8);
  };
  return {enclosure, {is_exact, x.origin().bits + s.origin().bits}};
}

Real sum_of(std::vector<Real> terms) {
  Rational exact;
  for (const Real& x : terms)
    if (x.exact()) exact += *x.exact();
  std::erase_if(terms, [](const Real& x) { return x.exact().has_value(); });
  if (terms.empty()) return exact;
  const auto guard = static_cast<long>(std::bit_width(terms.size()));
  return cached(Real([exact, terms = std::move(terms), guard](long bits) {
    const long more = bits + 8;
    RealBall sum(exact, more + guard);
    for (const Real& x : terms) sum = add(sum, x.enclose(more), more + guard);
    return sum;
  }));
}

int sign_of(const Real& x) {
  if (x.exact()) return x.exact()->sign();
  for (long bits = 64; bits <= 2048; bits *= 2)
    if (const int found = sign(x.enclose(bits)); found != 0) return found;
  return 0;
}

Real argument_of(const Real& x, const Real& y,
                 std::function<std::optional<AlgebraicAngle>()> known) {
  const bool is_on_axis = y.exact() == Rational(0);
  const bool is_near_pi = is_on_axis ? sign_of(x) < 0 : sign_of(y) == 0 && sign_of(x) < 0;
  if (is_on_axis && !is_near_pi) return Rational(0);
  if (!known && is_on_axis) known = [] { return AlgebraicAngle(1); };
  if (!known && x.exact() == Rational(0))
    known = [half = Rational(sign_of(y), 2)] { return AlgebraicAngle(half); };
  const auto enclosure = [x, y, is_near_pi](long bits) {
    const ComplexBall z(x.enclose(bits + 8), y.enclose(bits + 8));
    return is_near_pi ? argument_about_pi(z, bits + 8) : argument(z, bits + 8);
  };
  if (!known) return Real(enclosure);
  return real_angle(enclosure, {0, std::move(known)}, x.origin().bits + y.origin().bits);
}

bool is_zero(const Vector<Real>& v) {
  return v[0].exact() == Rational(0) && v[1].exact() == Rational(0) && v[2].exact() == Rational(0);
}

}  // namespace phrame
