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
      erf_twist_(remembered(-rmf.value(rmf.spline().end()))),
      nominal_(Rational(0)),
      twist_(Rational(0)) {
  for (const Curve& curve : rmf.spline().segments()) {
    const ArcLength s(curve);
    arc_lengths_.push_back(s.polynomial());
    starts_.push_back(length_);
    length_ += s.total();
  }
  // Whole turns of the angles given are no matter, however many.
  const Rational half_turns = to.half_turns - from.half_turns;
  const Integer given_turns(numerator(half_turns) / denominator(half_turns) / 2);
  const FrameAngle end{half_turns - 2 * given_turns, to.radians, to.direction};
  const FrameAngle start{0, from.radians, from.direction};
  const Real rest = erf_twist_ + to_real(end) + -to_real(start);
  const auto over_pi = [&]() -> std::optional<Rational> {
    // −T/π without the multiples of π.
    const GaussianPolynomial phase = path_to(from.direction) * conjugate(path_to(to.direction));
    const auto m = rmf.multiple_of_pi(locate(rmf.spline(), rmf.spline().end()), phase,
                                      from.radians - to.radians);
    if (!m) return std::nullopt;
    return end.half_turns - *m;
  };
  const auto [angle, more_turns] = reduced(rest, over_pi);
  const Integer turns = given_turns + more_turns;
  nominal_ = turns == 0 ? angle : angle + whole_turn(turns);
  turns_ = extra_turns - turns;
  twist_ = extra_turns == 0 ? angle : angle + whole_turn(extra_turns);
}

Real MinimalTwist::rate() const { return twist_ * Real(1 / length_); }

std::optional<Integer> MinimalTwist::whole_turns_of_theta() const {
  const auto half_turns = over_pi(difference(to_, from_));
  if (!half_turns) return std::nullopt;
  const Rational turns = *half_turns / 2 + Rational(turns_);
  if (denominator(turns) != 1) return std::nullopt;
  return Integer(numerator(turns));
}

Real MinimalTwist::value(const Rational& t) const {
  if (t == 0) return to_real(from_);
  if (t == rmf_->spline().end())
    return turns_ == 0 ? to_real(to_) : to_real(to_) + whole_turn(turns_);
  const SplineParameter at = locate(rmf_->spline(), t);
  return value(Real(starts_[at.segment] + arc_lengths_[at.segment](at.t)), rmf_->value(at));
}

Real MinimalTwist::value(const Real& s, const Real& rmf_angle) const {
  return to_real(from_) + twist_ * (s * Real(1 / length_)) + rmf_angle;
}

}  // namespace phrame
