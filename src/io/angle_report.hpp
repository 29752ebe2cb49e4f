#pragma once
#include "phrame/io/curve_file.hpp"
#include "phrame/ph/rmf_angle.hpp"

namespace phrame {

/// One row of a table of angles.
struct AngleValue {
  Rational t;
  Decimal theta;  ///< radians, continuous branch
};

/// What `phrame angle` shows of a curve.
struct AngleReport {
  const NamedCurve& curve;
  Reference reference;
  const RmfAngle& angle;
  Rational start_angle;  ///< θ(0)
  std::vector<AngleValue> values;
  long digits;
};

std::string to_text(const AngleReport& report);   ///< for reading, Unicode
std::string to_latex(const AngleReport& report);  ///< the closed form and the table
std::string to_json(const AngleReport& report);   ///< angle/1

/// "partial-fractions", "rothstein-trager", "mixed", or "rational" where there is no logarithm.
std::string form_name(const Antiderivative& F);

/// "PH quintic, degree 5", the heading of a report.
std::string heading(const NamedCurve& named);

}  // namespace phrame
