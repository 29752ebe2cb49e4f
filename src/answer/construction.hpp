#pragma once
#include <optional>
#include <string_view>
#include <vector>

#include "phrame/export.hpp"
#include "phrame/ph/construct/construction.hpp"
#include "phrame/ph/construct/hermite_spline.hpp"
#include "phrame/ph/curve/named.hpp"

namespace phrame {

/// What kind of PH curves a construction is made of.
enum class CurveKind { quintic, planar, cubic, helical, rrmf, rmf, c2, c2_hermite };

/// What is equal at the joints of a spline, exactly.
enum class Continuity {
  g1,  ///< position and tangent; of derivatives the data are then the directions only
  c1,  ///< position and derivative by the parameter
  c2   ///< the second derivative as well
};

/// The kinds there are, in their order, as people call them.
struct NamedKind {
  CurveKind kind;         ///< which one
  std::string_view name;  ///< "quintic"
  std::string_view what;  ///< "C1 splines of PH quintics"
  Continuity continuity;  ///< of its splines
  long solutions = 1;     ///< how many curves there are at most, of which one is asked for
  /// What holds exactly of every curve of this kind, beside being PH; it has been checked of the
  /// one that is answered. May be empty.
  std::string_view law = {};
  bool is_open = false;  ///< its splines cannot be closed
  /// Are derivatives wanted at the ends of open curves only, those between being a consequence?
  bool is_through_points = false;
};
PHRAME_API const std::vector<NamedKind>& curve_kinds();  ///< all kinds

/// Which exact PH curve meets these data, as nearly as asked?
struct ConstructQuery {
  CurveKind kind = CurveKind::quintic;                 ///< what the curve is made of
  QuinticChoice choice = QuinticSelection::automatic;  ///< of the kind quintic
  long solution = 1;  ///< of the kinds with several: from 1, the best one, to their number
  /// How far the curve may be from the points, beside their extent, and its derivatives from those
  /// wanted, beside the greatest of them. > 0 and < 1.
  Rational tolerance = Rational(1, 1'000'000'000'000'000);
  PointRule points = PointRule::near;  ///< how are the points met?
  bool is_closed = false;              ///< does the curve end where it starts?
};

/// An exact PH curve near its data, and how near it is.
struct ConstructionAnswer {
  /// What is said of one segment.
  struct Segment {
    std::optional<FreeAngles> angles;  ///< of quintics
    Rational length;                   ///< exact
    std::optional<RealBall> energy;    ///< around ∫κ² ds; no value where it is infinite
  };
  NamedPhPath path;  ///< the curve
  /// @{ As asked.
  NamedKind kind;
  QuinticChoice choice;
  long solution;
  PointRule points;
  /// @}
  HermiteSpline data;                ///< what was wanted
  std::vector<Rational> parameters;  ///< of the joints and the ends
  /// @{ Where those come from that were not given.
  DerivativeSource derivatives_from;
  ParameterSource parameters_from;
  /// @}
  Deviation tolerance;            ///< what was asked for, as distances
  Deviation deviation;            ///< proved bounds
  long bits;                      ///< of the preimages' common denominator, a power of 2
  std::vector<Segment> segments;  ///< one after the other
};

/// Throws InputError for what this kind does not take, DomainError where there is no such curve.
PHRAME_API ConstructionAnswer answer(const GivenPoints& given, const ConstructQuery& query);

}  // namespace phrame
