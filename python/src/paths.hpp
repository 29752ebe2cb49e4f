#pragma once
#include "arguments.hpp"
#include "frame_source.hpp"
#include "insides.hpp"
#include "values.hpp"

namespace phrame::inline v0::python {

/// A path as Python has it.
struct PathObject {
  NamedPath named;
  std::optional<NamedPhPath> ph;  ///< the same where all segments are PH curves
  /// What frames were asked for last.
  std::shared_ptr<FrameSources> sources = std::make_shared<FrameSources>();

  explicit PathObject(NamedPath path);
};
using PathClass = nb::class_<PathObject>;

/// make(), for which an argument is not what is asked for where it throws DomainErrors.
template <class Make>
auto at_argument(const std::string& argument, const Make& make) {
  try {
    return without_gil(make);
  } catch (const DomainError& error) {
    throw InputError(argument, without_place(error.what(), argument));
  }
}

nb::object wrap(NamedPath named);
const PathObject& path_of(nb::handle self);
/// The path that an argument is.
const PathObject& path_argument(nb::handle x, std::string_view place);

/// "segments[1] is no Pythagorean-hodograph curve".
std::string why_not_ph(const Path& path);
/// @{ The path of polynomial PH curves, that of PH curves with rational ones among them, the one
/// polynomial PH curve that it is, the one PH curve, which may be rational. Throws DomainError,
/// which names what was asked for, and the segment that is none.
const NamedPhPath& ph_of(const PathObject& path, const char* asked);
NamedPhPath with_preimages_of(const PathObject& path, const char* asked);
const Curve& curve_of(const PathObject& path, const char* asked);
Curve curve_with_preimage_of(const PathObject& path, const char* asked);
/// @}

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
FrameStart frame_start(nb::handle start, nb::handle start_normal, StartRule rule, const Path& path,
                       Reference reference);
/// Are angles to the frame of a vector v: of a path that is not PH, and where that is asked for?
bool is_to_up(const PathObject& path, nb::handle up, nb::handle start);
/// v, where angles are to the frame of one that is given, or of PH curves to one that is chosen as
/// `start` asks for.
std::optional<Vector<Rational>> chosen_up(const PathObject& path, nb::handle up, nb::handle start);
/// The angle to the frame of `up`, or of a vector that is chosen where that is None.
PathAngle angle_to_up(const Path& path, nb::handle up);
/// "erf", "frenet", "up"; of `place`, and "erf" for a PH path only. None is the first that the path
/// has of "erf" and "up".
Reference reference_named(nb::handle name, const char* place, const PathObject& path,
                          nb::handle up);

/// `by`: what numbers are values of.
ParameterKind parameter_kind(const std::string& by);
/// The same points by t, where they are all at fractions of it; no value where they are not.
std::optional<Parameters> by_t(const Parametrization& along, const Parameters& at,
                               std::string_view place);
/// The path by this parameter, which it has.
Parametrization parametrization(const NamedPath& named, ParameterKind by);
/// Where the number that is asked for is, found without Python's lock; `place` names it.
Place place_of(const PathObject& path, const Rational& x, ParameterKind by, const char* place);

/// How an attribute or the answer of a method is pickled: it is asked for again.
nb::object attribute_recipe(nb::handle self, const char* name);
template <class... T>
nb::object method_recipe(nb::handle self, const char* name, T&&... arguments) {
  return nb::make_tuple(imported("operator", "methodcaller")(name, std::forward<T>(arguments)...),
                        nb::make_tuple(self));
}

/// A path in numbers and texts, of which only equal ones have the same; where the letter of a
/// variable is left out, as == does, equal ones have the same.
enum class VariableName { kept, left_out };
nb::object packed_path(const Path& path, VariableName variable = VariableName::kept);
Path unpacked_path(nb::handle packed);
/// @{ The orientations that come with a path; None where there are none.
nb::object packed_frame(const FrameThrough& frame);
std::optional<FrameThrough> unpacked_frame(nb::handle packed);
/// @}
/// NamedPath::parameters: fractions, or None of those of formulas, which have them.
nb::object packed_parameters(const NamedPath& named);
std::vector<Real> unpacked_parameters(nb::handle packed, const Path& path);

/// θ at many parameters, correctly rounded: an array.
nb::object angles(const NamedPath& named, const PathAngle& angle, const StartAngle& start,
                  nb::handle ts, ParameterKind by, nb::handle progress);

/// @{ "x" to "-z"; orientations as quaternions, scalar last, matrices, or a Rotation of SciPy.
TangentAxis tangent_axis(const std::string& name);
std::vector<Orientation> orientations_of(nb::handle given, std::size_t count);
/// @}
/// Frames of least twist: an array (n, 3, 3).
nb::object twist_frames(const PathTwist& twist, nb::handle ts, nb::handle progress);

void bind_constructors(nb::module_& m, PathClass& path);
void bind_any_curves(PathClass& path);
void bind_path_numbers(PathClass& path);
void bind_ph_curve(PathClass& path);
void bind_arrays(PathClass& path);
void bind_products(PathClass& path);
void bind_sweep(nb::module_& m);
void bind_ask(nb::module_& m);

#define PHRAME_START_PARAMETERS \
  argument("start") = nb::none(), argument("start_normal") = nb::none()
#define PHRAME_START_SIG "start: Number | None = None, start_normal: Vector | None = None"
#define PHRAME_BY_SIG "by: str = 't'"
#define PHRAME_UP_SIG "up: Vector | None = None"
#define PHRAME_REAL_SIG "fractions.Fraction | Real"
#define PHRAME_REAL_VECTOR_SIG \
  "tuple[" PHRAME_REAL_SIG ", " PHRAME_REAL_SIG ", " PHRAME_REAL_SIG "]"
#define PHRAME_VECTOR_SIG "tuple[fractions.Fraction, fractions.Fraction, fractions.Fraction]"

}  // namespace phrame::python
