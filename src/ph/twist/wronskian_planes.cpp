#include "phrame/ph/twist/wronskian_planes.hpp"

#include <fmt/format.h>

#include "phrame/algebra/ball_polynomial.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/ph/twist/best_in_plane.hpp"

namespace phrame::inline v0 {
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
                         {function({}), function(c(0)), function(Rational(1, 2) * c(1))},
                         {}});
}

/// The cubics with Wronskian N₁, N = (τ − ζ)²N₁, times τ − ζ: planes of N of which all pairs vanish
/// at ζ. a₁ = 1 + c₂τ² + c₃τ³, b₁ = ν₀τ + β₂τ² + β₃τ³; the coefficients of τ⁰, …, τ³ give b₁ and
/// c₃ by c₂, and that of τ⁴ a quadratic equation. In normal form these are
/// a = −(τ − ζ)(a₁ + b₁/(ζν₀))/ζ and b = −ζ(τ − ζ)b₁, a₂ = c₂ + ν₁/(2ζν₀) − 1/ζ².
class CubicsTimes {
 public:
  CubicsTimes(const Polynomial& n, const Rational& zeta) : zeta_(zeta) {
    const Polynomial n1 = exact_quotient(n, pow(Polynomial{-zeta, 1}, 2));
    for (long k = 0; k <= 4; ++k) nu_.push_back(n1.coefficient(k));
    c2_ = Polynomial{1 / (zeta * zeta) - nu_[1] / (2 * zeta * nu_[0]), 1};
    c3_ = -nu_[3] / (2 * nu_[0]);
    beta2_ = nu_[1] / 2;
    beta3_ = Rational(1, 3) * (Polynomial{nu_[2]} + nu_[0] * c2_);
  }

  /// In a₂.
  Polynomial resolvent() const { return c2_ * beta3_ - Polynomial{c3_ * beta2_ + nu_[4]}; }

  WronskianPlane plane(const RealAlgebraic& a2, const Rational& origin) const {
    const std::vector<Polynomial> b1{{}, {nu_[0]}, {beta2_}, beta3_};
    const std::vector<Polynomial> a1{{1}, {}, c2_, {c3_}};
    const Rational part = 1 / (zeta_ * nu_[0]);
    WronskianPlane result{a2, {}, {}, origin + zeta_};
    for (std::size_t k = 0; k <= 4; ++k) {
      const auto a_at = [&](std::size_t j) { return a1[j] + part * b1[j]; };
      Polynomial a;
      Polynomial b;
      if (k < 4) {
        a = a_at(k);
        b = zeta_ * zeta_ * b1[k];
      }
      if (k > 0) {
        a = a - Rational(1 / zeta_) * a_at(k - 1);
        b = b - zeta_ * b1[k - 1];
      }
      result.a.push_back(function(a));
      result.b.push_back(function(b));
    }
    return result;
  }

 private:
  Rational zeta_;
  std::vector<Rational> nu_;
  Polynomial c2_;  ///< in a₂, as β₃
  Rational c3_;
  Rational beta2_;
  Polynomial beta3_;
};

/// The rational numbers where p vanishes twice.
std::vector<Rational> rational_double_zeros(const Polynomial& p) {
  std::vector<Rational> result;
  const Polynomial twice = gcd(p, differentiate(p));
  if (twice.degree() < 1) return result;
  for (const RealRoot& root : real_roots(twice, real_line()))
    if (const auto z = root.at.rational()) result.push_back(*z);
  return result;
}

/// n = 4. The coefficients of τ⁰, …, τ⁴ give b and a₄ by a₂ and a₃, that of τ⁵ is D·a₃ = E with
/// polynomials D and E in a₂, and that of τ⁶, times D², is the resolvent.
class Quartics {
 public:
  Quartics(const Polynomial& n, const Rational& origin) : origin_(origin) {
    for (long k = 0; k <= 6; ++k) n_.push_back(n.coefficient(k));
    b2_ = n_[1] / 2;
    b3_ = Polynomial{n_[2] / 3, n_[0] / 3};
    d_ = Polynomial{b2_ * b2_ / (3 * n_[0]), n_[0] / 2};
    e_ = Polynomial{n_[5] / 2, -n_[3] / 4} +
         b2_ / (3 * n_[0]) * (Polynomial::monomial(1, 1) * b3_ - Polynomial{n_[4]});
    for (const Rational& zeta : rational_double_zeros(n)) with_common_zero_.emplace_back(n, zeta);
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
          planes.real.push_back(plane_of(zero_of_d, a3.at));
      } else {
        planes.real.push_back(plane_of(root.at));
      }
    }
  }

 private:
  /// That of an a₂ with D ≠ 0, the only one.
  WronskianPlane plane_of(const RealAlgebraic& a2) const {
    for (const CubicsTimes& cubics : with_common_zero_)
      if (sign_at(cubics.resolvent(), a2) == 0) return cubics.plane(a2, origin_);
    return plane(a2, function(Polynomial::monomial(1, 1)), RationalFunction(e_, d_));
  }

  /// That of an a₂ with D = 0 and an a₃. With a common zero it is rational.
  WronskianPlane plane_of(const Rational& a2, const RealAlgebraic& a3) const {
    WronskianPlane result = plane(a3, function({a2}), function(Polynomial::monomial(1, 1)));
    for (const CubicsTimes& cubics : with_common_zero_) {
      const WronskianPlane other = cubics.plane(a2, origin_);
      if (cubics.resolvent()(a2) == 0 && a3 == RealAlgebraic(other.a[3](a2)))
        result.zero = other.zero;
    }
    return result;
  }

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
    return {
        x, {number(1), number(0), a2, a3, a4}, {number(0), number(n_[0]), number(b2_), b3, b4}, {}};
  }

  Rational origin_;
  std::vector<CubicsTimes> with_common_zero_;
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
    Quartics(there, planes.origin).add_planes(planes);
  return planes;
}

PlaneBasis enclose(const WronskianPlane& plane, const Rational& origin, long bits) {
  return {in_powers_of_t(plane.a, plane, origin, bits),
          in_powers_of_t(plane.b, plane, origin, bits)};
}

}  // namespace phrame
