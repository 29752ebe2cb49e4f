#pragma once
#include "phrame/algebra/real_algebraic.hpp"
#include "phrame/export.hpp"
#include "phrame/integrate/exact_value.hpp"
#include "phrame/ph/curve/path.hpp"
#include "phrame/ph/offset/offset.hpp"

namespace phrame {

/// Asks for the offsets of a plane PH path at some distances.
struct OffsetQuery {
  std::vector<Rational> distances;      ///< at least one, > 0 to the right of travel; not 0
  OffsetJoin join = OffsetJoin::round;  ///< at corners, on the outer side
  long digits = 17;                     ///< of lengths and areas
};

/// The offsets of a path. A place on them is named by the parameter t of the path there.
struct OffsetAnswer {
  /// A length or an area.
  struct Measure {
    std::optional<ExactValue> exact;  ///< in finite terms, where it is known so
    Decimal rounded;                  ///< to the digits asked for
  };
  /// A zero of 1 + dκ.
  struct Cusp {
    RealAlgebraic t;  ///< of the path
    bool turns_back;  ///< does the offset turn back?
  };
  /// A place where the offset meets itself.
  struct Place {
    Decimal t;     ///< of the path, with a radius
    bool is_join;  ///< is it on what joins the offsets at the corner there?
  };
  /// Two places of the offset that are one point.
  struct Meeting {
    Place first;                ///< the earlier one
    Place second;               ///< the later one
    std::array<Decimal, 2> at;  ///< x and y, with radii
  };
  /// Two parts of the offset that may meet: it is not decided.
  struct Undecided {
    std::array<Decimal, 2> first;   ///< from t to t
    std::array<Decimal, 2> second;  ///< likewise
  };
  /// A part of the offset between neighbouring ends, which are gaps and the cusps where it turns
  /// back.
  struct Stretch {
    RealAlgebraic from;  ///< t of the path
    RealAlgebraic to;    ///< likewise
    Measure length;      ///< |Δs + d·Δφ|
  };
  /// One of the offsets.
  struct Part {
    Rational distance;                 ///< as asked
    std::vector<Path> paths;           ///< the offset, in as few paths as possible
    std::vector<Cusp> cusps;           ///< all of them
    std::vector<Meeting> meetings;     ///< the self-intersections that are proved
    std::vector<Undecided> undecided;  ///< where else there may be some
    bool is_cut_off;  ///< were too many parts undecided? Then there may be others anywhere
    std::vector<Rational> inner_corners;  ///< t of those where both sides cross
    std::vector<Stretch> stretches;       ///< one after the other
    Measure length;                       ///< of all of it
    std::optional<Measure> area;          ///< signed, of a closed one
  };
  NamedPath path;             ///< as asked
  bool is_closed;             ///< is that closed?
  OffsetJoin join;            ///< as asked
  std::vector<Part> offsets;  ///< in the order of the distances
};

/// Throws DomainError for a path that is not PH or in no plane z = const, and for a distance 0.
PHRAME_API OffsetAnswer answer(const NamedPath& named, const OffsetQuery& query);

}  // namespace phrame
