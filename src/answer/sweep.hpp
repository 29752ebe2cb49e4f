#pragma once
#include <functional>

#include "phrame/algebra/angle.hpp"
#include "phrame/export.hpp"
#include "phrame/ph/curve/path.hpp"
#include "phrame/ph/frame/frame_start.hpp"
#include "phrame/ph/sweep/profile.hpp"
#include "phrame/ph/sweep/sweep.hpp"
#include "phrame/ph/sweep/sweep_scale.hpp"

namespace phrame {

/// A body: a profile swept along a path in its rotation-minimizing frame.
struct SweepQuery {
  Profile profile;        ///< x along f₂, y along f₃
  FrameStart start = {};  ///< where the frame starts
  /// v, where an angle at the start is one to its frame, as angle_to() has it.
  std::optional<Vector<Rational>> up = {};
  /// f₂ at the end, once it is projected to the normal plane, to which the frame turns by the
  /// smallest angle at a constant rate: the frame of minimal twist. Not of a closed path, which
  /// turns so that it closes.
  std::optional<Vector<Rational>> end_normal = {};
  Angle twist = {};       ///< by which it turns beyond that
  SweepScale scale = {};  ///< λ(t) > 0: the profile is so many times as large
  /// A distance between mesh and surface, or the number of sections.
  std::variant<Rational, long> tolerance_or_sections = 100L;
  /// With a tolerance: between 0 and π/2, and normals of triangles are as near to those of the
  /// surface.
  std::optional<Angle> normal_tolerance = {};
  /// The profile with sides within an angle of the curve that it stands for, if it does: what is
  /// swept where normals have a tolerance.
  std::function<Profile(const Rational& angle)> profile_within = {};
  /// From where the coordinates of the mesh are; near the body where there is none.
  std::optional<Vector<Rational>> origin = Vector<Rational>{};
  Coordinates numbers = Coordinates::doubles;  ///< that the coordinates are
};

/// The body as a mesh.
struct SweepAnswer {
  SweptBody body;  ///< the mesh, and how near it is
  bool is_closed;  ///< has it no ends?
  double turn;     ///< by which the profile turns about e₁ against the rotation-minimizing frame
};

/// Throws as start_angle() and sweep(), and DomainError for an end normal along the tangent or
/// of a closed path, for a tolerance of normals that is not between 0 and π/2, or beside a number
/// of sections, and for a closed path with a twist that is no multiple of whole turns or a
/// scale that differs at its ends.
PHRAME_API SweepAnswer answer(const NamedPath& named, const SweepQuery& query);

}  // namespace phrame
