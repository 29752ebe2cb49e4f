#pragma once
#include <memory>

#include "phrame/algebra/angle.hpp"
#include "phrame/export.hpp"
#include "phrame/integrate/other_form.hpp"
#include "phrame/integrate/pole_table.hpp"
#include "phrame/ph/along/parametrization.hpp"
#include "phrame/ph/frame/frame_start.hpp"

namespace phrame::inline v0 {

/// Asks for the angle θ of the rotation-minimizing frame to a reference frame.
struct AngleQuery {
  /// The frame that θ is measured from. Without it, the one that PathAngle(path) takes.
  std::optional<Reference> reference = {};
  std::optional<Vector<Rational>> up = {};  ///< v, where θ is measured from the frame of v
  FrameStart start = Angle();               ///< θ(0), or where f₂ is at t = 0
  std::vector<Rational> at = {};            ///< where θ is asked for: values of t, or of
  ParameterKind by = ParameterKind::t;      ///< this parameter
  long samples = 0;                         ///< and so many, equally spaced; none or 2 and more
  long digits = 17;                         ///< of its values
  Route route = Route::automatic;           ///< the way to values
  bool wants_formula = true;                ///< is the formula of θ on each PH segment wanted?
  Form form = Form::automatic;              ///< how logarithms are written
  Style style = Style::logarithms;          ///< the functions that θ is written in
  /// Poles and residues are listed, at most so many; of more only the number is given. Without a
  /// value none are listed.
  std::optional<long> most_poles = {};
};

/// θ on one segment, up to a constant.
struct AngleFormula {
  RationalFunction rate;                   ///< θ′
  Antiderivative angle_to_erf;             ///< θ, or θ − arg(bend)
  std::optional<GaussianPolynomial> bend;  ///< g without its real factor, as RmfAngle has it
  Antiderivative antiderivative;           ///< θ, with the argument of the bend as logarithms
  OtherForm other;  ///< the antiderivative in the style asked for, if another than logarithms
  std::optional<PoleTable> poles;  ///< of the antiderivative, where they are to be listed
};

/// One row of a table of angles.
struct AngleValue {
  std::variant<Rational, Decimal> t;  ///< the parameter; rounded where it is no fraction
  Decimal theta;                      ///< radians, continuous branch
  /// What was asked for, where that is the value of another parameter.
  std::optional<std::variant<Rational, Decimal>> asked = {};
};

/// What is asked of θ.
struct AngleValuesQuery {
  const std::vector<Rational>& at;  ///< where
  ParameterKind by;                 ///< the parameter that `at` has values of
  long samples;                     ///< and at so many places, equally spaced; 0, or 2 and more
  long digits;                      ///< significant ones, ≥ 1
};
/// θ there, each rounded by decimal(θ, "theta at t = 1/2").
PHRAME_API std::vector<AngleValue> angle_values(
    const NamedPath& path, const AngleValuesQuery& query,
    const std::function<Real(const Place& at)>& theta,
    const std::function<Decimal(const Real& x, const std::string& what)>& decimal);

/// The angle of the rotation-minimizing frame of a path.
struct AngleAnswer {
  NamedPath path;                      ///< as asked
  Reference reference;                 ///< the frame that θ is measured from
  std::optional<Vector<Rational>> up;  ///< v, where θ is measured from the frame of v
  FrameStart start;                    ///< as asked
  /// θ(0), exact where that is known. Where a frame starts at a vector it is in (−π, π].
  std::variant<FrameAngle, Decimal> start_angle;
  bool is_zero;      ///< is θ − θ(0) = 0 all along?
  bool is_straight;  ///< a line, where any frame that does not turn is the right one?
  /// For each segment, if formulas are wanted: a PH segment has one, others have none, null.
  std::vector<std::shared_ptr<const AngleFormula>> formulas;
  std::vector<AngleValue> values;  ///< where they are asked for, in that order
  ParameterKind by;                ///< by this parameter
  long digits;                     ///< of the values
  std::optional<Decimal> total;    ///< θ(end) − θ(0); not of a single PH curve, which goes on
  /// Of a closed path, unless θ is measured from the Frenet frame.
  std::optional<Decimal> holonomy;
  /// Why the holonomy of a closed path is missing: it is undecided.
  std::string no_holonomy;
};

/// Throws DomainError as PathAngle, start_angle(), locate() and, in the style of radicals, as
/// radical_form(); Undecided, with the name of what it is, where a number cannot be rounded.
PHRAME_API AngleAnswer answer(const NamedPath& path, const AngleQuery& query);

}  // namespace phrame
