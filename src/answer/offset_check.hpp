#pragma once
#include "phrame/answer/offset.hpp"

namespace phrame::inline v0 {

/// What somebody else has for an offset: polylines and curves, of which x and y count.
struct ForeignOffset {
  std::vector<std::vector<Vector<Rational>>> polylines;  ///< of two points or more each
  std::vector<Path> paths;                               ///< curves of any kind but formulas
};

/// Asks how far that is from the exact one.
struct OffsetCheckQuery {
  Rational distance;                    ///< as OffsetQuery has it
  OffsetJoin join = OffsetJoin::round;  ///< likewise
  bool trim = false;                    ///< likewise
  ForeignOffset given;                  ///< what is checked
  Rational tolerance;                   ///< > 0, a length
};

/// How far it is from it, to both sides: what is missing, and what is too much.
struct OffsetCheckAnswer {
  /// A place on the exact offset, or on what is checked.
  struct Place {
    Decimal t;     ///< of the path; of what is checked its own, k to k + 1 on its line or segment k
    bool is_join;  ///< is it on what joins offsets at the corner there?
    std::array<Decimal, 2> point;  ///< x and y, rounded
  };
  /// A stretch that is not within the tolerance.
  struct Stretch {
    Place from;
    Place to;
    Place farthest;     ///< of what was looked at
    Rational at_least;  ///< the distance there
    bool is_proved;     ///< is that beyond the tolerance? Else it may be
  };
  /// From all points of one to the nearest ones of the other.
  struct Side {
    Rational at_least;  ///< the greatest of these distances is at least that …
    Rational at_most;   ///< … and at most that
    Place farthest;     ///< where it is
    /// All that is not proved to be within the tolerance; of more than a hundred stretches these
    /// that are farthest.
    std::vector<Stretch> stretches;
    std::size_t count;  ///< how many there are
  };
  NamedPath path;          ///< as asked
  OffsetCheckQuery query;  ///< as asked
  std::size_t closed = 0;  ///< how many polylines are closed since all of the exact offset is
  Side missing;            ///< from the exact offset to what is checked
  Side excess;             ///< from what is checked to the exact offset
  bool passes;             ///< are both proved to be within the tolerance?
  bool is_decided;         ///< if not, is it proved that they are not?
};

/// Polylines that do not end where they start are closed if all of the exact offset is. Throws
/// InputError as answer() of an OffsetQuery, for a path that is not PH, and where nothing or a
/// curve by formulas is given; DomainError where nothing is left of a trimmed offset; Undecided
/// where places of a trimmed offset are.
PHRAME_API OffsetCheckAnswer answer(const NamedPath& named, const OffsetCheckQuery& query);

}  // namespace phrame
