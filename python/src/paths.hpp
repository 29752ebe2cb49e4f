#pragma once
#include "arguments.hpp"
#include "frame_source.hpp"
#include "phrame/phrame.hpp"
#include "values.hpp"

namespace phrame::python {

/// A path as Python has it; a curve is one of a single segment, and of a type derived from it.
struct PathObject {
  NamedPhPath named;
  std::shared_ptr<FrameSources> sources = std::make_shared<FrameSources>();
};
struct CurveObject : PathObject {};

/// A Curve where it is one, else a Path.
nb::object wrap(NamedPhPath named);
const Curve& curve_of(const PathObject& path);

/// Where f₂ starts without `start_normal`, and what an angle `start` is counted from.
enum class StartRule {
  least_rotation,  ///< of frames
  reference,       ///< of angles: the frame that they are measured from
};
/// `start`, an angle, "least", "erf", "up" or "frenet", or one of these and an angle, as
/// "erf+pi/4"; or `start_normal`, a vector; or neither. `reference` is the name of the frame that
/// angles are measured from.
FrameStart asked_start(nb::handle start, nb::handle start_normal, StartRule rule,
                       const std::string& reference);
/// The same where it is a start of this path's frames.
FrameStart frame_start(nb::handle start, nb::handle start_normal, StartRule rule,
                       const PhPath& path, Reference reference = Reference::euler_rodrigues);
/// "erf", "frenet".
Reference reference_named(const std::string& name, const std::string& place);

/// How an attribute or the answer of a method is pickled: it is asked for again.
nb::object attribute_recipe(nb::handle self, const char* name);
template <class... T>
nb::object method_recipe(nb::handle self, const char* name, T&&... arguments) {
  return nb::make_tuple(imported("operator", "methodcaller")(name, std::forward<T>(arguments)...),
                        nb::make_tuple(self));
}

/// What curves and paths are made by; what they are asked for many parameters.
void bind_constructors(nb::class_<PathObject>& path, nb::class_<CurveObject, PathObject>& curve);
void bind_arrays(nb::class_<PathObject>& path);

/// θ at many parameters, correctly rounded: an array.
nb::object angles(const PathAngle& angle, const FrameAngle& start, nb::handle ts,
                  nb::handle progress);

#define PHRAME_START_PARAMETERS \
  argument("start") = nb::none(), argument("start_normal") = nb::none()
#define PHRAME_START_SIG "start: Number | None = None, start_normal: Vector | None = None"

}  // namespace phrame::python
