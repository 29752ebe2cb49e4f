#pragma once
#include "phrame/algebra/rational_function.hpp"
#include "phrame/ph/curve/path.hpp"
#include "phrame/ph/sweep/profile_curve.hpp"
#include "phrame/ph/sweep/rational_frame_piece.hpp"
#include "phrame/ph/sweep/rational_surface.hpp"

namespace phrame::inline v0 {

/// How a profile is swept exactly, along a path with a rational frame.
struct RationalSweepForm {
  ProfileCurve profile;  ///< x along f₂, y along f₃
  /// The profile is λ(t) times as large there, λ > 0 on the path.
  RationalFunction scale{Polynomial{1}};
  bool is_rotation_minimizing = true;  ///< is the frame? Then that is checked, too
};

/// The surface r + λ·(x f₂ + y f₃), exactly: of r = R/W, a preimage B of the frame, N = |B|², λ =
/// P/Q and a piece (X, Y)/V of the profile it is
///   (R·NQV + WP·(X·BjB* + Y·BkB*))/(WNQV).
/// A part of the path is halved until all weights are > 0. Of the control points that are returned
/// these identities are checked: S − r is normal to r′ and has the length λ√(x² + y²), and S − r
/// over λ turns about no tangent, ∂ₛ((S − r)/λ) ∥ r′, where the frame is rotation-minimizing;
/// patches meet exactly. Throws DomainError for λ that is not > 0 all along, where r′ = 0 on the
/// path, and for segments of formulas. Cost: quadratic in the degree, for each patch.
RationalSurface rational_sweep(const Path& path, const std::vector<RationalFramePiece>& frames,
                               const RationalSweepForm& form);

}  // namespace phrame
