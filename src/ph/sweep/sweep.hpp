#pragma once
#include <optional>
#include <variant>

#include "phrame/algebra/rational_function.hpp"
#include "phrame/ph/frame/compiled_frame.hpp"
#include "phrame/ph/smooth/curve_series.hpp"
#include "phrame/ph/sweep/mesh.hpp"
#include "phrame/ph/sweep/profile.hpp"

namespace phrame {

/// A path with its rotation-minimizing frame, as a sweep sees it.
struct SweepPath {
  CurveSeries series;      ///< the path, of PH curves or of any kind
  CompiledFrames frames;   ///< on [0, the number of segments]
  bool is_closed = false;  ///< with its tangent, so that it needs no caps?
};

/// How a profile is swept.
struct SweepForm {
  Profile profile;  ///< what is swept
  /// The profile is λ(t) times as large there, λ > 0 on the path.
  RationalFunction scale{Polynomial{1}};
  /// The profile turns by so many radians against the frame, at a constant rate per length.
  double turn = 0;
  /// No point of the surface is farther from that of the mesh, and conversely; or so many sections,
  /// at equal steps of t.
  std::variant<Rational, long> tolerance_or_sections;
};

/// The mesh of the body that r + λ·(x f₂ + y f₃) bounds, (f₂, f₃) turned as the form says, with
/// caps where the path is not closed.
struct SweptBody {
  Mesh mesh;                    ///< watertight, each triangle with an area: both are checked
  std::size_t sections = 0;     ///< of the mesh
  std::optional<double> error;  ///< a bound of the distances, where there was a tolerance
  /// So many corners of sections lie on the axis of curvature or beyond it, where the body folds
  /// over itself.
  long folds = 0;
};

/// Throws DomainError for λ that is not > 0 all along; Undecided where r′ is not told from 0, as at
/// a cusp, and where more than 20 million points would be needed; DomainError where the error of
/// the profile is not below half of the tolerance, for less than 3 sections of a closed path or 2
/// of another, and where the body is so small beside its place that a triangle has no area in
/// doubles.
SweptBody sweep(const SweepPath& path, const SweepForm& form);

/// A bound of λ on [0, end], > 0. Throws DomainError for λ that is not > 0 all along.
double greatest_scale(const RationalFunction& scale, std::size_t segments);

}  // namespace phrame
