// With y² = D(t) and c₁² − 4c₀c₂ = D·g² the zeros are φ = (−c₁ + g·y)/(2c₂), for y to one side and
// for −y to the other one.
#include "phrame/ph/offset/gauge_kind.hpp"

#include "phrame/ph/offset/conic_offset.hpp"
#include "phrame/ph/offset/gauge_normal.hpp"

namespace phrame::inline v0 {
namespace {

std::optional<std::array<Polynomial, 3>> factor_of_both_sides(const RationalCurve& curve,
                                                              const Gauge& gauge) {
  const auto found = right_parameter(gauge, curve);
  const auto* none = std::get_if<NoGaugeParameter>(&found);
  return none == nullptr ? std::nullopt : none->both_sides;
}

/// The sign of y where that step is to the right of H: told at one m, as for no real t it changes.
int right_sign(const RationalCurve& curve, const ConicParameters& conic,
               const std::array<RationalFunction, 2>& step) {
  const auto& [t_of_m, y_of_m] = *conic.form;
  Rational m = 1;
  while (t_of_m.denominator()(m) == 0) m += 1;
  const Rational t = t_of_m(m);
  const auto& [hx, hy, hz] = curve.direction();
  const Rational across = hx(t) * step[1](m) - hy(t) * step[0](m);
  return -across.sign() * y_of_m(m).sign();
}

/// n/x
RationalFunction over(const Rational& n, const RationalFunction& x) {
  return {n * x.denominator(), x.numerator()};
}

}  // namespace

std::optional<OffsetKind> offset_kind(const RationalCurve& curve, const Gauge& gauge) {
  const auto factor = factor_of_both_sides(curve, gauge);
  if (!factor) return std::nullopt;
  const Polynomial squarefree = split_square(discriminant(*factor)).squarefree;
  return offset_kind_by(
      squarefree, curve,
      {[&](const RationalCurve& other) {
         return offset_kind(other, gauge).value_or(OffsetKind{OffsetKind::Kind::undecided, {}});
       },
       [&] { return conic_parameters(squarefree); }});
}

TwoSidedOffset two_sided_offset(const RationalCurve& traced, const Gauge& gauge,
                                const OffsetKind& kind, const Rational& d, long digits) {
  const RationalCurve& curve = traced_once(traced, kind);
  const auto& [t, y] = *kind.conic.value().form;
  const auto factor = factor_of_both_sides(curve, gauge).value();
  const auto of_m = [&, &t = t](const Polynomial& p) { return compose(RationalFunction(p), t); };
  const RationalFunction root = of_m(split_square(discriminant(factor)).square) * y;
  const RationalFunction phi = (root - of_m(factor[1])) * over(1, of_m(Rational(2) * factor[2]));
  const auto at_phi = [&](const Polynomial& p) { return compose(RationalFunction(p), phi); };
  const RationalFunction scale = over(d, at_phi(gauge.weight()));
  const std::array step{scale * at_phi(gauge.x()), scale * at_phi(gauge.y())};
  const int first = right_sign(curve, *kind.conic, step) * d.sign();
  return two_sided_by(curve, kind, step, first, digits);
}

}  // namespace phrame
