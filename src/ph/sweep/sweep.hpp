#pragma once
#include <optional>

#include "phrame/export.hpp"
#include "phrame/ph/sweep/mesh.hpp"

namespace phrame::inline v0 {

struct SweepPath;
struct SweepForm;

/// The mesh of the body that r + λ·(x f₂ + y f₃) bounds, (f₂, f₃) turned as the form says, with
/// caps where the path is not closed.
struct SweptBody {
  /// Watertight, its points apart from each other, each triangle with an area: all is checked of
  /// the numbers that the coordinates are.
  Mesh mesh;
  std::size_t sections = 0;     ///< of the mesh
  std::optional<double> error;  ///< a bound of the distances, where there was a tolerance
  /// A bound of the angles between normals, where there was a tolerance of them: of each triangle
  /// beside the caps to the normals of the part of the surface that it stands for.
  std::optional<double> normal_error;
  /// So many corners of sections lie on the axis of curvature or beyond it, where the body folds
  /// over itself.
  long folds = 0;
};

/// Throws DomainError for λ that is not > 0 all along; Undecided where r′ is not told from 0, as
/// where the curve turns back in a cusp, where normals are asked for and the body folds over
/// itself, where more than 20 million points would be needed, and where the body is so small beside
/// its distance to the origin that its coordinates, rounded, are not within the tolerance, or not
/// those of a body; DomainError where the error of the profile is not below half of the tolerance,
/// or its angle that of the normals, and for less than 3 sections of a closed path or 2 of another.
PHRAME_API SweptBody sweep(const SweepPath& path, const SweepForm& form);

/// Beside a side of the profile at an angle to the curve for which it stands normals of the surface
/// differ by so many times that angle, about, where the profile turns or grows: by some sections.
/// At most 100.
PHRAME_API double side_angle_factor(const SweepPath& path, const SweepForm& form);

}  // namespace phrame
