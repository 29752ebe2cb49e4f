#include "phrame/ph/curve/quaternion.hpp"

#include <algorithm>

namespace phrame {

HopfForm hopf_form(const QuaternionPolynomial& a) { return {{a.u, a.v}, {a.q, a.p}}; }

QuaternionPolynomial from_hopf_form(const HopfForm& form) {
  return {form.alpha.re, form.alpha.im, form.beta.im, form.beta.re};
}

long degree(const QuaternionPolynomial& a) {
  return std::max({a.u.degree(), a.v.degree(), a.p.degree(), a.q.degree()});
}

bool is_zero(const QuaternionPolynomial& a) { return degree(a) < 0; }

RationalQuaternion evaluate(const QuaternionPolynomial& a, const Rational& t) {
  return {a.u(t), a.v(t), a.p(t), a.q(t)};
}

Polynomial real_content(const QuaternionPolynomial& a) { return gcd(gcd(a.u, a.v), gcd(a.p, a.q)); }

QuaternionPolynomial without_real_content(const QuaternionPolynomial& a) {
  const Polynomial common = real_content(a);
  return {exact_quotient(a.u, common), exact_quotient(a.v, common), exact_quotient(a.p, common),
          exact_quotient(a.q, common)};
}

}  // namespace phrame
