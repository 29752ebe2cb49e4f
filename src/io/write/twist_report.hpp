#pragma once
#include "phrame/io/write/angle_report.hpp"
#include "phrame/io/write/twist_frame_report.hpp"
#include "phrame/ph/twist/minimal_twist.hpp"

namespace phrame {

/// What `phrame mtf` shows of a curve or spline.
struct TwistReport {
  std::string name;
  Spline spline;
  Decimal from;  ///< θ_i
  Decimal to;    ///< θ_f
  Rational length;
  Decimal erf_twist;
  Decimal nominal_twist;
  Decimal twist;
  Decimal rate;
  std::vector<AngleValue> values;
  long digits;
  std::optional<TwistFrameReport> rational = {};
  std::string why_not_rational = {};  ///< where there is none
  std::string why_undecided = {};     ///< where none was found, or could be shown
};

/// The values of θ at `at`, rounded to `digits` digits. Throws Undecided, naming what it is that
/// cannot be rounded.
TwistReport twist_report(const std::string& name, const FrameAngle& from, const FrameAngle& to,
                         const MinimalTwist& mtf, const std::vector<Rational>& at, long digits);

std::string to_text(const TwistReport& report);
std::string to_json(const TwistReport& report);  ///< mtf/1

}  // namespace phrame
