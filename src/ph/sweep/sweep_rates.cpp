#include "phrame/ph/sweep/sweep_rates.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/rounding.hpp"

namespace phrame::inline v0 {
namespace {

// The surface is S(u, t) = r + a·v(u), a = λe^{iφ}, v = x f₂ + y f₃ of the constant length |v|. On
// a side of the polygon it is linear in u, so that between two sections, at the distance Δt, it is
// as near to the bilinear patch through its four corners as |S_tt|·Δt²/8 on the two edges u =
// const. With the unit tangent T and f₂′ = −(f₂·T′)T, the derivatives of v are
//   |v′| ≤ |v|·|T′|,  |v″| ≤ |v|·(|T″| + |T′|²),
// and those of T, with a vector H along r′, r′ itself or one that is not 0 at cusps, either, from
// T′ = (H′ − (T·H′)T)/|H|,
//   |T′| ≤ |H′|/|H|,  |T″| ≤ (|H″| + 3|T′||H′|)/|H|;
// φ′ = |r′|·dφ/ds and φ″ = (|r′|)′·dφ/ds + |r′|²·d²φ/ds², (|r′|)′ ≤ |r″|. All of this is bounded by
// balls around all t of a part.

constexpr long rate_bits = 64;

double length_below(const Vector<RealBall>& v) {
  RealBall sum;
  for (const RealBall& x : v) {
    const RealBall size = absolute(x);
    sum = add(sum, multiply(size, size, rate_bits), rate_bits);
  }
  return -upper_double(
      subtract(RealBall(0, rate_bits), sqrt_of_nonnegative(sum, rate_bits), rate_bits));
}

double length_above(const Vector<RealBall>& v) {
  RealBall sum;
  for (const RealBall& x : v) sum = add(sum, multiply(x, x, rate_bits), rate_bits);
  return upper_double(sqrt_of_nonnegative(sum, rate_bits));
}

}  // namespace

ScaleRates::ScaleRates(const SweepScale& scale, std::size_t segments) {
  const std::size_t count = &scale.on(0) == &scale.on(segments - 1) ? 1 : segments;
  for (std::size_t k = 0; k < count; ++k) {
    const RationalFunction slope = differentiate(scale.on(k));
    derivatives_.push_back({scale.on(k), slope, differentiate(slope)});
  }
}

double ScaleRates::bound(std::size_t order, std::size_t segment, const RealBall& t) const {
  const RealBall along = add(t, RealBall(static_cast<long>(segment), rate_bits), rate_bits);
  return upper_double(absolute(evaluate(derivative(order, segment), along, rate_bits)));
}

double ScaleRates::at(std::size_t order, std::size_t segment, double t) const {
  const Rational along = exact_rational(t) + Rational(static_cast<long>(segment));
  return approximate(evaluate(derivative(order, segment), RealBall(along, rate_bits), rate_bits));
}

std::optional<SweepRates> sweep_rates(const SweepPath& path, const ScaleRates& scale,
                                      const SweepTurn& turn, const SweepPart& part) {
  const RealBall t = hull(exact_rational(part.from), exact_rational(part.to), rate_bits);
  const auto series = path.series.position(part.segment, t, 4, rate_bits);
  const auto coefficient = [](const Vector<BallPolynomial>& of, long order) {
    return Vector<RealBall>{of[0].coefficient(order), of[1].coefficient(order),
                            of[2].coefficient(order)};
  };
  const auto along = along_motion(path.series, part.segment, t, series, 3, rate_bits);
  const double below = length_below(coefficient(along, 0));
  if (!(below > 0)) return std::nullopt;
  SweepRates rates{};
  rates.speed = length_above(coefficient(series, 1));
  rates.acceleration = 2 * length_above(coefficient(series, 2));
  const double along1 = length_above(coefficient(along, 1));
  const double along2 = 2 * length_above(coefficient(along, 2));
  rates.tangent = along1 / below * sweep_slack;
  rates.tangent2 = (along2 + 3 * rates.tangent * along1) / below * sweep_slack;
  for (std::size_t k = 0; k < 3; ++k) rates.scale[k] = scale.bound(k, part.segment, t);
  const double per_length = turn.rate_bound(part.segment);
  rates.turn = (per_length * rates.speed + turn.roll_bound(1, part.segment, t)) * sweep_slack;
  rates.turn2 = (turn.roll_bound(2, part.segment, t) + per_length * rates.acceleration +
                 turn.second_bound(part.segment) * rates.speed * rates.speed) *
                sweep_slack;
  return rates;
}

double edge_error(const SweepRates& rates, double reach, double step) {
  const auto& [scale, scale1, scale2] = rates.scale;
  const double turn = rates.turn;
  const double tangent = rates.tangent;
  const double a1 = scale1 + scale * turn;
  const double a2 = scale2 + 2 * scale1 * turn + scale * (rates.turn2 + turn * turn);
  const double second = rates.acceleration + reach * (a2 + 2 * a1 * tangent +
                                                      scale * (rates.tangent2 + tangent * tangent));
  return step * step / 8 * second * sweep_slack;
}

namespace {

/// Near a cusp parts are as short as the square of its distance.
constexpr double shortest_part = 0x1p-22;

[[noreturn]] void refuse_part(const SweepPart& part) {
  throw Undecided(fmt::format(
      "sweep: near t = {} the curve turns back in a cusp, or the tolerance is too small",
      part.start()));
}

/// Around some points of each segment no part will do if one of the shortest at the point does not:
/// that is seen before the parts elsewhere, which may be millions.
void require_parts(const SweepPath& path, const ScaleRates& scale, const SweepTurn& turn,
                   double reach, double tolerance) {
  for (std::size_t k = 0; k < path.series.segments; ++k)
    for (const double t : {0.0, 0.5, 1.0}) {
      const SweepPart at{k, t, t};
      const auto rates = sweep_rates(path, scale, turn, at);
      if (!rates || !(edge_error(*rates, reach, shortest_part / 2) <= tolerance)) refuse_part(at);
    }
}

}  // namespace

SweepParts sweep_parts(const SweepPath& path, const ScaleRates& scale, const SweepTurn& turn,
                       double reach, double tolerance) {
  require_parts(path, scale, turn, reach, tolerance);
  SweepParts found;
  std::vector<SweepPart> left;
  for (std::size_t k = path.series.segments; k-- > 0;) left.push_back({k, 0, 1});
  while (!left.empty()) {
    const SweepPart part = left.back();
    left.pop_back();
    const auto rates = sweep_rates(path, scale, turn, part);
    const double error = rates ? edge_error(*rates, reach, part.step()) : HUGE_VAL;
    if (rates && error <= tolerance) {
      found.error = std::max(found.error, error);
      found.parts.push_back(part);
      continue;
    }
    if (part.step() < shortest_part || found.parts.size() + left.size() > most_sweep_points)
      refuse_part(part);
    const double middle = (part.from + part.to) / 2;
    left.push_back({part.segment, middle, part.to});
    left.push_back({part.segment, part.from, middle});
  }
  return found;
}

}  // namespace phrame
