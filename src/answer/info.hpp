#pragma once
#include "phrame/algebra/real_algebraic.hpp"
#include "phrame/export.hpp"
#include "phrame/ph/along/plane_turning.hpp"
#include "phrame/ph/curve/complex_form.hpp"
#include "phrame/ph/curve/nearest.hpp"
#include "phrame/ph/curve/path.hpp"
#include "phrame/ph/offset/offset_kind.hpp"

namespace phrame::inline v0 {

/// Asks for the length, the twist, the energy and other numbers of a path.
struct InfoQuery {
  long digits = 17;                              ///< of all numbers
  bool wants_box = false;                        ///< the box around it
  std::optional<Vector<Rational>> nearest = {};  ///< where is it nearest to this point?
};

/// The numbers of a path.
struct InfoAnswer {
  /// A length, exact where it is rational.
  struct Length {
    std::optional<Rational> exact = std::nullopt;  ///< where it is seen to be rational
    Decimal rounded = {};                          ///< to the digits asked for
  };
  /// A break of the tangent at the start of a segment. Segment 0 stands for the joint where a
  /// closed path ends.
  struct Corner {
    std::size_t segment;  ///< 0, 1, …
    Decimal angle;        ///< between the tangents
  };
  NamedPath path;               ///< as asked
  Length length;                ///< ∫ |r′| dt
  std::vector<Length> lengths;  ///< of the segments
  /// v, which is nowhere along the tangent, where the path is not PH.
  std::optional<Vector<Rational>> up;
  /// How far a reference frame turns about the tangent: ∫ 2h/σ dt of the Euler–Rodrigues frame of a
  /// PH path, ∫ e₂′·e₃ dt of the frame of v of any other path.
  Decimal twist;
  std::optional<Decimal> bending_energy;   ///< ∫ κ² ds; no value where it is infinite
  bool is_straight;                        ///< is it a straight line?
  std::optional<Vector<Rational>> normal;  ///< of the plane of the path, if it is plane and no line
  std::vector<Corner> corners = {};        ///< all of them
  std::optional<Decimal> holonomy = {};    ///< of a closed path, but not of a single PH curve
  std::string no_holonomy = {};  ///< why the holonomy of a closed path is missing: it is undecided
  /// The cusps in [0, 1] of a single rational curve.
  std::vector<RealRoot> cusps = {};
  /// Where the signed curvature is 0 or has an extremum.
  struct Bend {
    RealAlgebraic t;            ///< in (0, 1)
    CurvaturePlace::Kind kind;  ///< what is there
    Decimal curvature;          ///< > 0 to the left, seen from the side of upper_normal()
  };
  /// All such places of a single rational curve in a plane; no value for others.
  std::optional<std::vector<Bend>> bends = {};
  /// K, L, M of the tangents, of a rational PH curve by itself in a plane z = const.
  std::optional<Vector<Polynomial>> tangents = {};
  std::optional<OffsetKind> offset = {};  ///< of that curve: is its offset rational?
  // Of a PH curve by itself:
  std::vector<Decimal> erf_inflections = {};  ///< in (0, 1), where the ERF turns back
  std::vector<Decimal> erf_extrema = {};      ///< in (0, 1), of its rate about e₁
  std::optional<ComplexForm> complex = {};    ///< where it is in a plane z = const
  /// Where it is a plane cubic, and no line.
  std::optional<TschirnhausenCubic> tschirnhausen = {};
  Length tschirnhausen_scale = {};  ///< a of that
  // Where they are asked for:
  std::optional<std::array<std::array<Decimal, 2>, 3>> box = {};  ///< of x, y, z from and to
  /// The nearest point.
  struct Nearest {
    Vector<Rational> to;    ///< as asked
    Decimal t;              ///< the parameter there
    Vector<Decimal> point;  ///< of the path
    Decimal distance;       ///< between the two
  };
  std::optional<Nearest> nearest = {};  ///< to the point of the query
};

/// Throws Undecided, with the name of what it is, where a number cannot be rounded.
PHRAME_API InfoAnswer answer(NamedPath path, const InfoQuery& query);

}  // namespace phrame
