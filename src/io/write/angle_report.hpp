#pragma once
#include "phrame/integrate/radicals.hpp"
#include "phrame/integrate/real_form.hpp"
#include "phrame/ph/curve/named.hpp"
#include "phrame/ph/frame/rmf_angle.hpp"

namespace phrame {

/// One row of a table of angles.
struct AngleValue {
  Rational t;
  Decimal theta;  ///< radians, continuous branch
};

/// θ = θ(t), rounded to `digits` digits. Throws Undecided, naming t.
AngleValue rounded_angle(const Rational& t, const Real& theta, long digits);

/// What `phrame angle` shows of a curve.
struct AngleReport {
  NamedCurve curve;
  Reference reference;
  RmfAngle angle;
  Angle start_angle;  ///< θ(0)
  std::vector<AngleValue> values;
  long digits;
  std::optional<RealForm> real = std::nullopt;  ///< of the angle, shown instead of its logarithms
  std::optional<RadicalForm> radicals = std::nullopt;   ///< likewise
  std::optional<TextbookForm> textbook = std::nullopt;  ///< likewise, in scripts
  bool shows_form = true;        ///< JSON only: integrand and antiderivative, too
  bool lists_all_poles = false;  ///< text only: however many they are
};

std::string to_text(const AngleReport& report);       ///< for reading, Unicode
std::string to_latex(const AngleReport& report);      ///< the closed form and the table
std::string to_json(const AngleReport& report);       ///< angle/1
std::string to_json_line(const AngleReport& report);  ///< the same on one line, without its end

/// "t  θ(t)", a line each; long t are passages.
std::string value_table(const std::vector<AngleValue>& values, long digits);

/// How the logarithms of F are written: "partial-fractions" where all sums are over poles,
/// "rothstein-trager" where none is and their polynomials are irreducible, "lazard-rioboo-trager"
/// where one of these is not, else "mixed"; "rational" where there is no logarithm.
std::string form_name(const Antiderivative& F);

/// "PH quintic, degree 5", the heading of a report.
std::string heading(const NamedCurve& named);

/// What frames and angle mean where the multiplier is negative on [0, 1]; empty where it is not.
std::string note_on_sign(const Curve& curve);

}  // namespace phrame
