#include "phrame/ph/twist/minimal_twist.hpp"

#include "phrame/algebra/algebraic_angle.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/ph/along/reduced_angle.hpp"
#include "phrame/ph/curve/formula_symmetry.hpp"
#include "phrame/ph/curve/real_vector.hpp"

namespace phrame::inline v0 {
namespace {

StartAngle turned_on(const StartAngle& angle, const Integer& turns) {
  if (turns == 0) return angle;
  if (angle.exact) return *angle.exact + FrameAngle(Rational(2 * turns), 0);
  return angle.value + whole_turn(turns);
}

/// So many whole turns are in the angle.
Integer whole_turns_in(const StartAngle& angle) {
  if (!angle.exact) return reduced(angle.value).turns;
  return numerator(Rational(angle.exact->half_turns - reduced(*angle.exact).half_turns)) / 2;
}

/// T_min of T = −θ_RMF(end) + between, `between` being θ_f − θ_i.
ReducedAngle least_turn(const PathAngle& rmf, const Real& twist, const StartAngle& between) {
  if (!between.exact || !rmf.path().has_erf()) return reduced(twist);
  return reduced(twist, [&]() -> std::optional<Rational> {
    if (const auto known = over_pi(twist)) return known;
    // −T/π without the multiples of π.
    const auto& [half_turns, radians, z] = *between.exact;
    const PathParameter end{rmf.path().segments().size() - 1, 1};
    const auto m = rmf.multiple_of_pi(end, path_to({z.re, -z.im}), -radians);
    if (!m) return std::nullopt;
    return half_turns - *m;
  });
}

}  // namespace

MinimalTwist::MinimalTwist(const PathAngle& rmf, StartAngle from, StartAngle to,
                           const Integer& extra_turns)
    : rmf_(rmf),
      length_(rmf.path()),
      whole_(length_.total()),
      from_(std::move(from)),
      to_(std::move(to)),
      own_twist_(Rational(0)),
      nominal_(Rational(0)),
      twist_(Rational(0)) {
  if (rmf.reference() == Reference::frenet)
    throw DomainError("minimal twist: it is not found from the angle to the Frenet frame");
  own_twist_ = cached(-rmf.value(end_of(path())));
  StartAngle between = to_.value + -from_.value;
  if (from_.exact && to_.exact) between = difference(*to_.exact, *from_.exact);
  const Integer given_turns = between.exact ? whole_turns_in(between) : 0;
  between = turned_on(between, -given_turns);
  const ReducedAngle least = least_turn(rmf, cached(own_twist_ + between.value), between);
  half_turn_within_ = least.half_turn_within;
  const Integer turns = given_turns + least.turns;
  nominal_ = turns == 0 ? least.angle : least.angle + whole_turn(turns);
  twist_ = extra_turns == 0 ? least.angle : least.angle + whole_turn(extra_turns);
  turns_at_start_ = whole_turns_in(from_);
  turns_at_end_ = extra_turns - turns;
}

Real MinimalTwist::rate() const { return quotient_of(twist_, whole_); }

std::optional<Integer> MinimalTwist::whole_turns_of_theta() const {
  if (!from_.exact || !to_.exact) return std::nullopt;
  const auto half_turns =
      over_pi(*turned_on(difference(*to_.exact, *from_.exact), turns_at_end_).exact);
  if (!half_turns || denominator(*half_turns) != 1 || numerator(*half_turns) % 2 != 0)
    return std::nullopt;
  return Integer(numerator(*half_turns) / 2);
}

bool MinimalTwist::is_middle(const Place& at) const {
  const auto& segments = path().segments();
  if (segments.size() > 1 || at.t.exact() != Rational(1, 2)) return false;
  const auto* curve = std::get_if<ExpressionCurve>(&segments.front());
  return curve != nullptr && is_turned_over_by_half_turn(*curve, rmf_.up());
}

Real MinimalTwist::value(const Place& at) const {
  if (const auto& t = at.t.exact())  // a PH curve by itself goes on
    locate_inside(path().segments().size(), *t + static_cast<long>(at.segment));
  return value_less(0, at);
}

Real MinimalTwist::value(const Rational& t) const {
  return value(locate_inside(path().segments().size(), t));
}

Real MinimalTwist::value_less(const Integer& turns, const Place& at) const {
  const StartAngle start = turned_on(from_, -turns);
  const StartAngle end = turned_on(to_, turns_at_end_ - turns);
  if (at.segment == 0 && at.t.exact() == Rational(0)) return start.value;
  if (at.segment + 1 == path().segments().size() && at.t.exact() == Rational(1)) return end.value;
  if (is_middle(at))
    return Rational(1, 2) * (from_.value + to_.value) +
           to_real(Angle(Rational(turns_at_end_ - 2 * turns), 0));
  return start.value + twist_ * quotient_of(length_.value(at), whole_) + rmf_.value(at);
}

MinimalTwist minimal_twist(const PathAngle& rmf, const FrameStart& from,
                           const std::optional<FrameStart>& to, const Integer& extra_turns) {
  const StartAngle start = start_angle(from, rmf);
  if (to) return {rmf, start, start_angle(*to, rmf, end_of(rmf.path())), extra_turns};
  return {rmf, start, closing_angle(start, rmf), extra_turns};
}

Frame<Real> minimal_twist_frame(const MinimalTwist& twist, const Place& at) {
  return turned(reference_frame(twist.rmf(), at), cached(twist.reduced_value(at)));
}

}  // namespace phrame
