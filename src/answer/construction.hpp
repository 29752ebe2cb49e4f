#pragma once
#include <optional>
#include <string_view>
#include <vector>

#include "phrame/export.hpp"
#include "phrame/ph/construct/construction.hpp"
#include "phrame/ph/construct/hermite_spline.hpp"
#include "phrame/ph/curve/named.hpp"

namespace phrame::inline v0 {

/// What kind of PH curves a construction is made of.
enum class CurveKind { quintic, planar, cubic, helical, rrmf, rmf, c2, c2_hermite, length };

/// What is equal at the joints of a spline, exactly.
enum class Continuity {
  g1,  ///< position and tangent: of given derivatives only the directions count
  c1,  ///< position and derivative by the parameter
  c2   ///< the second derivative as well
};

/// A kind of curve with its name and what is known of it.
struct NamedKind {
  CurveKind kind;         ///< which one
  std::string_view name;  ///< "quintic"
  std::string_view what;  ///< "C1 splines of PH quintics"
  Continuity continuity;  ///< of its splines
  long solutions = 1;     ///< the greatest number of curves that one query may choose from
  /// What holds exactly for every curve of this kind beside its being PH; empty if nothing does. It
  /// is checked for the curve in an answer.
  std::string_view law = {};
  bool is_open = false;  ///< its splines cannot be closed
  /// Does it take derivatives at the ends of open curves only, those between following from the
  /// points?
  bool is_through_points = false;
  bool takes_lengths = false;  ///< does it want the lengths of the segments?
};
PHRAME_API const std::vector<NamedKind>& curve_kinds();  ///< all kinds, in the order of CurveKind

/// Asks for an exact PH curve near given points and derivatives.
struct ConstructQuery {
  CurveKind kind = CurveKind::quintic;                 ///< what the curve is made of
  QuinticChoice choice = QuinticSelection::automatic;  ///< of the kind quintic
  long solution = 1;  ///< which of several solutions: 1 is the best one
  /// The tolerance, between 0 and 1: distances from the points are measured in the extent of the
  /// points, deviations of derivatives in the greatest derivative.
  Rational tolerance = Rational(1, 1'000'000'000'000'000);
  PointRule points = PointRule::near;  ///< how are the points met?
  bool is_closed = false;              ///< does the curve end where it starts?
  /// Of the kind length: the length of each segment, or of the whole, which is shared in proportion
  /// to the chords.
  std::vector<Rational> lengths = {};
  bool is_measured = true;  ///< are lengths and energies wanted? Else the answer has no `segments`
};

/// An exact PH curve near its data, and how near it is.
struct ConstructionAnswer {
  /// The numbers of one segment.
  struct Segment {
    std::optional<FreeAngles> angles;  ///< of quintics
    Rational length;                   ///< exact
    std::optional<RealBall> energy;    ///< around ∫κ² ds; no value where it is infinite
  };
  NamedPhPath path;  ///< the curve
  /// @{ As asked for.
  NamedKind kind;
  QuinticChoice choice;
  long solution;
  PointRule points;
  /// @}
  HermiteSpline data;                ///< what the curve should have
  std::vector<Rational> parameters;  ///< of the joints and the ends
  /// @{ Where derivatives and parameters come from.
  DerivativeSource derivatives_from;
  ParameterSource parameters_from;
  /// @}
  Deviation tolerance;  ///< what was asked for, as distances
  Deviation deviation;  ///< proved bounds
  long bits;            ///< of the preimages' common denominator, a power of 2
  /// What is found about poses.
  struct Poses {
    /// The greatest Orientation::off.
    Rational off;
    /// The tangent axis whose directions are nearest to the chords at the points, where it is not
    /// the one given and much nearer: perhaps it was meant.
    std::optional<TangentAxis> better;
    double angle;         ///< the mean angle between tangents and chords, in radians
    double better_angle;  ///< the same by the other axis
  };
  std::optional<Poses> poses;     ///< where they were given
  std::vector<Segment> segments;  ///< one after the other
};

/// Throws InputError for what this kind does not take, DomainError where there is no such curve.
PHRAME_API ConstructionAnswer answer(const GivenPoints& given, const ConstructQuery& query);

}  // namespace phrame
