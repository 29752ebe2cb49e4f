#pragma once
#include "phrame/answer/angle.hpp"
#include "phrame/answer/twist_frame.hpp"
#include "phrame/ph/frame/frame_angle.hpp"

namespace phrame {

/// Which frame turns least, from one orientation at the start of a path to another at its end?
struct MinimalTwistQuery {
  FrameAngle from;                ///< θ_i
  FrameAngle to;                  ///< θ_f
  long extra_turns = 0;           ///< so many revolutions more
  std::vector<Rational> at = {};  ///< the t where θ is asked for
  long digits = 17;               ///< of all numbers
  struct RationalFrame {
    RationalTwistOptions rotation;
    Subdivision subdivision;
    bool is_needed;  ///< is it an error that there is none?
  };
  std::optional<RationalFrame> rational = {};
};

struct MinimalTwistAnswer {
  NamedPath path;
  Decimal from;  ///< θ_i
  Decimal to;    ///< θ_f
  Rational length;
  Decimal erf_twist;
  Decimal nominal_twist;
  Decimal twist;
  Decimal rate;
  std::vector<AngleValue> values;
  long digits;
  std::optional<TwistFrameAnswer> rational = {};
  std::string why_not_rational = {};  ///< where there is none
  std::string why_undecided = {};     ///< where none was found, or could be shown
};

/// Throws DomainError as MinimalTwist, and as twist_frame() where a rational frame is needed;
/// Undecided, naming what it is, where a number cannot be rounded.
MinimalTwistAnswer answer(const NamedPath& path, const MinimalTwistQuery& query);

}  // namespace phrame
