#pragma once
#include "phrame/algebra/angle.hpp"
#include "phrame/integrate/other_form.hpp"
#include "phrame/integrate/pole_table.hpp"
#include "phrame/ph/curve/named.hpp"
#include "phrame/ph/frame/rmf_angle.hpp"

namespace phrame {

/// Which angle is the rotation-minimizing frame at?
struct AngleQuery {
  Reference reference = Reference::euler_rodrigues;
  Angle start_angle = {};         ///< θ(0)
  std::vector<Rational> at = {};  ///< the t where θ is asked for
  long digits = 17;               ///< of its values
  Route route = Route::automatic;
  bool wants_formula = true;  ///< of θ, on each segment
  Form form = Form::automatic;
  Style style = Style::logarithms;
  /// Where they are listed: so many poles with their residues, and more are counted.
  std::optional<long> most_poles = {};
};

/// θ on one segment, up to a constant.
struct AngleFormula {
  RationalFunction rate;                   ///< θ′
  Antiderivative angle_to_erf;             ///< θ, or θ − arg(bend)
  std::optional<GaussianPolynomial> bend;  ///< to the Frenet frame: g without its real factor
  Antiderivative antiderivative;           ///< θ, with the argument of the bend as logarithms
  OtherForm other;
  std::optional<PoleTable> poles;
};

/// One row of a table of angles.
struct AngleValue {
  Rational t;
  Decimal theta;  ///< radians, continuous branch
};

struct AngleAnswer {
  NamedPath path;
  Reference reference;
  Angle start_angle;
  std::vector<AngleFormula> formulas;  ///< of the segments, if they are wanted
  std::vector<AngleValue> values;
  long digits;
  std::optional<Decimal> total;     ///< θ(end) − θ(0) of a spline
  std::optional<Decimal> holonomy;  ///< of a closed spline
};

/// Throws DomainError as PathAngle and, in the style of radicals, as radical_form(); Undecided,
/// with the name of what it is, where a number cannot be rounded.
AngleAnswer answer(NamedPath path, const AngleQuery& query);

/// θ = θ(t), rounded to `digits` digits. Throws Undecided, naming t.
AngleValue rounded_angle(const Rational& t, const Real& theta, long digits);

}  // namespace phrame
