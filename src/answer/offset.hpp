#pragma once
#include "phrame/algebra/real_algebraic.hpp"
#include "phrame/answer/boundary_end.hpp"
#include "phrame/export.hpp"
#include "phrame/integrate/exact_value.hpp"
#include "phrame/ph/curve/path.hpp"
#include "phrame/ph/offset/gauge_offset.hpp"
#include "phrame/ph/offset/offset.hpp"
#include "phrame/ph/offset/offset_kind.hpp"

namespace phrame::inline v0 {

/// Asks for the offsets of a plane PH path at some distances, or of any under a gauge.
struct OffsetQuery {
  std::vector<Rational> distances;      ///< at least one, > 0 to the right of travel; not 0
  OffsetJoin join = OffsetJoin::round;  ///< at corners, on the outer side
  long digits = 17;                     ///< of lengths and areas, and of places where it is cut
  bool trim = false;                    ///< without what is nearer to the path than |d|?
  /// Of a closed path, trimmed, at the one distance inwards and its multiples until nothing is
  /// left?
  bool pocket = false;
  std::optional<Gauge> gauge = {};  ///< whose offsets, in place of the Euclidean ones
};

/// The offsets of a path. A place on them is named by the parameter t of the path there.
struct OffsetAnswer {
  /// A length or an area.
  struct Measure {
    std::optional<ExactValue> exact;  ///< in finite terms, where it is known so
    Decimal rounded;                  ///< to the digits asked for
    Real value = Rational(0);         ///< all of them
  };
  /// A zero of 1 + dκ.
  struct Cusp {
    RealAlgebraic t;            ///< of the path
    bool turns_back;            ///< does the offset turn back?
    std::array<Decimal, 2> at;  ///< x and y, to the digits asked for
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
    bool touches = false;       ///< without crossing there?
  };
  /// Two parts of the offset that are one set of points, as of a path that goes along itself.
  struct Coincident {
    std::array<Place, 2> first;   ///< from and to, the earlier part
    std::array<Place, 2> second;  ///< the same points; backwards where it goes the other way
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
    Rational distance;  ///< as asked
    /// The offset, in as few paths as possible; none where it is nothing but points, as that of an
    /// arc at the distance of its center.
    std::vector<Path> paths;
    std::vector<Cusp> cusps;             ///< all of them
    std::vector<Meeting> meetings;       ///< the self-intersections that are proved
    std::vector<Coincident> coincident;  ///< where it runs along itself, exactly
    std::vector<Undecided> undecided;    ///< where else it may meet itself
    bool is_cut_off;  ///< were too many parts undecided? Then there may be others anywhere
    std::vector<Rational> inner_corners;  ///< t of those where both sides cross
    std::vector<Stretch> stretches;       ///< one after the other; none under a gauge
    Measure length;                       ///< of all of it
    std::optional<Measure> area;          ///< signed, of a closed one
  };
  using End = BoundaryEnd;
  /// What is left of the offset of one segment, or of what joins those at a corner.
  struct TrimmedPiece {
    End from;           ///< at a corner its t is that of the corner
    End to;             ///< likewise
    bool is_join;       ///< is it what joins the offsets there?
    std::size_t piece;  ///< of the offset with `join`, or with round joins where that is `open`
    bool is_cut_from;   ///< is the start one where the offset is cut?
    bool is_cut_to;     ///< is the end?
  };
  /// What is left of it, as long as it goes on.
  struct Branch {
    bool is_closed;                    ///< is it a loop?
    std::vector<TrimmedPiece> pieces;  ///< one after the other
    std::vector<Path> paths;           ///< it, in several where it turns back at a cut
    Measure length;                    ///< of all of it
    std::optional<Measure> area;       ///< of a closed one, > 0 where it goes round to the left
  };
  /// A stretch of which it is not told whether it is nearer than |d|.
  struct UndecidedStretch {
    std::array<Decimal, 2> t;  ///< from and to
    bool is_join;              ///< is it on what joins the offsets at the corner there?
  };
  /// One of the offsets, trimmed.
  struct Trimmed {
    Rational distance;                        ///< as asked
    std::vector<Branch> branches;             ///< by the places where they start
    std::vector<UndecidedStretch> undecided;  ///< where branches touch or coincide
  };
  /// Both offsets of a curve of which none is rational by itself.
  struct Both {
    Rational distance;        ///< as asked
    TwoSidedOffset offset;    ///< one rational curve
    std::vector<Path> paths;  ///< the sides of it
  };
  NamedPath path;             ///< as asked
  bool is_closed;             ///< is that closed?
  OffsetJoin join;            ///< as asked
  std::vector<Part> offsets;  ///< in the order of the distances, if they are not trimmed
  /// In that order, if they are. Of a pocket each is one branch: first one next to the path, and
  /// behind each branch those inside of it, so that one room comes after the other.
  std::vector<Trimmed> trimmed = {};
  std::vector<Both> both = {};      ///< in that order, if the path is such a curve
  std::optional<Gauge> gauge = {};  ///< as asked
  /// The segments of which the offsets under the gauge are not rational, and left out.
  std::vector<GaugeOffsets::None> without = {};
};

/// Throws InputError, at that place, where a segment is in no plane z = const; curves by formulas
/// are no matter of this.
PHRAME_API void require_plane(const Path& path, const std::string& place);

/// Why a path that is not PH, of which require_plane() holds, has no rational offset to both sides
/// together, or none that is given: of all of it, or trimmed. No value where it has one, perhaps
/// over another field.
PHRAME_API std::optional<std::string> why_no_offset(const Path& path, bool is_whole);

/// Of a polynomial or rational curve that is not PH the two-sided offset where that is rational
/// over ℚ. What is asked is wrong, an InputError, for a path in no plane z = const, for any other
/// one that is not PH, under a gauge for formulas; for a distance 0; and for a pocket of an open
/// path, at several distances, to the outside or of 10 001 offsets. There is no answer, a
/// DomainError, where at all distances nothing but points is left, as trimmed_offset(), and where
/// the offset is rational over another field; under a gauge where no segment has a rational offset
/// nor one segment a two-sided one, with the degrees of the factors of that and the field that it
/// needs.
PHRAME_API OffsetAnswer answer(const NamedPath& named, const OffsetQuery& query);
/// All paths of all offsets, or of all branches, one after the other.
PHRAME_API std::vector<Path> all_paths(const OffsetAnswer& answer);

}  // namespace phrame
