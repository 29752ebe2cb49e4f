#include "phrame/ph/minimal_twist.hpp"

#include "phrame/ph/arc_length.hpp"
#include "phrame/ph/reduced_angle.hpp"

namespace phrame {

MinimalTwist::MinimalTwist(SplineAngle& rmf, const FrameAngle& from, const FrameAngle& to,
                           const Integer& extra_turns)
    : rmf_(&rmf),
      from_(from),
      to_(to),
      length_(0),
      erf_twist_(-rmf.value(rmf.spline().end())),
      nominal_(erf_twist_ + to_real(to) + -to_real(from)),
      twist_(Rational(0)) {
  for (const Curve& curve : rmf.spline().segments()) {
    const ArcLength s(curve);
    arc_lengths_.push_back(s.polynomial());
    starts_.push_back(length_);
    length_ += s.total();
  }
  const auto over_pi = [&]() -> std::optional<Rational> {
    // −T/π without the multiples of π.
    const GaussianPolynomial phase = path_to(from.direction) * conjugate(path_to(to.direction));
    const auto rest = rmf.multiple_of_pi(locate(rmf.spline(), rmf.spline().end()), phase,
                                         from.radians - to.radians);
    if (!rest) return std::nullopt;
    return to.half_turns - from.half_turns - *rest;
  };
  const auto [angle, turns] = reduced(nominal_, over_pi);
  if (turns == 0) nominal_ = angle;  // maybe exact now
  turns_ = extra_turns - turns;
  twist_ = extra_turns == 0 ? angle : angle + whole_turn(extra_turns);
}

Real MinimalTwist::rate() const { return twist_ * Real(1 / length_); }

Real MinimalTwist::value(const Rational& t) const {
  if (t == 0) return to_real(from_);
  if (t == rmf_->spline().end())
    return turns_ == 0 ? to_real(to_) : to_real(to_) + whole_turn(turns_);
  const SplineParameter at = locate(rmf_->spline(), t);
  const Rational share = (starts_[at.segment] + arc_lengths_[at.segment](at.t)) / length_;
  return to_real(from_) + twist_ * Real(share) + rmf_->value(at);
}

}  // namespace phrame
