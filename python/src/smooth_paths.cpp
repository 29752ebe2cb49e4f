#include <limits>

#include "answers.hpp"
#include "smooth.hpp"

namespace phrame::python {
namespace {

const Path& smooth_of(nb::handle self) {
  return nb::cast<const SmoothPathObject&>(self).named.path;
}

/// A vector of which the components are pickled as those of what the method answers.
nb::object components(const Vector<Real>& v, nb::handle self, const char* method, nb::handle t) {
  const auto component = [&](long k) {
    return to_python(v[static_cast<std::size_t>(k)],
                     recipe(imported("phrame._pickle", "component"), self, nb::str(method), t, k));
  };
  return nb::make_tuple(component(0), component(1), component(2));
}

nb::object smooth_point(nb::handle self, nb::handle t) {
  const Rational at = rational(t, "t");
  const Path& path = smooth_of(self);
  return components(
      at_place(
          "t",
          [&] { return without_gil([path, at] { return position(path, locate(path, at)); }); }),
      self, "point", to_python(at));
}

nb::object parameter_at(nb::handle self, nb::handle s) {
  const Rational length = rational(s, "s");
  const Path& path = smooth_of(self);
  const Place at = at_place("s", [&] {
    return without_gil([path, length] { return SmoothLength(path).point(length); });
  });
  return to_python(Rational(static_cast<long>(at.segment)) + at.t,
                   method_recipe(self, "parameter_at", to_python(length)));
}

void bind_smooth_totals(nb::class_<SmoothPathObject>& smooth) {
#define PHRAME_SMOOTH_TOTAL(name, of, what)                                                 \
  smooth.def_prop_ro(                                                                       \
      name,                                                                                 \
      [](nb::handle self) {                                                                 \
        const Path& path = smooth_of(self);                                                 \
        return to_python(without_gil([path] { return of; }), attribute_recipe(self, name)); \
      },                                                                                    \
      nb::sig("def " name "(self) -> " PHRAME_REAL_SIG), what)
  PHRAME_SMOOTH_TOTAL("length", SmoothLength(path).total(), "∫ ds.");
  PHRAME_SMOOTH_TOTAL("total_curvature", total_curvature(path), "∫ κ ds.");
  PHRAME_SMOOTH_TOTAL("total_torsion", total_torsion(path), "∫ τ ds.");
  PHRAME_SMOOTH_TOTAL("up_twist", up_frame_twist(SmoothAngle(path)),
                      "∫ e2′·e3 dt: how far the frame of `up` turns about e1, in radians.");
#undef PHRAME_SMOOTH_TOTAL
#define PHRAME_SMOOTH_ENERGY(name, of, what)                         \
  smooth.def_prop_ro(                                                \
      name,                                                          \
      [](nb::handle self) -> nb::object {                            \
        const Path& path = smooth_of(self);                          \
        const auto found = without_gil([path] { return of(path); }); \
        if (const auto* finite = std::get_if<Real>(&found))          \
          return to_python(*finite, attribute_recipe(self, name));   \
        return nb::float_(std::numeric_limits<double>::infinity());  \
      },                                                             \
      nb::sig("def " name "(self) -> " PHRAME_REAL_SIG " | float"), what)
  PHRAME_SMOOTH_ENERGY("bending_energy", bending_energy, "∫ κ² ds; infinite at most cusps.");
  PHRAME_SMOOTH_ENERGY("frenet_energy", frenet_energy, "∫ (κ² + τ²) ds; infinite at most cusps.");
#undef PHRAME_SMOOTH_ENERGY
  smooth.def_prop_ro(
      "holonomy",
      [](nb::handle self) -> nb::object {
        const Path& path = smooth_of(self);
        const auto found = without_gil([path] { return holonomy(SmoothAngle(path)); });
        return found ? to_python(*found, attribute_recipe(self, "holonomy")) : nb::none();
      },
      nb::sig("def holonomy(self) -> " PHRAME_REAL_SIG " | None"),
      "By which angle the rotation-minimizing frame of a closed path comes back turned, else "
      "None.");
  smooth.def_prop_ro(
      "writhe",
      [](nb::handle self) -> nb::object {
        const Path& path = smooth_of(self);
        if (!path.is_closed()) return nb::none();
        return to_python(without_gil([path] { return writhe(path); }),
                         attribute_recipe(self, "writhe"));
      },
      nb::sig("def writhe(self) -> " PHRAME_REAL_SIG " | None"),
      "Gauss's integral over a closed path twice, else None.");
  smooth.def_prop_ro(
      "self_linking_number",
      [](nb::handle self) -> nb::object {
        const Path& path = smooth_of(self);
        if (!path.is_closed()) return nb::none();
        return nb::int_(without_gil(
            [path] { return self_linking_number(closed_frame(path), total_torsion(path)); }));
      },
      nb::sig("def self_linking_number(self) -> int | None"),
      "How often a closed path is linked with its copy along the principal normals, else None.");
}

/// At a parameter.
void bind_smooth_shape(nb::class_<SmoothPathObject>& smooth) {
#define PHRAME_SMOOTH_AT(name, of, what)                                                        \
  smooth.def(                                                                                   \
      name,                                                                                     \
      [](nb::handle self, nb::handle t) {                                                       \
        const Rational at = rational(t, "t");                                                   \
        const Path& path = smooth_of(self);                                                     \
        return to_python(at_place("t", [&] { return without_gil([path, at] { return of; }); }), \
                         method_recipe(self, name, to_python(at)));                             \
      },                                                                                        \
      argument("t"), nb::sig("def " name "(self, t: Number) -> " PHRAME_REAL_SIG), what)
  PHRAME_SMOOTH_AT("curvature", curvature(path, locate(path, at)), "κ ≥ 0 at t.");
  PHRAME_SMOOTH_AT("torsion", torsion(path, locate(path, at)), "τ at t.");
  PHRAME_SMOOTH_AT("arc_length", SmoothLength(path).value(locate(path, at)),
                   "The length from the start to t.");
#undef PHRAME_SMOOTH_AT
  smooth
      .def("parameter_at", parameter_at, argument("s"),
           nb::sig("def parameter_at(self, s: Number) -> " PHRAME_REAL_SIG),
           "The t where the length from the start is s.")
      .def("point", smooth_point, argument("t"),
           nb::sig("def point(self, t: Number) -> tuple[" PHRAME_REAL_SIG ", " PHRAME_REAL_SIG
                   ", " PHRAME_REAL_SIG "]"),
           "r(t).");
}

// ---- pickles: (turned over, X₁, X₂, X₃, W), (u, v, p, q, f, r(0)) of a PH curve and
// (turned over, from, to, variable, x, y, z)

nb::object packed(const Formula& f) {
  nb::list steps;
  for (const Formula::Step& step : f.steps())
    steps.append(nb::make_tuple(static_cast<int>(step.operation), step.left, step.right,
                                to_python(step.number), to_python(step.pi_multiple)));
  return nb::tuple(steps);
}

Formula unpacked_formula(nb::handle packed) {
  std::vector<Formula::Step> steps;
  for (const nb::handle item : nb::list(packed))
    steps.push_back({static_cast<Formula::Operation>(nb::cast<int>(item[0])),
                     nb::cast<std::size_t>(item[1]), nb::cast<std::size_t>(item[2]),
                     rational(item[3], "number"), rational(item[4], "pi_multiple")});
  return Formula(std::move(steps));
}

/// Curves that differ in the letter of their variable only are the same.
enum class VariableName { kept, left_out };

nb::object packed(const RationalCurve& curve, VariableName) {
  const auto& [x, y, z] = curve.numerator();
  const bool is_turned = RationalCurve(curve.numerator(), curve.weight()) != curve;
  return nb::make_tuple(is_turned, to_python(x.coefficients()), to_python(y.coefficients()),
                        to_python(z.coefficients()), to_python(curve.weight().coefficients()));
}

nb::object packed(const ExpressionCurve& curve, VariableName variable) {
  const auto& [x, y, z] = curve.position();
  const std::string letter = variable == VariableName::kept ? curve.variable() : "";
  return nb::make_tuple(curve.orientation() < 0, packed(curve.from()), packed(curve.to()),
                        nb::str(letter.c_str()), packed(x), packed(y), packed(z));
}

nb::object packed(const PhSegment& segment, VariableName) {
  const Curve& curve = segment.curve();
  const auto& [u, v, p, q] = curve.preimage();
  return nb::make_tuple(to_python(u.coefficients()), to_python(v.coefficients()),
                        to_python(p.coefficients()), to_python(q.coefficients()),
                        to_python(curve.multiplier().coefficients()), to_python(curve.start()));
}

Segment unpacked(nb::handle packed) {
  if (nb::len(packed) == 6)
    return PhSegment(Curve({polynomial(packed[0], "u"), polynomial(packed[1], "v"),
                            polynomial(packed[2], "p"), polynomial(packed[3], "q")},
                           polynomial(packed[4], "f"), vector(packed[5], "start")));
  const auto made = [&]() -> Segment {
    if (nb::len(packed) == 5)
      return RationalCurve(
          {polynomial(packed[1], "x"), polynomial(packed[2], "y"), polynomial(packed[3], "z")},
          polynomial(packed[4], "w"));
    return ExpressionCurve(
        {unpacked_formula(packed[4]), unpacked_formula(packed[5]), unpacked_formula(packed[6])},
        unpacked_formula(packed[1]), unpacked_formula(packed[2]), nb::cast<std::string>(packed[3]));
  }();
  if (!nb::cast<bool>(packed[0])) return made;
  return std::visit([](const auto& curve) -> Segment { return curve.turned_over(); }, made);
}

nb::object packed(const Path& path, VariableName variable = VariableName::kept) {
  nb::list list;
  for (const Segment& segment : path.segments())
    list.append(std::visit([&](const auto& curve) { return packed(curve, variable); }, segment));
  return nb::tuple(list);
}

// ---- what it is

std::string shown(const Segment& segment) {
  if (const RationalCurve* curve = rational_curve(segment)) {
    const auto& [x, y, z] = curve->numerator();
    const std::string top = "(" + to_string(x) + ", " + to_string(y) + ", " + to_string(z) + ")";
    return curve->weight().is_constant() ? top : top + "/(" + to_string(curve->weight()) + ")";
  }
  const auto& curve = std::get<ExpressionCurve>(segment);
  const auto& [x, y, z] = curve.position();
  const std::string& s = curve.variable();
  return "(" + to_string(x, s) + ", " + to_string(y, s) + ", " + to_string(z, s) + "), " + s +
         " from " + to_string(curve.from(), s) + " to " + to_string(curve.to(), s);
}

std::string smooth_repr(const SmoothPathObject& self) {
  const auto& [name, path, notes, near] = self.named;
  const std::string what = path.segments().size() == 1
                               ? shown(path.segments().front())
                               : std::to_string(path.segments().size()) + " segments";
  return "<SmoothPath" + (name.empty() ? "" : " " + abbreviated(name)) + ": " +
         abbreviated(what, 200) + ">";
}

nb::object joined_paths(nb::handle curves, const Text<"name">& name) {
  if (PySequence_Check(curves.ptr()) == 0) refuse_type("curves", "a list of paths", curves);
  std::optional<Path> path;
  std::size_t k = 0;
  for (const nb::handle x : nb::list(curves)) {
    const std::string place = "curves[" + std::to_string(k++) + "]";
    const AnyPath given = any_path(x, place);
    const auto* ph = std::get_if<NamedPhPath>(&given);
    const Path next = ph == nullptr ? std::get<NamedPath>(given).path : Path(ph->path);
    try {
      for (const Segment& segment : next.segments())
        if (path)
          path->append(segment);
        else
          path.emplace(segment);
    } catch (const DomainError& error) {
      refuse(place, error.what(), x);
    }
  }
  if (!path) refuse("curves", "there are none", curves);
  return nb::cast(SmoothPathObject{{name, *std::move(path)}});
}

}  // namespace

nb::object wrap(AnyPath found) {
  if (auto* ph = std::get_if<NamedPhPath>(&found)) return wrap(std::move(*ph));
  return nb::cast(SmoothPathObject{std::get<NamedPath>(std::move(found))});
}

AnyPath any_path(nb::handle x, const std::string& place) {
  if (nb::isinstance<PathObject>(x)) return nb::cast<const PathObject&>(x).named;
  if (nb::isinstance<SmoothPathObject>(x)) return nb::cast<const SmoothPathObject&>(x).named;
  refuse_type(place, "a Path or SmoothPath", x);
}

SmoothAngle angle_to_up(const Path& path, nb::handle up) {
  if (up.is_none()) return without_gil([path] { return SmoothAngle(path); });
  const Vector<Rational> v = vector(up, "up");
  try {
    return without_gil([path, v] { return SmoothAngle(path, v); });
  } catch (const DomainError& error) {
    refuse("up", error.what(), up);
  }
}

FrameStart smooth_start(nb::handle start, nb::handle start_normal, StartRule rule,
                        const SmoothAngle& angle) {
  const FrameStart from = asked_start(start, start_normal, rule,
                                      angle.reference() == SmoothReference::up ? "up" : "frenet");
  if (const auto* along = std::get_if<StartNormal>(&from)) try {
      start_angle(*along, angle);
    } catch (const DomainError& error) {
      refuse("start_normal", error.what(), start_normal);
    }
  return from;
}

void bind_smooth_path(nb::module_& m, nb::class_<SmoothPathObject>& smooth) {
  m.def("_smooth_path", [](const std::string& name, nb::handle segments) {
    std::optional<Path> path;
    for (const nb::handle item : nb::list(segments)) {
      const Segment segment = unpacked(item);
      if (path)
        path->append(segment);
      else
        path.emplace(segment);
    }
    return nb::cast(SmoothPathObject{{name, path.value()}});
  });
  m.def("_joined", joined_paths, argument("curves"), argument("name"));
  smooth
      .def_static("joined", joined_paths, argument("curves"), argument("name") = "",
                  nb::sig("def joined(curves: collections.abc.Sequence[" PHRAME_ANY_PATH_SIG
                          "], name: str = '') -> SmoothPath"),
                  "Paths of any kind one after the other; position and tangent are checked to be "
                  "continuous.")
      .def_prop_ro(
          "name", [](const SmoothPathObject& self) { return self.named.name; }, "May be empty.")
      .def_prop_ro(
          "segments",
          [](const SmoothPathObject& self) {
            nb::list list;
            for (const Segment& segment : self.named.path.segments())
              list.append(nb::cast(SmoothPathObject{{"", Path(segment)}}));
            return nb::tuple(list);
          },
          nb::sig("def segments(self) -> tuple[SmoothPath, ...]"), "Each as a path.")
      .def_prop_ro(
          "end", [](const SmoothPathObject& self) { return self.named.path.segments().size(); },
          "Of the parameter: the number of segments.")
      .def_prop_ro(
          "is_closed", [](const SmoothPathObject& self) { return self.named.path.ends_meet(); },
          "Is the end the start?")
      .def_prop_ro(
          "up",
          [](const SmoothPathObject& self) {
            return to_python(without_gil([path = self.named.path] { return up_vector(path); }));
          },
          nb::sig("def up(self) -> tuple[fractions.Fraction, fractions.Fraction, "
                  "fractions.Fraction]"),
          "A vector v that is nowhere along the tangent: angles are those to the frame e2 = v × "
          "e1/|v × e1|, e3 = e1 × e2.")
      .def(
          "__eq__",
          [](const SmoothPathObject& self, nb::handle other) {
            return nb::isinstance<SmoothPathObject>(other) && self.named.path == smooth_of(other);
          },
          nb::sig("def __eq__(self, other: object) -> bool"))
      .def("__hash__",
           [](const SmoothPathObject& self) {
             return nb::hash(packed(self.named.path, VariableName::left_out));
           })
      .def("__repr__", smooth_repr)
      .def(
          "__reduce__",
          [](const SmoothPathObject& self) {
            return remade("_smooth_path", nb::str(self.named.name.c_str()),
                          packed(self.named.path));
          },
          PHRAME_REDUCE_SIG);
  bind_smooth_totals(smooth);
  bind_smooth_shape(smooth);
  bind_python(
      smooth, "plot", "phrame._plot", "path",
      "def plot(self, ts: Numbers | None = None, *, ax: typing.Any = None, kind: str = "
      "'rmf', ribbon: float | None = None, " PHRAME_START_SIG
      ", f2: Vectors | None = None, **style: typing.Any) -> typing.Any",
      "The path in space, by Matplotlib, with a ribbon that is `ribbon` wide, 0 for none, "
      "along f2 of the frame asked for, or along the f2 that somebody else has at ts; the axes.");
  bind_python(smooth, "_repr_html_", "phrame._show", "path_html", "def _repr_html_(self) -> str");
  bind_copies(smooth);
}

}  // namespace phrame::python
