#include "phrame/ph/twist/smooth_twist.hpp"

#include "phrame/algebra/algebraic_angle.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/ph/along/reduced_angle.hpp"
#include "phrame/ph/curve/formula_symmetry.hpp"
#include "phrame/ph/curve/real_vector.hpp"

namespace phrame {
namespace {

Place end_of_path(const Path& path) { return {path.segments().size() - 1, Rational(1)}; }

Real mean_of(const Real& x, const Real& y) { return Rational(1, 2) * (x + y); }

}  // namespace

SmoothTwist::SmoothTwist(const PathAngle& rmf, const FrameStart& from, const FrameStart& to,
                         const Integer& extra_turns)
    : rmf_(rmf),
      length_(rmf.path()),
      whole_(length_.total()),
      from_(start_angle(from, rmf).value),
      to_(start_angle(to, rmf, end_of_path(rmf.path())).value),
      nominal_(Rational(0)),
      twist_(Rational(0)) {
  if (rmf.reference() == Reference::frenet)
    throw DomainError("minimal twist: it is not found from the angle to the Frenet frame");
  nominal_ = remembered(up_twist() + (to_ + -from_));
  const ReducedAngle least = reduced(nominal_);
  half_turn_within_ = least.half_turn_within;
  twist_ = extra_turns == 0 ? least.angle : least.angle + whole_turn(extra_turns);
  turns_at_end_ = extra_turns - least.turns;
}

Real SmoothTwist::up_twist() const { return -rmf_.value(end_of_path(rmf_.path())); }

Real SmoothTwist::rate() const { return quotient_of(twist_, whole_); }

bool SmoothTwist::is_end(const Place& at) const {
  return at.segment + 1 == rmf_.path().segments().size() && at.t.exact() == Rational(1);
}

bool SmoothTwist::is_middle(const Place& at) const {
  const auto& segments = rmf_.path().segments();
  if (segments.size() > 1 || at.t.exact() != Rational(1, 2)) return false;
  const auto* curve = std::get_if<ExpressionCurve>(&segments.front());
  return curve != nullptr && is_turned_over_by_half_turn(*curve, rmf_.up());
}

Real SmoothTwist::value(const Place& at) const {
  if (at.segment == 0 && at.t.exact() == Rational(0)) return from_;
  if (is_end(at)) return turns_at_end_ == 0 ? to_ : to_ + whole_turn(turns_at_end_);
  if (is_middle(at)) {
    const Real mean = mean_of(from_, to_);
    return turns_at_end_ == 0 ? mean : mean + Rational(1, 2) * whole_turn(turns_at_end_);
  }
  return from_ + twist_ * quotient_of(length_.value(at), whole_) + rmf_.value(at);
}

// Whole turns are left out at the end, and in the middle, where there are half as many.
Frame<Real> minimal_twist_frame(const SmoothTwist& twist, const Place& at) {
  const PathAngle& rmf = twist.rmf();
  const Frame<Real> up = up_frame(rmf.path(), rmf.up(), at);
  if (twist.is_end(at)) return turned(up, twist.to());
  if (!twist.is_middle(at)) return turned(up, remembered(twist.value(at)));
  const Frame<Real> frame = turned(up, mean_of(twist.from(), twist.to()));
  if (twist.turns_at_end() % Integer(2) == 0) return frame;
  return {frame.e1, opposite(frame.e2), opposite(frame.e3)};
}

}  // namespace phrame
