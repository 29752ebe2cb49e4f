// The rate at φ(x) = c − x or x + d is compared with that at x. Derivatives of r(φ(x)) by x are
// those of r there times φ′ = ±1 for each order. In (v·r′)·det(v, r′, r″) the orders add up to
// four, in det(r′, r″, r‴) to six, and squares have even sums, too: so φ′ is no matter.
#include "phrame/ph/along/antisymmetric_rate.hpp"

#include <array>

#include "phrame/ph/curve/trigonometric_sum.hpp"
#include "phrame/ph/curve/vector.hpp"

namespace phrame::inline v0 {
namespace {

/// The rate is N/(D√S) times a constant.
struct SumsOfRate {
  TrigonometricSum N, D, S;
};

SumsOfRate rate_of(TrigonometricArithmetic& sums, const Vector<TrigonometricSum>& r,
                   const std::optional<Vector<Rational>>& v) {
  const auto slope = [](const Vector<TrigonometricSum>& a) -> Vector<TrigonometricSum> {
    return {differentiate(a[0]), differentiate(a[1]), differentiate(a[2])};
  };
  const Vector<TrigonometricSum> r1 = slope(r);
  const Vector<TrigonometricSum> r2 = slope(r1);
  const TrigonometricSum square = sums.dot(r1, r1);
  if (!v) {
    const Vector<TrigonometricSum> bend = sums.cross(r1, r2);
    return {sums.dot(bend, slope(r2)), sums.dot(bend, bend), square};
  }
  const Vector<TrigonometricSum> up{(*v)[0], (*v)[1], (*v)[2]};
  const Vector<TrigonometricSum> across = sums.cross(up, r1);
  return {sums.multiply(sums.dot(up, r1), sums.dot(across, r2)), sums.dot(across, across), square};
}

}  // namespace

bool has_antisymmetry(const RootQuotient& rate, const Rational& t, const Antisymmetry& symmetry) {
  if (rate.numerator.is_zero()) return true;
  if (symmetry.shift) return false;
  const auto turned = [&](const Polynomial& p) { return compose(p, {t, -1}); };
  return turned(rate.numerator) == -rate.numerator &&
         turned(rate.denominator) == rate.denominator && turned(rate.radicand) == rate.radicand;
}

bool has_antisymmetry(const Vector<Formula>& r, const Formula& from, const Formula& to,
                      const std::optional<Vector<Rational>>& v, const Rational& t,
                      const Antisymmetry& symmetry, const Integer& most) {
  TrigonometricArithmetic sums(most);
  DistinctSteps of_ends;
  const std::array<std::size_t, 2> ends{of_ends.insert(from), of_ends.insert(to)};
  const auto constants = sums.values(of_ends, {});
  if (!constants) return false;
  const TrigonometricSum& start = (*constants)[ends[0]];
  const TrigonometricSum span = (*constants)[ends[1]] - start;
  DistinctSteps steps;
  const Vector<std::size_t> components{steps.insert(r[0]), steps.insert(r[1]), steps.insert(r[2])};
  const auto rate = [&](const TrigonometricSum& s) -> std::optional<SumsOfRate> {
    const auto values = sums.values(steps, s);
    if (!values) return std::nullopt;
    const auto& [i, j, k] = components;
    return rate_of(sums, {(*values)[i], (*values)[j], (*values)[k]}, v);
  };
  const TrigonometricSum x = TrigonometricSum::variable();
  const auto one = rate(start + x);
  const auto other = rate(start + (symmetry.shift ? *symmetry.shift * span + x : t * span - x));
  if (!one || !other || !sums.is_within_limit()) return false;
  return one->N.is_zero() ||
         ((one->N + other->N).is_zero() && one->D == other->D && one->S == other->S);
}

std::optional<Antisymmetry> find_antisymmetry(const Rational& t,
                                              const std::function<bool(const Antisymmetry&)>& has) {
  if (has({})) return Antisymmetry{};
  constexpr long most_periods = 12;
  for (long periods = 1; periods <= most_periods; ++periods) {
    const Antisymmetry shifted{t / Rational(2 * periods)};
    if (has(shifted)) return shifted;
  }
  return std::nullopt;
}

}  // namespace phrame
