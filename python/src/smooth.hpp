#pragma once
#include "arrays.hpp"
#include "paths.hpp"

namespace phrame::python {

class SmoothSource;

/// What frames of a path of any kind are asked for: where they start, by their kind.
struct SmoothFrames {
  std::string kind;
  FrameStart start;
  std::optional<Vector<Rational>> up;
  bool is_by_length = false;
  friend bool operator==(const SmoothFrames&, const SmoothFrames&) = default;
};

/// A path of curves of any kind as Python has it.
struct SmoothPathObject {
  using Sources = LastSources<SmoothSource, SmoothFrames>;

  NamedPath named;
  std::shared_ptr<Sources> sources = std::make_shared<Sources>();
};

/// A Curve or Path where it is of PH curves, else a SmoothPath.
nb::object wrap(AnyPath found);
/// Of a Path or a SmoothPath.
AnyPath any_path(nb::handle x, const std::string& place);

/// The angle to the frame of `up`, or of a vector that is chosen where that is None.
SmoothAngle angle_to_up(const Path& path, nb::handle up);
/// Where a frame starts, as frame_start() has it, at an angle to the frame of the angle.
FrameStart smooth_start(nb::handle start, nb::handle start_normal, StartRule rule,
                        const SmoothAngle& angle);

void bind_any_curves(nb::module_& m, nb::class_<CurveObject, PathObject>& curve);
void bind_smooth_path(nb::module_& m, nb::class_<SmoothPathObject>& smooth);
void bind_smooth_arrays(nb::class_<SmoothPathObject>& smooth);
void bind_smooth_angle(nb::module_& m, nb::class_<SmoothPathObject>& smooth);
void bind_smooth_check(nb::class_<SmoothPathObject>& smooth);
void bind_smooth_twist(nb::class_<SmoothPathObject>& smooth);
void bind_products(nb::class_<PathObject>& path, nb::class_<SmoothPathObject>& smooth);
void bind_sweep(nb::module_& m);

/// θ as correctly rounded doubles at many parameters.
nb::object smooth_angles(const SmoothAngle& angle, const Real& start, nb::handle ts,
                         nb::handle progress);

#define PHRAME_ANY_PATH_SIG "Path | SmoothPath"
#define PHRAME_REAL_SIG "fractions.Fraction | Real"

}  // namespace phrame::python
