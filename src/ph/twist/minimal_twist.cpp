#include "phrame/ph/twist/minimal_twist.hpp"

#include <fmt/format.h>

#include "phrame/algebra/error.hpp"
#include "phrame/ph/along/reduced_angle.hpp"

namespace phrame {

MinimalTwist::MinimalTwist(const PathAngle& rmf, const FrameAngle& from, const FrameAngle& to,
                           const Integer& extra_turns)
    : path_(rmf.path().ph().value()),
      rmf_(rmf),
      from_(from),
      start_(reduced(from)),
      length_(path_),
      erf_twist_(remembered(-rmf.value(path_.end()))),
      nominal_(Rational(0)),
      twist_(Rational(0)) {
  for (std::size_t k = 0; k < path().segments().size(); ++k)
    if (!length_.closed_form(k))
      throw DomainError(fmt::format("{}arc length: the multiplier changes sign on [0, 1]",
                                    path().is_curve() ? "" : fmt::format("segment {}: ", k + 1)));
  whole_ = *length_.total().exact();
  // Whole turns of the angles given are no matter, however many.
  const FrameAngle given = difference(to, from);
  const FrameAngle between = reduced(given);
  const Real rest = erf_twist_ + to_real(between);
  const auto over_pi = [&]() -> std::optional<Rational> {
    // −T/π without the multiples of π.
    const GaussianRational& z = between.direction;
    const auto m = rmf.multiple_of_pi(locate_inside(path_, path_.end()), path_to({z.re, -z.im}),
                                      -between.radians);
    if (!m) return std::nullopt;
    return between.half_turns - *m;
  };
  const auto [angle, more_turns, within] = reduced(rest, over_pi);
  half_turn_within_ = within;
  const Rational given_half_turns = given.half_turns - between.half_turns;
  const Integer turns = numerator(given_half_turns) / 2 + more_turns;
  nominal_ = turns == 0 ? angle : angle + whole_turn(turns);
  twist_ = extra_turns == 0 ? angle : angle + whole_turn(extra_turns);
  turn_ = between;
  turn_.half_turns += Rational(2 * (extra_turns - more_turns));
}

Real MinimalTwist::rate() const { return twist_ * Real(1 / length()); }

std::optional<Integer> MinimalTwist::whole_turns_of_theta() const {
  const auto half_turns = over_pi(turn_);
  if (!half_turns || denominator(*half_turns) != 1 || numerator(*half_turns) % 2 != 0)
    return std::nullopt;
  return Integer(numerator(*half_turns) / 2);
}

Real MinimalTwist::value(const Rational& t) const { return value(from_, t); }

Real MinimalTwist::reduced_value(const Rational& t) const { return value(start_, t); }

Real MinimalTwist::value(const FrameAngle& start, const Rational& t) const {
  if (t == 0) return to_real(start);
  if (t == path().end()) return to_real(start + turn_);
  const PathParameter at = locate_inside(path(), t);
  return value(start, length_.value(at), rmf_.value(at));
}

Real MinimalTwist::value(const Real& s, const Real& rmf_angle) const {
  return value(from_, s, rmf_angle);
}

Real MinimalTwist::value(const FrameAngle& start, const Real& s, const Real& rmf_angle) const {
  return to_real(start) + twist_ * (s * Real(1 / length())) + rmf_angle;
}

}  // namespace phrame
