// r′(t) × U′(φ) has no factor in t or φ alone, as neither H has a zero. The φ on both sides, U and
// −U, are rational functions of each other, so that both are rational or none is. A rational
// U(φ(t)) has a rational φ(t), as φ is a rational function of the point.
//
// For every real t there are two real φ, which are simple zeros: so the discriminant of a factor of
// degree 2 has no real zero, and is > 0 where that has these φ.
#include "phrame/ph/offset/gauge_normal.hpp"

#include <algorithm>

#include "phrame/algebra/bivariate_factor.hpp"

namespace phrame::inline v0 {
namespace {

/// c(p, q) of the form of the degree n with these coefficients.
Polynomial form_at(const Polynomial& c, long n, const GaugeParameter& at) {
  Polynomial value;
  Polynomial power{1};
  for (long k = n; k >= 0; --k) {
    value *= at.p;
    value += c.coefficient(k) * power;
    power *= at.q;
  }
  return value;
}

/// An element of P¹(ℚ[t]) in lowest terms.
GaugeParameter reduced(const Polynomial& p, const Polynomial& q) {
  const Polynomial common = gcd(p, q);
  const Rational content = common_content({p, q}) / common_content({common});
  return {(1 / content) * exact_quotient(p, common), (1 / content) * exact_quotient(q, common)};
}

}  // namespace

Polynomial discriminant(const std::array<Polynomial, 3>& c) {
  return c[1] * c[1] - Rational(4) * c[0] * c[2];
}

GaugeVector vector_at(const Gauge& gauge, const GaugeParameter& at) {
  const long n = gauge.degree();
  return {form_at(gauge.x(), n, at), form_at(gauge.y(), n, at), form_at(gauge.weight(), n, at)};
}

std::variant<GaugeParameter, NoGaugeParameter> right_parameter(const Gauge& gauge,
                                                               const RationalCurve& curve) {
  const auto& [hx, hy, hz] = curve.direction();
  const auto& [ux, uy] = gauge.direction();
  const long e = std::max(ux.degree(), uy.degree());
  std::vector<Polynomial> rows;
  for (long k = 0; k <= e; ++k) rows.push_back(uy.coefficient(k) * hx - ux.coefficient(k) * hy);
  const Bivariate across(std::move(rows));
  std::vector<GaugeParameter> found;
  NoGaugeParameter none;
  const auto add = [&](GaugeParameter at) {
    found.push_back(std::move(at));
    none.degrees.push_back(1);
  };
  if (across.degree() < e) add({{1}, {}});  // of a straight line
  for (const auto& [base, exponent] : factor(across)) {
    if (base.degree() == 1) {
      add(reduced(-base.coefficient(0), base.coefficient(1)));
      continue;
    }
    none.degrees.insert(none.degrees.end(), static_cast<std::size_t>(exponent), base.degree());
    const std::array c{base.coefficient(0), base.coefficient(1), base.coefficient(2)};
    if (base.degree() == 2 && discriminant(c)(0) > 0) none.both_sides = c;
  }
  for (GaugeParameter& at : found) {
    const GaugeVector u = vector_at(gauge, {{at.p(0)}, {at.q(0)}});
    const Rational across_e1 = hx(0) * u.y(0) - hy(0) * u.x(0);
    if (across_e1 * u.weight(0) < 0) return std::move(at);
  }
  return none;
}

}  // namespace phrame
