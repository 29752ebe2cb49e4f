#pragma once
#include <optional>

#include "phrame/ph/curve/path.hpp"
#include "phrame/ph/offset/minkowski_curve.hpp"
#include "phrame/ph/offset/plane_direction.hpp"

namespace phrame::inline v0 {

/// To which side of travel, for small t > 0.
enum class Side {
  right,  ///< as the offset by d > 0
  left    ///< as that by d < 0
};

/// n(t), from the center of the disc at t to where it touches the envelope on that side:
///   (d² − c², −2cd)/(c² + d²) to the right, (b² − a², 2ab)/(a² + b²) to the left,
/// with the null_factors(): |n| = 1, and n·(x, y) = −r for the direction() (x, y, r).
PHRAME_API PlaneDirection envelope_normal(const MinkowskiCurve& curve, Side side,
                                          const Rational& t);

/// A side of the envelope of the discs: center + radius·n, a rational curve in the same t, of
/// degree n + 2·max(deg c, deg d) to the right and n + 2·max(deg a, deg b) to the left at most, for
/// n of the axis, with H along n turned to the left; no value where it is one point, in which all
/// discs touch. Each point of it is on its disc, which it touches. Where s changes its sign, both
/// sides meet, touching the tip of a disc, and change places.
PHRAME_API std::optional<RationalCurve> envelope_side(const MinkowskiCurve& curve, Side side);

/// Plane curves with radii: a medial axis, of a domain that is the union of the discs.
using MedialAxis = std::vector<MinkowskiCurve>;

/// With the name of its file.
struct NamedAxis {
  std::string name;
  MedialAxis segments;
};
/// Of a control point of the segments, so that no disc is greater.
PHRAME_API Rational greatest_radius(const MedialAxis& axis);

/// A part of the envelope of a medial axis.
struct EnvelopePiece {
  enum class Kind {
    right,      ///< a side of the envelope
    left,       ///< likewise, backwards: 1 − t for t
    start_cap,  ///< an arc of the first disc
    end_cap     ///< of the last one
  };
  RationalCurve curve;  ///< to the right along the segment, to the left backwards, 1 − t for t
  std::size_t segment = 0;  ///< of the axis
  Kind kind = Kind::right;
};

/// The envelope with all that it has too much: sides and, where segments end or meet at a corner,
/// arcs of the discs there. All go round the domain to the left where s > 0.
struct Envelope {
  MedialAxis axis;
  std::vector<EnvelopePiece> pieces;
  std::vector<std::size_t> behind;  ///< the piece that starts where each one ends, or no_segment
};

/// Segments meet without caps where their ends are one disc that they touch in the same points. One
/// cap is enough of a disc that several segments end at. Throws DomainError for a radius that is
/// negative in [0, 1] or 0 all along, naming the segment.
PHRAME_API Envelope envelope(MedialAxis axis);
/// The pieces in as few paths as possible.
PHRAME_API std::vector<Path> paths(const Envelope& envelope);

}  // namespace phrame
