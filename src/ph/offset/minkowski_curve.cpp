// With σ the matrix
//   (x′ + r′  σ + y′)     (a)
//   (σ − y′  x′ − r′) = f·(b)·(c  d)
// has the determinant 0, so that over ℚ[t] it is a column times a row: f is the gcd of all four, c
// and d are a row without its gcd. No square is to be taken out of anything, and no field is to be
// extended.
#include "phrame/ph/offset/minkowski_curve.hpp"

#include <fmt/format.h>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/factor.hpp"
#include "phrame/algebra/surd.hpp"
#include "phrame/ph/curve/vector.hpp"

namespace phrame::inline v0 {
namespace {

NotMinkowski reason(const Polynomial& n) {
  if (n.is_zero()) return {0, {1}};
  const auto [unit, factors] = squarefree_factorization(n);
  const Integer size(numerator(unit) * denominator(unit));
  NotMinkowski found{split_square(abs(size)).rest, {1}};
  if (size < 0) found.number = -found.number;
  for (const auto& [base, exponent] : factors)
    if (exponent % 2 == 1) found.odd_factor *= base;
  return found;
}

/// The same with the sign for which it is > 0 for small t > 0.
Polynomial positive_after_zero(Polynomial p) { return sign_after_zero(p) < 0 ? -std::move(p) : p; }

}  // namespace

Vector<Polynomial> direction(const MinkowskiCurve& curve) {
  const auto& [u, v, p, q] = curve.preimage;
  return {u * u + v * v - p * p - q * q, Rational(2) * (u * p - v * q),
          Rational(2) * (u * v - p * q)};
}

Polynomial spacelike_root(const MinkowskiCurve& curve) {
  const auto& [u, v, p, q] = curve.preimage;
  return u * u - v * v + p * p - q * q;
}

Vector<Polynomial> position(const MinkowskiCurve& curve) {
  Vector<Polynomial> r = direction(curve);
  for (std::size_t k = 0; k < 3; ++k)
    r[k] = Polynomial{curve.start[k]} + antiderivative(curve.multiplier * r[k]);
  return r;
}

std::vector<Polynomial> null_factors(const MinkowskiCurve& curve) {
  const auto& [u, v, p, q] = curve.preimage;
  return {u + v + p + q, u - v - p + q, u + v - p - q, u - v + p - q};
}

std::string to_string(const NotMinkowski& reason) {
  if (reason.number == 0)
    return "x'^2 + y'^2 - r'^2 is 0: each disc touches the next ones from inside, and there is no "
           "envelope";
  std::string factor = reason.odd_factor == Polynomial{1}
                           ? std::string()
                           : fmt::format("({})", abbreviated(to_string(reason.odd_factor), 120));
  if (reason.number != 1 || factor.empty())
    factor = abbreviated(reason.number.str()) + (factor.empty() ? "" : "*") + factor;
  return fmt::format("x'^2 + y'^2 - r'^2 is no square: it is {} times a square", factor);
}

std::variant<MinkowskiCurve, NotMinkowski> identify_minkowski(const Vector<Polynomial>& hodograph,
                                                              const Vector<Rational>& start) {
  const auto& [x, y, r] = hodograph;
  if (hodograph == Vector<Polynomial>{})
    throw DomainError("identify_minkowski: the hodograph is zero, so that there is one disc only");
  const Polynomial n = x * x + y * y - r * r;
  const auto root = square_root(n);
  if (!root || root->is_zero()) return reason(n);
  const Polynomial f = positive_after_zero(gcd(gcd(hodograph), *root));
  const Polynomial sigma = positive_after_zero(*root);
  const auto over_f = [&](const Polynomial& p) { return exact_quotient(p, f); };
  const std::array row{over_f(x + r), over_f(sigma + y)};
  const std::array other{over_f(sigma - y), over_f(x - r)};
  const auto& [some_c, some_d] = row[0].is_zero() && row[1].is_zero() ? other : row;
  const Polynomial common = gcd(some_c, some_d);
  Polynomial c = exact_quotient(some_c, common);
  Polynomial d = exact_quotient(some_d, common);
  Rational unit = common_content({c, d});
  if (sign_after_zero(c.is_zero() ? d : c) < 0) unit = -unit;
  for (Polynomial* p : {&c, &d}) *p *= 1 / unit;
  const auto of_row = [&](const std::array<Polynomial, 2>& ac) {
    return c.is_zero() ? exact_quotient(ac[1], d) : exact_quotient(ac[0], c);
  };
  const Polynomial a = of_row(row);
  const Polynomial b = of_row(other);
  const Rational quarter(1, 4);
  MinkowskiCurve found{{quarter * (a + b + c + d), quarter * (a - b + c - d),
                        quarter * (a - b - c + d), quarter * (a + b - c - d)},
                       f,
                       start};
  if (f * direction(found) != hodograph || f * spacelike_root(found) != sigma)
    throw Error("identify_minkowski: the check failed, the preimage has another hodograph");
  return found;
}

}  // namespace phrame
