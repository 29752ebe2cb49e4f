#include <nanobind/ndarray.h>

#include "answers.hpp"
#include "arrays.hpp"

namespace phrame::inline v0::python {
namespace {

/// A mesh with what is known of it; arrays share its numbers.
struct SweepObject {
  std::shared_ptr<const SweepAnswer> found;
};

RationalFunction scale_of(nb::handle scale) {
  if (nb::isinstance<RationalFunction>(scale)) return nb::cast<const RationalFunction&>(scale);
  if (nb::isinstance<Polynomial>(scale))
    return RationalFunction(nb::cast<const Polynomial&>(scale));
  if (PyUnicode_Check(scale.ptr()) == 0)
    return RationalFunction(Polynomial{rational(scale, "scale")});
  try {
    return parse_expression(text(scale, "scale"), "t").value;
  } catch (const InputError& error) {
    refuse("scale", error.what(), scale);
  }
}

/// The same, or a list of the values at the joints.
SweepScale sweep_scale_of(nb::handle scale) {
  if (PyUnicode_Check(scale.ptr()) != 0 || PySequence_Check(scale.ptr()) == 0)
    return scale_of(scale);
  std::vector<Rational> values;
  for (const nb::handle value : scale) values.push_back(rational(value, "scale"));
  if (values.size() < 2) refuse("scale", "of a list there are two values at least", scale);
  return SweepScale(values);
}

Profile polygon_of(nb::handle corners) {
  std::vector<ProfilePoint> points;
  for (const nb::handle row :
       rows(corners, "profile", "a str, a file or a list of corners", {"x", "y"})) {
    const std::string place = "profile[" + std::to_string(points.size()) + "]";
    const auto numbers = rationals(row, place);
    if (numbers.size() != 2)
      refuse(place, "2 numbers are wanted, there are " + std::to_string(numbers.size()), row);
    points.push_back({numbers[0], numbers[1]});
  }
  return Profile(std::move(points));
}

/// What f returns; what it says of the profile names the argument.
template <class F>
auto of_profile(nb::handle profile, F f) {
  try {
    return f();
  } catch (const InputError& error) {
    refuse("profile", error.what(), profile);
  } catch (const DomainError& error) {
    refuse("profile", error.what(), profile);
  }
}

/// The profile with any tolerance, which needs no Python.
using ProfileSource = std::function<Profile(const ProfileTolerance&)>;

ProfileSource profile_source(nb::handle profile) {
  if (PyUnicode_Check(profile.ptr()) != 0) {
    const auto words = text(profile, "profile");
    if (!parse_profile(words))
      refuse("profile",
             "\"" + abbreviated(words) +
                 "\" is none of circle:R, polygon:N,R and rectangle:W,H; a file is a Path of "
                 "pathlib",
             profile);
    return [words](const ProfileTolerance& tolerance) { return *parse_profile(words, tolerance); };
  }
  if (nb::hasattr(profile, "__fspath__"))
    return [bytes = bytes_of_file(profile, "profile")](const ProfileTolerance& tolerance) {
      return read_profile(bytes, tolerance);
    };
  return [polygon = polygon_of(profile)](const ProfileTolerance&) { return polygon; };
}

/// Between 0 and 90°.
std::optional<Angle> normal_angle(nb::handle tolerance) {
  if (tolerance.is_none()) return std::nullopt;
  const Angle angle = angle_number(tolerance, "normal_tolerance");
  const double radians = round_to_double(to_real(FrameAngle(angle)));
  if (!(radians > 0 && radians <= 1.57))
    refuse("normal_tolerance", "it is not between 0 and 90deg", tolerance);
  return angle;
}

/// No value for "auto".
std::optional<Vector<Rational>> origin_of(nb::handle origin) {
  if (origin.is_none()) return Vector<Rational>{};
  if (PyUnicode_Check(origin.ptr()) == 0) return vector(origin, "origin");
  if (text(origin, "origin") != "auto")
    refuse("origin", "a str that is not \"auto\" is no place", origin);
  return std::nullopt;
}

nb::object sweep_path(nb::handle given, nb::handle profile, nb::handle start,
                      nb::handle start_normal, nb::handle end_normal, nb::handle twist,
                      nb::handle scale, nb::handle roll, nb::handle tolerance,
                      nb::handle normal_tolerance, nb::handle sections, nb::handle origin) {
  const PathObject& path = path_argument(given, "path");
  const SweepScale size = sweep_scale_of(scale);
  const std::size_t segments = path.named.path.segments().size();
  double greatest = 1;
  try {
    greatest = size.greatest(segments);
  } catch (const DomainError& error) {
    refuse("scale", error.what(), scale);
  }
  if (!tolerance.is_none() && !sections.is_none())
    refuse("sections", "it and tolerance exclude each other", sections);
  if (!normal_tolerance.is_none() && !sections.is_none())
    refuse("sections", "it and normal_tolerance exclude each other", sections);
  std::optional<Rational> within;
  if (!tolerance.is_none()) {
    within = rational(tolerance, "tolerance");
    if (*within <= 0) refuse("tolerance", "it is not positive", tolerance);
  }
  ProfileTolerance fine;
  if (within) fine.distance = *within / (4 * exact_rational(greatest));
  const ProfileSource source = of_profile(profile, [&] { return profile_source(profile); });
  const auto up = chosen_up(path, nb::none(), start);
  SweepQuery query{of_profile(profile, [&] { return source(fine); }),
                   frame_start(start, start_normal, StartRule::least_rotation, path.named.path,
                               reference_of(path.named.path, up)),
                   up};
  query.scale = size;
  query.twist = angle_number(twist, "twist");
  query.roll = roll_of(roll, segments);
  query.origin = origin_of(origin);
  if (!end_normal.is_none()) query.end_normal = vector(end_normal, "end_normal");
  if (path.named.frame && start.is_none() && start_normal.is_none() && end_normal.is_none())
    query.through = path.named.frame;
  query.normal_tolerance = normal_angle(normal_tolerance);
  query.profile_within = [source, distance = fine.distance](const Rational& angle) {
    return source({distance, angle});
  };
  if (!sections.is_none())
    query.tolerance_or_sections = count(sections, "sections", 2, 1'000'000);
  else
    query.tolerance_or_sections =
        within ? *within : exact_rational(query.profile.reach() * greatest / 200);
  return nb::cast(
      SweepObject{std::make_shared<const SweepAnswer>(without_gil([named = path.named, query] {
        SweepAnswer found = answer(named, query);
        found.body.mesh.remark = sweep_remark(query);
        return found;
      }))});
}

/// Rows of three numbers, which nobody may write to.
template <class T>
nb::object rows_of(const SweepObject& self, const T* numbers, std::size_t rows) {
  using Owner = std::shared_ptr<const SweepAnswer>;
  const nb::capsule owner(new Owner(self.found),
                          [](void* p) noexcept { delete static_cast<Owner*>(p); });
  const std::array<std::size_t, 2> shape{rows, 3};
  return nb::cast(nb::ndarray<nb::numpy, const T>(numbers, 2, shape.data(), owner));
}

nb::object points_of(const SweepObject& self) {
  const auto& points = self.found->body.mesh.points;
  return rows_of(self, points.empty() ? nullptr : points.front().data(), points.size());
}

nb::object triangles_of(const SweepObject& self) {
  const auto& triangles = self.found->body.mesh.triangles;
  return rows_of(self, triangles.empty() ? nullptr : triangles.front().data(), triangles.size());
}

nb::object save(const SweepObject& self, nb::handle file) {
  const nb::object path = imported("pathlib", "Path")(file_name(file, "file"));
  const auto suffix = nb::cast<std::string>(path.attr("suffix").attr("lower")());
  using Writer = std::string (*)(const Mesh&);
  const auto writer = [&]() -> Writer {
    for (const auto& [name, found] : std::initializer_list<std::pair<const char*, Writer>>{
             {".obj", to_obj}, {".stl", to_stl}, {".ply", to_ply}, {".glb", to_glb}})
      if (suffix == name) return found;
    refuse("file", "its name ends with none of .obj, .stl, .ply, .glb", file);
  }();
  double error = self.found->body.error.value_or(0);
  const std::string bytes = without_gil([&error, suffix, writer, found = self.found] {
    const Mesh& mesh = found->body.mesh;
    if (suffix == ".obj" || suffix == ".ply") return writer(mesh);
    const MeshInFloats written =
        in_floats(mesh, suffix == ".glb" ? node_origin(mesh) : mesh.origin);
    require_apart(written.mesh, Coordinates::floats);
    error = std::nextafter(error + written.error, HUGE_VAL);
    return writer(written.mesh);
  });
  write_file(file, "file", bytes);
  return self.found->body.error ? nb::cast(error) : nb::none();
}

/// What was pickled.
nb::object swept(const nb::ndarray<const double, nb::ndim<2>, nb::c_contig>& points,
                 const nb::ndarray<const std::uint32_t, nb::ndim<2>, nb::c_contig>& triangles,
                 nb::handle origin, const std::string& remark, std::size_t sections,
                 std::optional<double> error, std::optional<double> normal_error, long folds,
                 bool is_closed, double turn) {
  SweepAnswer found{{}, is_closed, turn};
  Mesh& mesh = found.body.mesh;
  for (std::size_t k = 0; k < points.shape(0); ++k)
    mesh.points.push_back({points(k, 0), points(k, 1), points(k, 2)});
  for (std::size_t k = 0; k < triangles.shape(0); ++k)
    mesh.triangles.push_back({triangles(k, 0), triangles(k, 1), triangles(k, 2)});
  mesh.origin = vector(origin, "origin");
  mesh.remark = remark;
  found.body.sections = sections;
  found.body.error = error;
  found.body.normal_error = normal_error;
  found.body.folds = folds;
  return nb::cast(SweepObject{std::make_shared<const SweepAnswer>(std::move(found))});
}

}  // namespace

void bind_sweep(nb::module_& m) {
  m.def("_swept", swept, nb::arg(), nb::arg(), nb::arg(), nb::arg(), nb::arg(), nb::arg().none(),
        nb::arg().none(), nb::arg(), nb::arg(), nb::arg());
  m.def("sweep", sweep_path, argument("path"), argument("profile"), nb::kw_only(),
        PHRAME_START_PARAMETERS, argument("end_normal") = nb::none(), argument("twist") = 0,
        argument("scale") = 1, argument("roll") = nb::none(), argument("tolerance") = nb::none(),
        argument("normal_tolerance") = nb::none(), argument("sections") = nb::none(),
        argument("origin") = nb::none(),
        nb::sig(
            "def sweep(path: Path, profile: str | os.PathLike[str] | Vectors, *, " PHRAME_START_SIG
            ", end_normal: Vector | None = None, twist: Number = 0, scale: Number | Polynomial | "
            "Numbers "
            "| RationalFunction = 1, " PHRAME_ROLL
            ", tolerance: Number | None = None, normal_tolerance: Number | "
            "None = None, sections: int | None = None, origin: Vector | str | None = None) -> "
            "SweptBody"),
        "A body: a profile (\"circle:R\", \"polygon:N,R\", \"rectangle:W,H\", corners, or a file "
        "as a pathlib.Path) swept along a path in its rotation-minimizing frame: docs/sweep.md.");
  auto type = nb::class_<SweepObject>(m, "SweptBody", "A body as a watertight mesh.");
  using S = SweepObject;
  type.def_prop_ro("vertices", points_of,
                   nb::sig("def vertices(self) -> numpy.typing.NDArray[numpy.float64]"),
                   "Points, an array (n, 3), from the origin.")
      .def_prop_ro(
          "origin",
          [](const S& s) {
            const auto& origin = s.found->body.mesh.origin;
            return to_python(std::vector<Rational>(origin.begin(), origin.end()));
          },
          nb::sig("def origin(self) -> tuple[fractions.Fraction, fractions.Fraction, "
                  "fractions.Fraction]"),
          "From where the coordinates are: 0, or as asked, \"auto\" for a place near the body.")
      .def_prop_ro("triangles", triangles_of,
                   nb::sig("def triangles(self) -> numpy.typing.NDArray[numpy.uint32]"),
                   "The numbers of three points each, counterclockwise seen from outside: an "
                   "array (m, 3).")
      .def_prop_ro(
          "sections", [](const S& s) { return s.found->body.sections; }, "How many there are.")
      .def_prop_ro(
          "error", [](const S& s) { return s.found->body.error; },
          "A proved bound of the distance of mesh and surface; None with `sections`.")
      .def_prop_ro(
          "normal_error", [](const S& s) { return s.found->body.normal_error; },
          "A proved bound of the angle, in radians, of a triangle to the surface it stands for; "
          "None without `normal_tolerance`.")
      .def_prop_ro(
          "folds", [](const S& s) { return s.found->body.folds; },
          "Corners of sections at which the body folds over itself.")
      .def_prop_ro(
          "is_closed", [](const S& s) { return s.found->is_closed; }, "Has it no ends?")
      .def_prop_ro(
          "turn", [](const S& s) { return s.found->turn; },
          "By how many radians the profile turns against the rotation-minimizing frame.")
      .def(
          "volume", [](const S& s) { return volume(s.found->body.mesh); }, "Of the mesh.")
      .def(
          "save", save, argument("file"),
          nb::sig("def save(self, file: str | os.PathLike[str]) -> float | None"),
          "Writes a file whose name ends with .obj, .stl, .ply or .glb. Returns what `error` is of "
          "the numbers in it, which are floats in .stl and .glb. Raises Undecided where floats are "
          "those of no body.")
      .def("__repr__",
           [](const S& s) {
             const Mesh& mesh = s.found->body.mesh;
             return "<SweptBody of " + std::to_string(mesh.points.size()) + " points, " +
                    std::to_string(mesh.triangles.size()) + " triangles" +
                    (s.found->is_closed ? ", closed>" : ">");
           })
      .def(
          "__reduce__",
          [](const S& s) {
            const SweptBody& body = s.found->body;
            const auto& origin = body.mesh.origin;
            return remade("_swept", points_of(s), triangles_of(s),
                          to_python(std::vector<Rational>(origin.begin(), origin.end())),
                          body.mesh.remark, body.sections, nb::cast(body.error),
                          nb::cast(body.normal_error), body.folds, s.found->is_closed,
                          s.found->turn);
          },
          PHRAME_REDUCE_SIG);
  bind_python(type, "plot", "phrame._plot", "body",
              "def plot(self, *, ax: typing.Any = None, **style: typing.Any) -> typing.Any",
              "The mesh in space, by Matplotlib's plot_trisurf; the axes.");
  bind_python(type, "_repr_html_", "phrame._show", "body_html", "def _repr_html_(self) -> str");
  bind_copies(type);
}

}  // namespace phrame::python
