#pragma once
#include "phrame/export.hpp"
#include "phrame/ph/along/path_angle.hpp"
#include "phrame/ph/frame/frame_start.hpp"

namespace phrame::inline v0 {

// Frames of a path of any kind. e₁ is along H, at a cusp, too. Components that are rational are
// exact where t is, and where it is algebraic those of e₁, of the Euler–Rodrigues and the Frenet
// frame of a PH curve, too; what is irrational there is known to be. Of a rotation-minimizing frame
// more is exact where its angle to the Euler–Rodrigues frame is the argument of a rational number,
// and of the rest nothing is known.

/// H/|H| and, for an n normal to it, n/|n| and H × n/|H × n|.
PHRAME_API Frame<Real> frame_along(const Vector<Real>& H, const Vector<Real>& n);
/// e₁.
PHRAME_API Vector<Real> tangent(const Path& path, const Place& at);
/// (e₁, e₂, e₃) with e₂ = v × H/|v × H|. v is nowhere along the tangent.
PHRAME_API Frame<Real> up_frame(const Path& path, const Vector<Rational>& up, const Place& at);
/// (e₁, e₂, e₃) of Euler and Rodrigues: that of the preimage of a segment that is a PH curve.
/// Throws DomainError on others.
PHRAME_API Frame<Real> euler_rodrigues_frame(const Path& path, const Place& at);
/// (e₁, n, b). Throws DomainError at an inflection and on a straight line.
PHRAME_API Frame<Real> frenet_frame(const Path& path, const Place& at);

/// @{ The frame that the angle is measured from, and a vector along its e₂, which is exact where
/// that of the path is. They throw as the frame does.
PHRAME_API Frame<Real> reference_frame(const PathAngle& angle, const Place& at);
PHRAME_API Vector<Real> second_axis(const PathAngle& angle, const Place& at);
/// @}

/// The angle from the reference frame to the f₂ that `start` asks for, at t = 0 or at another
/// place. That to a vector is in (−π, π]. It is exact at rational t of PH curves; measured from a
/// Frenet frame, at the start of the path only. Throws DomainError for a vector that is 0 or along
/// the tangent. Measured from the Frenet frame, it throws at an inflection, too, unless that is the
/// start of a PH curve.
PHRAME_API StartAngle start_angle(const FrameStart& start, const PathAngle& angle,
                                  const Place& at = {0, Rational(0)});
/// The angle at the end of a closed path for a frame that ends as it starts, which is at the angle
/// `start`; whole turns are not counted. Throws DomainError where the path is not closed with its
/// e₁.
PHRAME_API StartAngle closing_angle(const StartAngle& start, const PathAngle& angle);
/// Throws DomainError where the vector has no part across the tangent, at the start of the path or
/// at another place.
PHRAME_API void require_start_normal(const StartNormal& start, const Path& path,
                                     const Place& at = {0, Rational(0)});

/// @{ The rotation-minimizing frame that starts at this angle to the reference frame. On PH curves
/// it is exact at rational t if the angle and the start each have a direction(): so on plane curves
/// and all others with a rational rotation-minimizing frame. The reference frame at the place is
/// found, or given.
PHRAME_API Frame<Real> rotation_minimizing_frame(const PathAngle& angle, const Place& at,
                                                 const StartAngle& start = {});
PHRAME_API Frame<Real> rotation_minimizing_frame(const PathAngle& angle, const Place& at,
                                                 const StartAngle& start,
                                                 const Frame<Real>& reference);
/// @}

}  // namespace phrame
