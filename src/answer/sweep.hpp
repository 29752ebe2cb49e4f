#pragma once
#include "phrame/algebra/angle.hpp"
#include "phrame/ph/frame/frame_start.hpp"
#include "phrame/ph/smooth/smooth_path.hpp"
#include "phrame/ph/sweep/sweep.hpp"

namespace phrame {

/// A body: a profile swept along a path in its rotation-minimizing frame.
struct SweepQuery {
  Profile profile;             ///< x along f₂, y along f₃
  FrameStart start = Angle();  ///< where the frame starts
  /// f₂ at the end, once it is projected to the normal plane, to which the frame turns by the
  /// smallest angle at a constant rate: the frame of minimal twist. Not of a closed path, which
  /// turns so that it closes.
  std::optional<Vector<Rational>> end_normal = {};
  Angle twist = {};                       ///< by which it turns beyond that
  RationalFunction scale{Polynomial{1}};  ///< λ(t) > 0: the profile is so many times as large
  /// A distance between mesh and surface, or the number of sections.
  std::variant<Rational, long> tolerance_or_sections = 100L;
};

/// The body as a mesh.
struct SweepAnswer {
  SweptBody body;  ///< the mesh, and how near it is
  bool is_closed;  ///< has it no ends?
  double turn;     ///< by which the profile turns about e₁ against the rotation-minimizing frame
};

/// @{ Throws as start_angle() and sweep(), and DomainError for an end normal along the tangent or
/// of a closed path, and for a closed path with a twist that is no multiple of whole turns or a
/// scale that differs at its ends.
SweepAnswer answer(const NamedPath& named, const SweepQuery& query);
SweepAnswer answer(const NamedSmoothPath& named, const SweepQuery& query);
/// @}

}  // namespace phrame
