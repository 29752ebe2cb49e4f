#pragma once
#include <array>

#include "phrame/algebra/real.hpp"
#include "phrame/export.hpp"
#include "phrame/ph/curve/path.hpp"

namespace phrame::inline v0 {

struct CurveSeries;

/// A closed regular curve, which may have corners, with the frame of a vector v, e₂ = v × e₁/|v ×
/// e₁|, which closes with it. From these come all that does not depend on v [Călugăreanu 1961;
/// White 1969; Fuller 1971].
struct ClosedFrame {
  Vector<Rational> v;  ///< nowhere parallel to the tangent
  /// Lk of the curve and its copy shifted along v: the sum of the signs of the crossings that a
  /// projection along v shows, which are proved to be all.
  long linking;
  /// Tw = 1/(2π) ∫ e₂′·e₃, e₃ = e₁ × e₂: turns of the frame about the tangent, at corners against
  /// one that is carried by the least rotation.
  Real twist;
};

/// The v that closed_frame() tries, one after the other.
PHRAME_API const std::array<Vector<Rational>, 9>& writhe_projections();

/// The frame of the first of a few v that decides everything. Throws DomainError where the curve is
/// not closed or has a cusp, unless it is that of a PH curve which does not turn back there;
/// Undecided where no v decides, as where the curve meets itself, and where it is not told whether
/// it is closed. Cost: that of the crossings. The twist is found when it is asked for, along PH
/// curves by a closed form.
PHRAME_API ClosedFrame closed_frame(const Path& path);
/// The frame of this v; no value where that does not decide.
PHRAME_API std::optional<ClosedFrame> closed_frame(const Path& path, const Vector<Rational>& v);

/// The writhe Wr = Lk − Tw, 1/(4π) ∬ det(r′(s), r′(t), r(s) − r(t))/|r(s) − r(t)|³ ds dt.
PHRAME_API Real writhe(const ClosedFrame& frame);
/// The same of a closed curve, 0 where it is plane, also where it crosses itself. Throws as
/// closed_frame().
PHRAME_API Real writhe(const Path& path);
/// The self-linking number Lk − Tw + ∫τ ds/(2π) of a curve without inflections: how often it is
/// linked with its copy shifted along its principal normals. `torsion` is ∫τ ds. Throws Undecided
/// where that is not seen to be an integer.
PHRAME_API long self_linking_number(const ClosedFrame& frame, const Real& torsion);
/// The turn per length about the tangent, −holonomy/length, that is to be added to a
/// rotation-minimizing frame for it to close, so that a profile swept along the curve does.
PHRAME_API Real closing_turn_per_length(const Real& holonomy, const Real& length);

/// The linking number of two closed curves, from the first of a few v that decides. Throws
/// Undecided where none does, as where the curves meet.
PHRAME_API long linking_number(const CurveSeries& first, const CurveSeries& second);
/// The same of paths. Throws DomainError where one of them is not closed, and likewise.
PHRAME_API long linking_number(const Path& first, const Path& second);

}  // namespace phrame
