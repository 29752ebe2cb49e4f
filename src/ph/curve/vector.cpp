#include "phrame/ph/curve/vector.hpp"

#include <fmt/format.h>

#include "phrame/algebra/as_written.hpp"

namespace phrame::inline v0 {

Vector<Polynomial> differentiate(const Vector<Polynomial>& v) {
  return {differentiate(v[0]), differentiate(v[1]), differentiate(v[2])};
}

Vector<Polynomial> as_polynomials(const Vector<Rational>& v) {
  return {Polynomial{v[0]}, Polynomial{v[1]}, Polynomial{v[2]}};
}

Polynomial gcd(const Vector<Polynomial>& v) { return gcd(gcd(v[0], v[1]), v[2]); }

std::string abbreviated(const Vector<Rational>& v) {
  const auto text = [](const Rational& x) { return as_written(x); };
  return fmt::format("({}, {}, {})", text(v[0]), text(v[1]), text(v[2]));
}

}  // namespace phrame
