#pragma once
#include <functional>

#include "phrame/algebra/angle.hpp"
#include "phrame/export.hpp"
#include "phrame/ph/curve/frame_through.hpp"
#include "phrame/ph/curve/path.hpp"
#include "phrame/ph/curve/roll.hpp"
#include "phrame/ph/frame/frame_start.hpp"
#include "phrame/ph/sweep/profile.hpp"
#include "phrame/ph/sweep/sweep.hpp"
#include "phrame/ph/sweep/sweep_scale.hpp"

namespace phrame::inline v0 {

/// Asks for the mesh of a body: a profile swept along a path in its rotation-minimizing frame.
struct SweepQuery {
  Profile profile;        ///< x along f₂, y along f₃
  FrameStart start = {};  ///< where the frame starts
  /// v, where the angle at the start is measured from the frame of v, as by angle_to().
  std::optional<Vector<Rational>> up = {};
  /// f₂ at the end, before it is projected to the normal plane: the frame turns to there by the
  /// smallest angle, at a constant rate, as the frame of minimal twist does. A closed path has
  /// none: it turns so that it closes.
  std::optional<Vector<Rational>> end_normal = {};
  /// Orientations that the frame is to have, as PathTwist has them, instead of those of `start` and
  /// `end_normal`.
  std::optional<FrameThrough> through = {};
  Roll roll = {};    ///< by which the profile is turned, too; of a closed path alike at its ends
  Angle twist = {};  ///< a further turn, at a constant rate
  SweepScale scale = {};  ///< λ(t) > 0, by which the profile is scaled
  /// The greatest distance between mesh and surface, or the number of sections.
  std::variant<Rational, long> tolerance_or_sections = 100L;
  /// With a distance: the greatest angle, between 0 and π/2, between the normals of triangles and
  /// those of the surface.
  std::optional<Angle> normal_tolerance = {};
  /// Where the profile stands for a curve: the profile whose sides are within an angle of that
  /// curve. It is swept where there is a tolerance of normals.
  std::function<Profile(const Rational& angle)> profile_within = {};
  /// The origin of the coordinates of the mesh. Without it, a place near the body is taken.
  std::optional<Vector<Rational>> origin = Vector<Rational>{};
  Coordinates numbers = Coordinates::doubles;  ///< what the coordinates are
};

/// The body as a mesh.
struct SweepAnswer {
  SweptBody body;  ///< the mesh, and how near it is
  bool is_closed;  ///< has it no ends?
  double turn;     ///< by which the profile turns about e₁ against the rotation-minimizing frame
};

/// Throws as start_angle() and sweep(), and DomainError for an end normal along the tangent or
/// of a closed path, as PathTwist, for orientations that differ at the ends of a closed path, for a
/// tolerance of normals that is not between 0 and π/2, or beside a number
/// of sections, and for a closed path with a twist that is no multiple of whole turns or a
/// scale that differs at its ends.
PHRAME_API SweepAnswer answer(const NamedPath& named, const SweepQuery& query);

}  // namespace phrame
