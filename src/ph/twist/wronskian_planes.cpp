#include "phrame/ph/twist/wronskian_planes.hpp"

#include <fmt/format.h>

#include "phrame/algebra/error.hpp"

namespace phrame {
namespace {

/// The first of 0, 1, −1, 2, … that is no root of p ≠ 0.
Rational first_regular(const Polynomial& p) {
  for (long k = 0;; ++k) {
    const Rational s = k % 2 == 0 ? Rational(-k / 2) : Rational((k + 1) / 2);
    if (p(s) != 0) return s;
  }
}

RationalFunction function(const Polynomial& p) { return RationalFunction(p); }

/// n = 2: the coefficient of τ² is −a₂n₀.
void add_plane_of_quadratics(WronskianPlanes& planes, const Polynomial& n) {
  const auto c = [&n](long k) { return Polynomial{n.coefficient(k)}; };
  planes.resolvent = primitive_part(Polynomial{n.coefficient(2), n.coefficient(0)});
  const Rational a2 = -n.coefficient(2) / n.coefficient(0);
  planes.real.push_back({a2,
                         {function({1}), function({}), function({0, 1})},
                         {function({}), function(c(0)), function(Rational(1, 2) * c(1))}});
}

/// n = 4. The coefficients of τ⁰, …, τ⁴ give b and a₄ by a₂ and a₃, that of τ⁵ is D·a₃ = E with
/// polynomials D and E in a₂, and that of τ⁶, times D², is the resolvent.
class Quartics {
 public:
  explicit Quartics(const Polynomial& n) {
    for (long k = 0; k <= 6; ++k) n_.push_back(n.coefficient(k));
    b2_ = n_[1] / 2;
    b3_ = Polynomial{n_[2] / 3, n_[0] / 3};
    d_ = Polynomial{b2_ * b2_ / (3 * n_[0]), n_[0] / 2};
    e_ = Polynomial{n_[5] / 2, -n_[3] / 4} +
         b2_ / (3 * n_[0]) * (Polynomial::monomial(1, 1) * b3_ - Polynomial{n_[4]});
  }

  Polynomial resolvent() const {
    const Polynomial a4d =
        Rational(1 / (3 * n_[0])) * (Polynomial::monomial(1, 1) * b3_ * d_ - b2_ * e_ - n_[4] * d_);
    const Polynomial b4d = Rational(1, 4) * (n_[3] * d_ + 2 * n_[0] * e_);
    return e_ * b4d - a4d * b3_ * d_ - n_[6] * d_ * d_;
  }

  void add_planes(WronskianPlanes& planes) const {
    planes.resolvent = primitive_part(resolvent());
    // Where D = 0 ≠ E there is no plane, and no root either. Where D = E = 0 there are two.
    const Rational zero_of_d = -d_.coefficient(0) / d_.coefficient(1);
    for (const RealRoot& root : real_roots(planes.resolvent, real_line())) {
      if (root.at == RealAlgebraic(zero_of_d)) {
        for (const RealRoot& a3 : real_roots(last_equation(zero_of_d), real_line()))
          planes.real.push_back(
              plane(a3.at, function({zero_of_d}), function(Polynomial::monomial(1, 1))));
      } else {
        planes.real.push_back(
            plane(root.at, function(Polynomial::monomial(1, 1)), RationalFunction(e_, d_)));
      }
    }
  }

 private:
  /// The coefficient of τ⁶ less n₆, in a₃, for the a₂ that leaves it free.
  Polynomial last_equation(const Rational& a2) const {
    const Polynomial a3 = Polynomial::monomial(1, 1);
    const Rational b3 = b3_(a2);
    const Polynomial b4 = Polynomial{n_[3] / 4} + n_[0] / 2 * a3;
    const Polynomial a4 = Rational(1 / (3 * n_[0])) * (Polynomial{a2 * b3 - n_[4]} - b2_ * a3);
    return a3 * b4 - b3 * a4 - Polynomial{n_[6]};
  }

  WronskianPlane plane(const RealAlgebraic& x, const RationalFunction& a2,
                       const RationalFunction& a3) const {
    const auto number = [](const Rational& c) { return function({c}); };
    const RationalFunction b3 = compose(function(b3_), a2);
    const RationalFunction b4 = number(n_[3] / 4) + number(n_[0] / 2) * a3;
    const RationalFunction a4 =
        number(1 / (3 * n_[0])) * (a2 * b3 - number(b2_) * a3 - number(n_[4]));
    return {x, {number(1), number(0), a2, a3, a4}, {number(0), number(n_[0]), number(b2_), b3, b4}};
  }

  std::vector<Rational> n_;
  Rational b2_;
  Polynomial b3_;  ///< in a₂, as the two below
  Polynomial d_;
  Polynomial e_;
};

BallPolynomial in_powers_of_t(const std::vector<RationalFunction>& coefficients,
                              const WronskianPlane& plane, const Rational& origin, long bits) {
  const RealBall x = enclose(plane.parameter, bits);
  std::vector<RealBall> values;
  for (const RationalFunction& c : coefficients) values.push_back(evaluate(c, x, bits));
  const BallPolynomial p(values);
  return origin == 0 ? p : shifted(p, RealBall(-origin, bits), bits);
}

}  // namespace

WronskianPlanes wronskian_planes(const Polynomial& wronskian, long n) {
  if (n != 2 && n != 4)
    throw DomainError(fmt::format("wronskian_planes: the degree is {}, not 2 or 4", n));
  if (wronskian.is_zero()) throw DomainError("wronskian_planes: no two polynomials have it 0");
  if (wronskian.degree() > 2 * n - 2)
    throw DomainError(fmt::format("wronskian_planes: its degree is {}, at most {} is possible",
                                  wronskian.degree(), 2 * n - 2));
  WronskianPlanes planes{n, first_regular(wronskian), {}, {}};
  const Polynomial there = compose(wronskian, Polynomial{planes.origin, 1});
  if (n == 2)
    add_plane_of_quadratics(planes, there);
  else
    Quartics(there).add_planes(planes);
  return planes;
}

PlaneBasis enclose(const WronskianPlane& plane, const Rational& origin, long bits) {
  return {in_powers_of_t(plane.a, plane, origin, bits),
          in_powers_of_t(plane.b, plane, origin, bits)};
}

}  // namespace phrame
