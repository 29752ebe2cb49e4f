#include "phrame/answer/rational_sweep.hpp"

#include "phrame/algebra/error.hpp"
#include "phrame/answer/end_normal.hpp"
#include "phrame/ph/curve/tangent_path.hpp"
#include "phrame/ph/frame/frame.hpp"

namespace phrame::inline v0 {
namespace {

constexpr long coefficient_bits = 64;  ///< of the w of frames of minimal twist

std::vector<RationalFramePiece> twist_frames(const Path& path, const RationalSweepQuery& query) {
  const auto ph = path.ph();
  if (!ph)
    throw DomainError(
        "sweep: the path is not PH: of rational frames it has the rotation-minimizing one, and "
        "none of minimal twist");
  const MinimalTwist mtf =
      minimal_twist(PathAngle(path), query.start, end_of_frame(query.end_normal));
  FrameEnds ends{mtf.from().exact.value(), {}};
  if (query.end_normal) ends.to = mtf.to().exact;
  RationalTwistOptions options;
  options.degree = *query.twist_degree;
  if (options.degree < 2) options.rates = EndRates::free;
  options.prove = false;  // whatever w is, the surface is exact
  return rational_mtf(*ph, twist_frame(mtf, options, {}), ends, coefficient_bits);
}

void require_ends(const Path& path, bool is_closed, const RationalSweepQuery& query) {
  if (!path.corners().empty())
    throw DomainError(
        "sweep: the path has a corner at t = " + std::to_string(path.corners().front()) +
        ": a body with mitres is made as a mesh, not with exact surfaces");
  require_open(query.end_normal, is_closed);
  if (query.twist_degree && !query.end_normal && !is_closed)
    throw DomainError("sweep: a frame of minimal twist needs an end normal");
  if (is_closed && query.scale(0) != query.scale(path.end()))
    throw DomainError("scale: the path is closed, and the scale differs at its ends");
}

/// Of a path that is not PH, a PH path with its tangents has them.
std::vector<RationalFramePiece> rotation_minimizing_frames(const Path& path,
                                                           const FrameStart& start) {
  if (const auto ph = path.ph()) return rational_rmf(*ph, start);
  if (std::holds_alternative<Angle>(start))
    throw DomainError("sweep: the path is not PH, and has no Euler-Rodrigues frame to start from");
  return rational_rmf(path_with_tangents(path), start);
}

}  // namespace

RationalSweepAnswer answer(const NamedPath& named, const RationalSweepQuery& query) {
  const Path& path = named.path;
  const bool is_path_closed = path.is_closed();
  require_ends(path, is_path_closed, query);
  const bool is_rotation_minimizing = !query.twist_degree;
  const auto frames = is_rotation_minimizing ? rotation_minimizing_frames(path, query.start)
                                             : twist_frames(path, query);
  if (is_path_closed && !is_closed(frames))
    throw DomainError(
        path.closes_at_corner()
            ? "sweep: the path is closed at a corner: a body with mitres is made as a "
              "mesh, not with exact surfaces"
            : "sweep: the path is closed, and its rotation-minimizing frame is not");
  return {named.name,
          rational_sweep(path, frames, {query.profile, query.scale, is_rotation_minimizing}),
          query.twist_degree, named.near};
}

}  // namespace phrame
