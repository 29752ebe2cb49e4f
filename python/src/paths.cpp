#include "answers.hpp"
#include "smooth.hpp"

#include <limits>
#include <sstream>

namespace phrame::python {
namespace {

nb::object total(nb::handle self, const char* name, const PathTotal& found) {
  return to_python(found.value, attribute_recipe(self, name));
}

/// Of what is infinite, that.
nb::object total(nb::handle self, const char* name,
                 const std::variant<PathTotal, Infinite>& found) {
  if (const auto* finite = std::get_if<PathTotal>(&found)) return total(self, name, *finite);
  return nb::float_(std::numeric_limits<double>::infinity());
}

const PathObject& path_of(nb::handle self) { return nb::cast<const PathObject&>(self); }

nb::tuple polynomials(const Vector<Polynomial>& v) { return nb::make_tuple(v[0], v[1], v[2]); }

nb::object complex_polynomial(const GaussianPolynomial& g) { return nb::make_tuple(g.re, g.im); }

nb::object point(const PathObject& self, nb::handle t) {
  const Rational given = rational(t, "t");
  const PathParameter at = at_place("t", [&] { return locate(self.named.path, given); });
  return to_python(evaluate(position(self.named.path.segments()[at.segment]), at.t));
}

/// What there is at a parameter or a length.
void bind_places(nb::class_<PathObject>& path) {
  path.def("point", point, argument("t"),
           nb::sig("def point(self, t: Number) -> tuple[fractions.Fraction, fractions.Fraction, "
                   "fractions.Fraction]"),
           "r(t), exactly.")
      .def(
          "curvature",
          [](nb::handle self, nb::handle t) {
            const Rational at = rational(t, "t");
            const PhPath& asked = path_of(self).named.path;
            const Rational square = at_place("t", [&] {
              const PathParameter here = locate(asked, at);
              return squared_curvature(asked.segments()[here.segment])(here.t);
            });
            return to_python(square_root_of(square),
                             method_recipe(self, "curvature", to_python(at)),
                             of_square_root(zero_bound(square)));
          },
          argument("t"), nb::sig("def curvature(self, t: Number) -> fractions.Fraction | Real"),
          "κ ≥ 0 at t.")
      .def(
          "arc_length",
          [](const PathObject& self, nb::handle t) {
            const Rational given = rational(t, "t");
            return to_python(at_place("t", [&] {
              return PathLength(self.named.path).value(locate_inside(self.named.path, given));
            }));
          },
          argument("t"), nb::sig("def arc_length(self, t: Number) -> fractions.Fraction"),
          "The length from the start to t.")
      .def(
          "parameter_at",
          [](const PathObject& self, nb::handle s) {
            const Rational length = rational(s, "s");
            return to_python(at_place("s", [&] {
              return without_gil([path = self.named.path, length] {
                return parameter(PathLength(path).point(length));
              });
            }));
          },
          argument("s"), nb::sig("def parameter_at(self, s: Number) -> fractions.Fraction | Real"),
          "The t where the length from the start is s.");
}

void bind_totals(nb::class_<PathObject>& path) {
#define PHRAME_TOTAL(name, of, what)                                          \
  path.def_prop_ro(                                                           \
      name,                                                                   \
      [](nb::handle self) {                                                   \
        const PhPath& asked = path_of(self).named.path;                       \
        return total(self, name, without_gil([asked] { return of(asked); })); \
      },                                                                      \
      nb::sig("def " name "(self) -> fractions.Fraction | Real | float"), what)
  PHRAME_TOTAL("length", total_length, "∫ ds.");
  PHRAME_TOTAL("erf_twist", erf_twist,
               "∫ 2h/σ dt: how far the Euler–Rodrigues frame turns, in radians.");
  PHRAME_TOTAL("total_torsion", total_torsion, "∫ τ ds.");
  PHRAME_TOTAL("bending_energy", bending_energy, "∫ κ² ds; infinite at most cusps.");
  PHRAME_TOTAL("frenet_energy", frenet_energy, "∫ (κ² + τ²) ds; infinite at most cusps.");
#undef PHRAME_TOTAL
  path.def_prop_ro(
      "total_curvature",
      [](nb::handle self) -> nb::object {
        const PhPath& asked = path_of(self).named.path;
        const auto found = without_gil([asked] { return total_curvature(asked); });
        return found ? total(self, "total_curvature", *found) : nb::none();
      },
      nb::sig("def total_curvature(self) -> fractions.Fraction | Real | None"),
      "∫ κ ds where the curvature is rational over a field ℚ(√c), else None.");
  path.def_prop_ro(
      "holonomy",
      [](nb::handle self) -> nb::object {
        const PhPath& asked = path_of(self).named.path;
        const auto found = without_gil([asked] { return PathAngle(asked).holonomy(); });
        return found ? to_python(*found, attribute_recipe(self, "holonomy")) : nb::none();
      },
      nb::sig("def holonomy(self) -> fractions.Fraction | Real | None"),
      "By which angle the rotation-minimizing frame of a closed path comes back turned, else "
      "None.");
  path.def_prop_ro(
      "writhe",
      [](nb::handle self) -> nb::object {
        const PhPath& asked = path_of(self).named.path;
        if (!asked.closing_turn()) return nb::none();
        return to_python(without_gil([asked] { return writhe(asked); }),
                         attribute_recipe(self, "writhe"));
      },
      nb::sig("def writhe(self) -> fractions.Fraction | Real | None"),
      "Gauss's integral over a closed path twice, else None.");
  path.def_prop_ro(
      "self_linking_number",
      [](nb::handle self) -> nb::object {
        const PhPath& asked = path_of(self).named.path;
        if (!asked.closing_turn()) return nb::none();
        return nb::int_(without_gil([asked] {
          return self_linking_number(closed_frame(asked), total_torsion(asked).value);
        }));
      },
      nb::sig("def self_linking_number(self) -> int | None"),
      "How often a closed path is linked with its copy along the principal normals, else None.");
}

void bind_path(nb::class_<PathObject>& path) {
  path.def_prop_ro(
          "name", [](const PathObject& self) { return self.named.name; }, "May be empty.")
      .def_prop_ro(
          "segments",
          [](const PathObject& self) {
            nb::list list;
            for (const Curve& curve : self.named.path.segments())
              list.append(wrap(NamedPhPath("", curve)));
            return nb::tuple(list);
          },
          nb::sig("def segments(self) -> tuple[Curve, ...]"), "The curves that it is made of.")
      .def_prop_ro(
          "end", [](const PathObject& self) { return self.named.path.segments().size(); },
          "Of the parameter: the number of segments.")
      .def_prop_ro(
          "is_closed", [](const PathObject& self) { return self.named.path.ends_meet(); },
          "Is the end the start?")
      .def(
          "json", [](const PathObject& self) { return write_path(self.named); },
          "The curve/1 or spline/1 file.")
      .def(
          "__eq__",
          [](const PathObject& self, nb::handle other) {
            return nb::isinstance<PathObject>(other) &&
                   self.named.path == path_of(other).named.path;
          },
          nb::sig("def __eq__(self, other: object) -> bool"))
      .def("__hash__",
           [](const PathObject& self) {  // of all that == compares: a file without a name
             return nb::hash(nb::str(write_path(NamedPhPath("", self.named.path)).c_str()));
           })
      .def("__repr__",
           [](nb::handle self) {
             const NamedPhPath& named = path_of(self).named;
             std::ostringstream out;
             if (named.path.is_curve())
               out << named.path.segments().front();
             else
               out << named.path.segments().size() << " segments";
             const std::string name = named.name.empty() ? "" : " " + abbreviated(named.name);
             return "<" + nb::cast<std::string>(self.type().attr("__name__")) + name + ": " +
                    abbreviated(out.str(), 200) + ">";
           })
      .def(
          "__reduce__",
          [](const PathObject& self) { return remade("_path_from", write_path(self.named)); },
          PHRAME_REDUCE_SIG);
  bind_python(
      path, "plot", "phrame._plot", "path",
      "def plot(self, ts: Numbers | None = None, *, ax: typing.Any = None, kind: str = "
      "'rmf', ribbon: float | None = None, " PHRAME_START_SIG
      ", f2: Vectors | None = None, **style: typing.Any) -> typing.Any",
      "The path in space, by Matplotlib, with a ribbon that is `ribbon` wide, 0 for none, "
      "along f2 of the frame asked for, or along the f2 that somebody else has at ts; the axes.");
  bind_python(path, "_repr_html_", "phrame._show", "path_html", "def _repr_html_(self) -> str");
  bind_python(path, "_repr_latex_", "phrame._show", "path_latex",
              "def _repr_latex_(self) -> str | None");
  bind_copies(path);
}

void bind_transformations(nb::class_<CurveObject, PathObject>& curve) {
  const auto renamed = [](const CurveObject& self, Curve made) {
    return wrap(NamedPhPath(self.named.name, std::move(made)));
  };
  curve
      .def(
          "segment",
          [renamed](const CurveObject& self, nb::handle a, nb::handle b) {
            return renamed(self, segment(curve_of(self), rational(a, "a"), rational(b, "b")));
          },
          argument("a"), argument("b"), nb::sig("def segment(self, a: Number, b: Number) -> Curve"),
          "The part from t = a to b as a curve on [0, 1].")
      .def(
          "reversed",
          [renamed](const CurveObject& self) { return renamed(self, reversed(curve_of(self))); },
          nb::sig("def reversed(self) -> Curve"), "t ↦ r(1 − t).")
      .def(
          "translated",
          [renamed](const CurveObject& self, nb::handle v) {
            return renamed(self, translated(curve_of(self), vector(v, "v")));
          },
          argument("v"), nb::sig("def translated(self, v: Vector) -> Curve"), "r + v.")
      .def(
          "scaled",
          [renamed](const CurveObject& self, nb::handle c) {
            return renamed(self, scaled(curve_of(self), rational(c, "c")));
          },
          argument("c"), nb::sig("def scaled(self, c: Number) -> Curve"), "c·r.")
      .def(
          "rotated",
          [renamed](const CurveObject& self, nb::handle u) {
            const auto list = rationals(u, "u");
            if (list.size() != 4)
              refuse("u", "4 numbers are wanted, there are " + std::to_string(list.size()), u);
            return renamed(self, rotated(curve_of(self), {list[0], list[1], list[2], list[3]}));
          },
          argument("u"), nb::sig("def rotated(self, u: collections.abc.Sequence[Number]) -> Curve"),
          "Rotated as the quaternion u, its real part first, says, and scaled by |u|².");
}

void bind_curve(nb::class_<CurveObject, PathObject>& curve) {
  curve
      .def_prop_ro(
          "preimage",
          [](const CurveObject& self) {
            const auto& [u, v, p, q] = curve_of(self).preimage();
            return nb::make_tuple(u, v, p, q);
          },
          nb::sig("def preimage(self) -> tuple[Polynomial, Polynomial, Polynomial, Polynomial]"),
          "A = u + vi + pj + qk.")
      .def_prop_ro(
          "multiplier", [](const CurveObject& self) { return curve_of(self).multiplier(); },
          "f of r′ = f·A i A*.")
      .def_prop_ro(
          "start", [](const CurveObject& self) { return to_python(curve_of(self).start()); },
          nb::sig("def start(self) -> tuple[fractions.Fraction, fractions.Fraction, "
                  "fractions.Fraction]"),
          "r(0).")
      .def_prop_ro(
          "degree", [](const CurveObject& self) { return degree(curve_of(self)); }, "Of r.")
      .def_prop_ro(
          "hodograph",
          [](const CurveObject& self) { return polynomials(hodograph(curve_of(self))); },
          nb::sig("def hodograph(self) -> tuple[Polynomial, Polynomial, Polynomial]"), "r′.")
      .def_prop_ro(
          "position", [](const CurveObject& self) { return polynomials(position(curve_of(self))); },
          nb::sig("def position(self) -> tuple[Polynomial, Polynomial, Polynomial]"), "r.")
      .def_prop_ro(
          "sigma", [](const CurveObject& self) { return sigma(curve_of(self).preimage()); },
          "σ = |A|².")
      .def_prop_ro(
          "h", [](const CurveObject& self) { return twist_numerator(curve_of(self).preimage()); },
          "uv′ − u′v − pq′ + p′q.")
      .def_prop_ro(
          "g",
          [](const CurveObject& self) {
            return complex_polynomial(bend_numerator(curve_of(self).preimage()));
          },
          nb::sig("def g(self) -> tuple[Polynomial, Polynomial]"),
          "αβ′ − α′β: its real and its imaginary part.")
      .def_prop_ro(
          "rho", [](const CurveObject& self) { return rho(curve_of(self).preimage()); }, "4|g|².")
      .def_prop_ro(
          "control_points",
          [](const CurveObject& self) {
            nb::list list;
            for (const auto& point : control_points(curve_of(self))) list.append(to_python(point));
            return nb::tuple(list);
          },
          nb::sig("def control_points(self) -> tuple[tuple[fractions.Fraction, "
                  "fractions.Fraction, fractions.Fraction], ...]"),
          "Of the Bézier curve that it is.")
      .def_prop_ro(
          "squared_curvature",
          [](const CurveObject& self) { return squared_curvature(curve_of(self)); }, "κ².")
      .def_prop_ro(
          "torsion", [](const CurveObject& self) { return torsion(curve_of(self)); }, "τ.");
}

}  // namespace

const Curve& curve_of(const PathObject& path) { return path.named.path.segments().front(); }

nb::object wrap(NamedPhPath named) {
  if (named.path.is_curve()) return nb::cast(CurveObject{{std::move(named)}});
  return nb::cast(PathObject{std::move(named)});
}

nb::object attribute_recipe(nb::handle self, const char* name) {
  return nb::make_tuple(imported("operator", "attrgetter")(name), nb::make_tuple(self));
}

Reference reference_named(const std::string& name, const std::string& place) {
  return chosen<Reference>(name, place.c_str(),
                           {{"erf", Reference::euler_rodrigues}, {"frenet", Reference::frenet}});
}

namespace {

/// "erf" of "erf+pi/4", which is then left with "pi/4"; empty where there is no name.
std::string taken_rule(std::string& text) {
  for (const std::string rule : {"least", "erf", "up", "frenet"}) {
    if (!text.starts_with(rule)) continue;
    std::string rest = text.substr(rule.size());
    rest.erase(0, std::min(rest.find_first_not_of(' '), rest.size()));
    if (!rest.empty() && rest[0] != '+' && rest[0] != '-') continue;
    if (rest.starts_with('+')) rest.erase(0, 1);
    text = std::move(rest);
    return rule;
  }
  return "";
}

}  // namespace

FrameStart asked_start(nb::handle start, nb::handle start_normal, StartRule rule,
                       const std::string& reference) {
  if (!start_normal.is_none()) {
    if (!start.is_none()) refuse("start", "it and start_normal exclude each other", start);
    return StartNormal(vector(start_normal, "start_normal"));
  }
  bool is_least = rule == StartRule::least_rotation;
  Angle turn;
  if (PyUnicode_Check(start.ptr()) != 0) {
    std::string words = text(start, "start");
    const std::string name = taken_rule(words);
    if (!name.empty() && name != "least" && name != reference)
      refuse("start", "angles are measured from \"" + reference + "\" here, not \"" + name + "\"",
             start);
    if (!name.empty()) is_least = name == "least";
    if (!words.empty() || name.empty()) turn = angle_number(nb::str(words.c_str()), "start");
  } else if (!start.is_none()) {
    turn = angle_number(start, "start");
  }
  return is_least ? FrameStart(LeastRotation{turn}) : FrameStart(turn);
}

FrameStart frame_start(nb::handle start, nb::handle start_normal, StartRule rule,
                       const PhPath& path, Reference reference) {
  const FrameStart from = asked_start(start, start_normal, rule,
                                      reference == Reference::euler_rodrigues ? "erf" : "frenet");
  if (const auto* along = std::get_if<StartNormal>(&from)) try {
      start_angle(*along, path, reference);
    } catch (const DomainError& error) {
      refuse("start_normal", error.what(), start_normal);
    }
  return from;
}

void bind_paths(nb::module_& m) {
  m.def("_path_from", [](const std::string& text) { return wrap(read_path(text)); });
  nb::class_<PathObject> path(
      m, "Path",
      "Pythagorean-hodograph curves joined to one, with the parameter from 0 "
      "to their number. A Curve is a Path.");
  nb::class_<CurveObject, PathObject> curve(
      m, "Curve", "A Pythagorean-hodograph curve r′ = f·A i A*, exactly.");
  nb::class_<SmoothPathObject> smooth(
      m, "SmoothPath",
      "A path of curves of any kind, polynomial, rational or by formulas, with the parameter from "
      "0 to the number of segments: without closed forms, to any number of digits.");
  bind_path(path);
  bind_places(path);
  bind_totals(path);
  bind_arrays(path);
  bind_curve(curve);
  bind_transformations(curve);
  bind_constructors(path, curve);
  bind_any_curves(m, curve);
  bind_smooth_path(m, smooth);
  bind_smooth_arrays(smooth);
  bind_smooth_angle(m, smooth);
  bind_angle(m, path);
  bind_integral(m);
  bind_classification(m, path);
  bind_minimal_twist(m, path);
  bind_check(m, path);
  bind_smooth_check(smooth);
  bind_smooth_twist(smooth);
  bind_certificate(m, curve);
  bind_products(path, smooth);
  bind_sweep(m);
}

}  // namespace phrame::python
