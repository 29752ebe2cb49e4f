#include "phrame/ph/curve/quaternion.hpp"

#include <algorithm>
#include <ostream>
#include <utility>

namespace phrame::inline v0 {
namespace {

template <class Components>
std::ostream& write_components(std::ostream& out, const Components& components) {
  const char* before = "(";
  for (const auto& x : components) out << std::exchange(before, ", ") << x;
  return out << ')';
}

}  // namespace

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

// Mostly it is 1, which two of them say.
Polynomial real_content(const QuaternionPolynomial& a) {
  Polynomial common = gcd(a.u, a.v);
  for (const Polynomial* p : {&a.p, &a.q}) {
    if (common.degree() == 0) return common;
    common = gcd(common, *p);
  }
  return common;
}

QuaternionPolynomial without_real_content(const QuaternionPolynomial& a) {
  const Polynomial common = real_content(a);
  if (common.degree() == 0) return a;  // it is 1
  return {exact_quotient(a.u, common), exact_quotient(a.v, common), exact_quotient(a.p, common),
          exact_quotient(a.q, common)};
}

std::ostream& operator<<(std::ostream& out, const Vector<Rational>& v) {
  return write_components(out, v);
}

std::ostream& operator<<(std::ostream& out, const Vector<Polynomial>& v) {
  return write_components(out, v);
}

std::ostream& operator<<(std::ostream& out, const RationalQuaternion& a) {
  return write_components(out, std::array{a.u, a.v, a.p, a.q});
}

std::ostream& operator<<(std::ostream& out, const QuaternionPolynomial& a) {
  return write_components(out, std::array{a.u, a.v, a.p, a.q});
}

}  // namespace phrame
