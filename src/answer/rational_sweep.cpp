#include "phrame/answer/rational_sweep.hpp"

#include "phrame/algebra/error.hpp"
#include "phrame/answer/end_normal.hpp"
#include "phrame/ph/curve/corner.hpp"
#include "phrame/ph/frame/frame.hpp"

namespace phrame::inline v0 {
namespace {

constexpr long coefficient_bits = 64;  ///< of the w of frames of minimal twist

std::vector<RationalFramePiece> twist_frames(const PhPath& path, const RationalSweepQuery& query) {
  const MinimalTwist mtf =
      minimal_twist(PathAngle(path), query.start, end_of_frame(query.end_normal));
  FrameEnds ends{mtf.from().exact.value(), {}};
  if (query.end_normal) ends.to = mtf.to().exact;
  RationalTwistOptions options;
  options.degree = *query.twist_degree;
  if (options.degree < 2) options.rates = EndRates::free;
  options.prove = false;  // whatever w is, the surface is exact
  return rational_mtf(path, twist_frame(mtf, options, {}), ends, coefficient_bits);
}

void require_ends(const PhPath& path, const RationalSweepQuery& query) {
  if (!corners(path).empty())
    throw DomainError(
        "sweep: the path has a corner at t = " + std::to_string(corners(path).front().segment) +
        ": a body with mitres is made as a mesh, not with exact surfaces");
  const bool is_closed = path.closing_turn().has_value();
  require_open(query.end_normal, is_closed);
  if (query.twist_degree && !query.end_normal && !is_closed)
    throw DomainError("sweep: a frame of minimal twist needs an end normal");
  if (is_closed && query.scale(0) != query.scale(path.end()))
    throw DomainError("scale: the path is closed, and the scale differs at its ends");
}

}  // namespace

RationalSweepAnswer answer(const NamedPhPath& named, const RationalSweepQuery& query) {
  const PhPath& path = named.path;
  require_ends(path, query);
  const bool is_rotation_minimizing = !query.twist_degree;
  const auto frames =
      is_rotation_minimizing ? rational_rmf(path, query.start) : twist_frames(path, query);
  if (path.closing_turn() && !is_closed(frames))
    throw DomainError("sweep: the path is closed, and its rotation-minimizing frame is not");
  return {named.name,
          rational_sweep(path, frames, {query.profile, query.scale, is_rotation_minimizing}),
          query.twist_degree, named.near};
}

}  // namespace phrame
