#pragma once
#include "phrame/io/write/angle_report.hpp"
#include "phrame/ph/frame/spline_angle.hpp"

namespace phrame {

/// What `phrame angle` shows of a spline.
struct SplineAngleReport {
  std::string name;
  SplineAngle angle;
  Angle start_angle;  ///< θ(0)
  std::vector<AngleValue> values;
  Decimal total;                    ///< θ(end) − θ(0)
  std::optional<Decimal> holonomy;  ///< where the spline is closed
  long digits;
  bool shows_form = true;  ///< JSON only: integrands and antiderivatives, too
};

/// The values of θ at `at`, rounded to `digits` digits. Throws Undecided, naming what it is that
/// cannot be rounded.
SplineAngleReport spline_angle_report(const std::string& name, const SplineAngle& angle,
                                      const Angle& start_angle, const std::vector<Rational>& at,
                                      long digits);

/// What frames and angles mean where the multiplier of a segment is negative; empty where none is.
std::string notes_on_signs(const Spline& spline);

std::string to_text(const SplineAngleReport& report);
std::string to_json(const SplineAngleReport& report);  ///< spline-angle/1
std::string to_json_line(
    const SplineAngleReport& report);  ///< the same on one line, without its end

/// What `phrame info` shows of a spline.
struct SplineInfo {
  struct Length {
    Real exact;
    Decimal rounded;  ///< where it is irrational
  };
  NamedSpline spline;
  Length length;
  std::vector<Length> lengths;            ///< of the segments
  Decimal twist_erf;                      ///< of the continuous Euler–Rodrigues frame, −θ(end)
  std::optional<Decimal> bending_energy;  ///< no value where it is infinite
  std::optional<Decimal> holonomy;        ///< where the spline is closed
};

SplineInfo spline_info(const NamedSpline& spline, long digits);

std::string to_text(const SplineInfo& info);
std::string to_json(const SplineInfo& info);  ///< spline-info/1

}  // namespace phrame
