#include "phrame/integrate/integral_sum.hpp"

#include <algorithm>
#include <bit>

#include "phrame/integrate/integrate.hpp"

// A part, reparametrised, is an integral from 0 to 1, and so is the sum of all parts: that
// logarithms of different integrals cancel is decided as within one. That takes long where there
// are many, but it is asked only of a number that is next to the rational part of the sum. One that
// is apart from it differs from it by a linear form in logarithms that is not 0, so that it is
// transcendental [Baker 1975].

namespace phrame::inline v0 {
namespace {

bool is_known(const KnownIntegral& integral) { return integral.value.value.exact().has_value(); }

/// The sum of those that are known to be rational.
Rational rational_sum(const std::vector<KnownIntegral>& integrals) {
  Rational sum = 0;
  for (const KnownIntegral& integral : integrals)
    if (is_known(integral)) sum += *integral.value.value.exact();
  return sum;
}

/// The sum of the others, without the logarithms.
Rational without_logarithms(const std::vector<KnownIntegral>& integrals) {
  Rational sum = 0;
  for (const KnownIntegral& integral : integrals)
    if (!is_known(integral))
      for (const auto& [f, F, from, to, factor] : integral.parts)
        sum += factor * difference_without_logarithms(F, from, to);
  return sum;
}

/// What the logarithms are functions of, which says how near to 0 they may be.
long number_of_poles(const std::vector<KnownIntegral>& integrals) {
  long count = 0;
  for (const KnownIntegral& integral : integrals)
    for (const IntegralPart& part : integral.parts) count += part.f.denominator().degree();
  return count;
}

/// The sum of those that are not known to be rational, as one integral from 0 to 1.
DefiniteIntegral as_one(const std::vector<KnownIntegral>& integrals) {
  Antiderivative F;
  RationalFunction f;
  const auto add = [&](const Antiderivative& part) {
    F.polynomial += part.polynomial;
    F.rational = F.rational + part.rational;
    F.logs.insert(F.logs.end(), part.logs.begin(), part.logs.end());
  };
  for (const KnownIntegral& integral : integrals) {
    if (is_known(integral)) continue;
    for (const IntegralPart& part : integral.parts) {
      const bool is_over_unit_interval = part.from == 0 && part.to == 1 && part.factor == 1;
      const Rational width = part.to - part.from;
      const RationalFunction speed(Polynomial{part.factor * width});
      const RationalFunction rate =
          is_over_unit_interval ? part.f : speed * compose(part.f, Polynomial{part.from, width});
      f = f + rate;
      add(is_over_unit_interval ? part.F : integrate(rate));
    }
  }
  return definite_integral(F, f, Rational(0), Rational(1), AtPoles::refuse);
}

std::optional<ExactValue> in_finite_terms(const std::vector<KnownIntegral>& integrals) {
  std::vector<ExactValue> values;
  for (const KnownIntegral& integral : integrals) {
    if (!integral.value.exact) return std::nullopt;
    values.push_back(*integral.value.exact);
  }
  return sum_of(values);
}

Real::Enclosure enclosure(const std::vector<KnownIntegral>& integrals) {
  std::vector<Real> others;
  for (const KnownIntegral& integral : integrals)
    if (!is_known(integral)) others.push_back(integral.value.value);
  return [known = rational_sum(integrals), others](long bits) {
    const long more = bits + 8 + static_cast<long>(std::bit_width(others.size()));
    RealBall total(known, more);
    for (const Real& x : others) total = add(total, x.enclose(more), more);
    return total;
  };
}

}  // namespace

DefiniteIntegral sum_of_integrals(const std::vector<KnownIntegral>& integrals) {
  if (integrals.size() == 1) return integrals.front().value;
  const Real::Enclosure enclose = enclosure(integrals);
  long size = 0;
  for (const KnownIntegral& integral : integrals) size += integral.value.value.origin().bits;
  const auto irrational = [&](const std::optional<ExactValue>& exact) {
    return DefiniteIntegral{Real(enclose, {true, size}), exact};
  };

  if (const auto exact = in_finite_terms(integrals))
    return is_rational(*exact) ? DefiniteIntegral{exact->rational, exact} : irrational(exact);
  const auto is_unknown = [](const KnownIntegral& integral) {
    return !is_known(integral) && integral.parts.empty();
  };
  if (std::any_of(integrals.begin(), integrals.end(), is_unknown))
    return {Real(enclose, {false, size}), std::nullopt};
  const Rational known = rational_sum(integrals);
  const Rational nearby = known + without_logarithms(integrals);
  const auto is_apart = [&](long bits) { return !enclose(bits).contains(nearby); };
  constexpr long bits = 128;
  if (is_apart(bits) || is_apart(bits + 16 * number_of_poles(integrals)))
    return irrational(std::nullopt);
  DefiniteIntegral others = as_one(integrals);
  if (others.exact) others.exact = *others.exact + exact_value(known);
  if (const auto rational = others.value.exact())
    return {Rational(known + *rational), others.exact};
  return {Real(enclose, {others.value.origin().is_irrational, size}), others.exact};
}

}  // namespace phrame
