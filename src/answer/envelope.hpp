#pragma once
#include "phrame/algebra/real_algebraic.hpp"
#include "phrame/answer/boundary_end.hpp"
#include "phrame/export.hpp"
#include "phrame/ph/curve/path.hpp"
#include "phrame/ph/offset/envelope.hpp"

namespace phrame::inline v0 {

/// Asks for the envelope of the discs along a medial axis.
struct EnvelopeQuery {
  bool trim = false;  ///< without what is inside of a disc, as the boundary of their union?
  long digits = 17;   ///< of places where it is cut
};

/// The envelope. A place on it is named by the parameter t of the axis there: k + t of segment k.
struct EnvelopeAnswer {
  /// A side of the envelope of a segment.
  struct OneSide {
    std::optional<Path> curve;         ///< no value where it is one point
    Vector<Rational> start;            ///< its point at t = 0
    std::vector<RealAlgebraic> cusps;  ///< t where it turns back, in (0, 1)
  };
  /// A segment.
  struct Segment {
    MinkowskiCurve curve;
    long degree;
    std::vector<Polynomial> null_factors;  ///< a, b, c, d
    Polynomial sigma;                      ///< of which the square is x′² + y′² − r′²
    std::vector<RealAlgebraic> lightlike;  ///< t in [0, 1] where it is 0
    OneSide right;
    OneSide left;
  };
  /// What is left of a side or an arc.
  struct Piece {
    BoundaryEnd from;  ///< of an arc t is that of the disc
    BoundaryEnd to;    ///< likewise
    EnvelopePiece::Kind kind;
  };
  /// A loop of the boundary.
  struct Branch {
    bool is_closed;             ///< is it one?
    std::vector<Piece> pieces;  ///< one after the other
    std::vector<Path> paths;    ///< it
  };
  /// A stretch of which it is not told whether it is inside of a disc.
  struct UndecidedStretch {
    std::array<Decimal, 2> t;  ///< from and to
    EnvelopePiece::Kind kind;
  };
  std::string name;  ///< of the axis
  std::vector<Segment> segments;
  Rational greatest_radius;  ///< of a control point
  std::vector<Path> paths;   ///< the whole envelope, where it is not trimmed
  bool is_trimmed;           ///< as asked
  std::vector<Branch> branches;
  std::vector<UndecidedStretch> undecided;
};

/// Throws as envelope() and domain_boundary().
PHRAME_API EnvelopeAnswer answer(const NamedAxis& axis, const EnvelopeQuery& query);
/// All paths of the envelope, or of all branches.
PHRAME_API std::vector<Path> all_paths(const EnvelopeAnswer& answer);

}  // namespace phrame
