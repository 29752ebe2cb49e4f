#include <limits>

#include "answers.hpp"
#include "arrays.hpp"

namespace phrame::inline v0::python {
namespace {

// ---- totals

nb::object shown(const Real& x, nb::handle self, const char* name) {
  return to_python(x, attribute_recipe(self, name));
}
nb::object shown(const PathTotal& total, nb::handle self, const char* name) {
  return shown(total.value, self, name);
}
nb::object shown(const std::optional<Real>& x, nb::handle self, const char* name) {
  return x ? shown(*x, self, name) : nb::none();
}
nb::object shown(const std::variant<PathTotal, Infinite>& x, nb::handle self, const char* name) {
  if (const auto* finite = std::get_if<PathTotal>(&x)) return shown(*finite, self, name);
  return nb::float_(std::numeric_limits<double>::infinity());
}

std::optional<Real> holonomy_of(const Path& path) { return PathAngle(path).holonomy(); }

std::optional<Real> writhe_of(const Path& path) {
  return path.is_closed() ? std::optional(writhe(path)) : std::nullopt;
}

std::optional<long> self_linking_of(const Path& path) {
  if (!path.is_closed() || !has_continuous_frenet_frame(path)) return std::nullopt;
  return self_linking_number(closed_frame(path), total_torsion(path).value);
}

void bind_totals(PathClass& path) {
#define PHRAME_TOTAL(name, of, type, what)                                                        \
  path.def_prop_ro(                                                                               \
      name,                                                                                       \
      [](nb::handle self) {                                                                       \
        return shown(without_gil([along = path_of(self).named.path] { return of(along); }), self, \
                     name);                                                                       \
      },                                                                                          \
      nb::sig("def " name "(self) -> " PHRAME_REAL_SIG type), what)
  PHRAME_TOTAL("length", total_length, "", "∫ ds.");
  PHRAME_TOTAL("total_curvature", total_curvature, "",
               "∫ κ ds, with the angles of corners, without the half turns at cusps.");
  PHRAME_TOTAL("total_torsion", total_torsion, "", "∫ τ ds.");
  PHRAME_TOTAL("bending_energy", bending_energy, " | float", "∫ κ² ds; infinite at most cusps.");
  PHRAME_TOTAL("frenet_energy", frenet_energy, " | float",
               "∫ (κ² + τ²) ds; infinite at most cusps.");
  PHRAME_TOTAL("holonomy", holonomy_of, " | None",
               "By which angle the rotation-minimizing frame of a closed path comes back turned, "
               "else None.");
  PHRAME_TOTAL("writhe", writhe_of, " | None",
               "Gauss's integral over a closed path twice, else None.");
#undef PHRAME_TOTAL
  path.def_prop_ro(
          "self_linking_number",
          [](nb::handle self) {
            return without_gil(
                [along = path_of(self).named.path] { return self_linking_of(along); });
          },
          nb::sig("def self_linking_number(self) -> int | None"),
          "How often a closed path is linked with its copy along the principal normals, where "
          "those "
          "are continuous; else None.")
      .def(
          "helicity",
          [](nb::handle self, nb::handle about) {
            const Vector<Rational> v = vector(about, "about");
            return to_python(without_gil([along = path_of(self).named.path, v] {
              at_place("about", [&] { require_up_vector(along, v); });
              return SignedFrenet(along).turns_about(v);
            }));
          },
          argument("about") = nb::make_tuple(0, 0, 1),
          nb::sig("def helicity(self, about: Vector = (0, 0, 1)) -> fractions.Fraction"),
          "How often the normal of a closed path, continued through inflections, turns about the "
          "tangent against about × e₁: whole, or a half more where it comes back as its opposite.")
      .def(
          "linking_number",
          [](nb::handle self, nb::handle other) {
            if (!nb::isinstance<PathObject>(other)) refuse_type("other", "a Path", other);
            return without_gil(
                [first = path_of(self).named.path, second = path_of(other).named.path] {
                  return linking_number(first, second);
                });
          },
          argument("other"), nb::sig("def linking_number(self, other: Path) -> int"),
          "How often two closed paths are linked: the crossings that a projection shows, with "
          "their "
          "signs, are proved to be all.")
      .def_prop_ro(
          "corner_angles",
          [](nb::handle self) {
            const auto found =
                without_gil([along = path_of(self).named.path] { return corners(along); });
            nb::list angles;
            for (std::size_t k = 0; k < found.size(); ++k)
              angles.append(to_python(found[k].angle, recipe(imported("phrame._pickle", "element"),
                                                             self, "corner_angles", k)));
            return nb::tuple(angles);
          },
          nb::sig("def corner_angles(self) -> tuple[" PHRAME_REAL_SIG ", ...]"),
          "The angles between the tangents at `corners`, in radians.")
      .def_prop_ro(
          "erf_twist",
          [](nb::handle self) {
            const PhPath& along = ph_of(path_of(self), "erf_twist").path;
            return shown(without_gil([along] { return erf_twist(along); }), self, "erf_twist");
          },
          nb::sig("def erf_twist(self) -> " PHRAME_REAL_SIG),
          "∫ 2h/σ dt: how far the Euler–Rodrigues frame of PH curves turns, in radians.")
      .def_prop_ro(
          "up_twist",
          [](nb::handle self) {
            const Path& along = path_of(self).named.path;
            return shown(
                without_gil([along] { return reference_twist(PathAngle(along, Reference::up)); }),
                self, "up_twist");
          },
          nb::sig("def up_twist(self) -> " PHRAME_REAL_SIG),
          "∫ e2′·e3 dt: how far the frame of `up` turns about e1, in radians.");
}

// ---- at a parameter or a length

/// A number, and how near to 0 it may be where it is not 0 but algebraic.
struct KnownReal {
  Real value;
  ZeroBound bound = {};
};

KnownReal curvature_at(const PhPath& path, const Rational& t) {
  const PathParameter at = locate(path, t);
  const Rational square = squared_curvature(path.segments()[at.segment])(at.t);
  return {square_root_of(square), of_square_root(zero_bound(square))};
}
KnownReal curvature_at(const Path& path, const Rational& t) {
  return {curvature(path, locate(path, t))};
}

KnownReal curvature_at(const Path& path, const Place& at) { return {curvature(path, at)}; }

KnownReal torsion_at(const PhPath& path, const Rational& t) {
  const PathParameter at = locate(path, t);
  return {torsion(path.segments()[at.segment])(at.t)};
}
KnownReal torsion_at(const Path& path, const Rational& t) {
  return {torsion(path, locate(path, t))};
}

KnownReal torsion_at(const Path& path, const Place& at) { return {torsion(path, at)}; }

Vector<Real> point_at(const PhPath& path, const Rational& t) {
  const PathParameter at = locate(path, t);
  const auto [x, y, z] = evaluate(position(path.segments()[at.segment]), at.t);
  return {x, y, z};
}
Vector<Real> point_at(const Path& path, const Rational& t) {
  return position(path, locate(path, t));
}
Vector<Real> point_at(const Path& path, const Place& at) { return position(path, at); }

/// of(path, t), for the name of an argument; along PH curves at once, as these are fractions.
template <class F>
auto asked_at(nb::handle self, const char* argument, const Rational& t, const F& of) {
  const PathObject& path = path_of(self);
  return at_place(argument, [&] {
    if (path.ph) return of(path.ph->path, t);
    return without_gil([along = path.named.path, t, of] { return of(along, t); });
  });
}

/// of(path, t) where t is a fraction, else of(path, place): where `x` is, by this parameter.
template <class F>
auto asked_by(nb::handle self, const char* argument, const Rational& x, ParameterKind by,
              const F& of) {
  if (by == ParameterKind::t) return asked_at(self, argument, x, of);
  const PathObject& path = path_of(self);
  const Place at = place_of(path, x, by, argument);
  if (const Real t = parameter(at); t.exact()) return asked_at(self, argument, *t.exact(), of);
  return at_place(argument, [&] {
    return without_gil([along = path.named.path, at, of] { return of(along, at); });
  });
}

/// of(path, place) at each of these, so many doubles, correctly rounded.
template <std::size_t width, class F>
nb::object rows_at(nb::handle self, nb::handle ts, ParameterKind by, const F& of) {
  const auto at = std::make_shared<Parameters>(parameters(ts, "t"));
  const auto numbers = std::make_shared<DoubleArray>(at->size() * width);
  run({.n = at->size(),
       .grain = 16,
       .work =
           [=, along = parametrization(path_of(self).named, by)](std::size_t from, std::size_t to) {
             for (std::size_t k = from; k < to; ++k)
               at_place("t[" + std::to_string(k) + "]", [&] {
                 const std::array<Real, width> row = of(along.path(), along.point((*at)[k]).at);
                 for (std::size_t c = 0; c < width; ++c)
                   (*numbers)[k * width + c] = finite(round_to_double(row[c]));
               });
           }},
      nb::none());
  return width == 1 ? array(numbers, {at->size()}) : array(numbers, {at->size(), width});
}

/// How a number is pickled that a method answers, where `by` is t without it.
nb::object recipe_by(nb::handle self, const char* name, const Rational& x, const std::string& by) {
  if (by == "t") return method_recipe(self, name, to_python(x));
  return method_recipe(self, name, to_python(x), nb::str(by.c_str()));
}

/// A vector of which the components are pickled as those of what the method answers.
nb::object point(nb::handle self, nb::handle t, const Text<"by">& by) {
  const Rational at = rational(t, "t");
  const Vector<Real> r =
      asked_by(self, "t", at, parameter_kind(by),
               [](const auto& along, const auto& x) { return point_at(along, x); });
  const auto component = [&](long k) {
    const nb::object function = imported("phrame._pickle", "component");
    return to_python(r[static_cast<std::size_t>(k)],
                     by == "t" ? recipe(function, self, nb::str("point"), to_python(at), k)
                               : recipe(function, self, nb::str("point"), to_python(at), k,
                                        nb::str(by.c_str())));
  };
  return nb::make_tuple(component(0), component(1), component(2));
}

nb::object arc_length(nb::handle self, nb::handle t, const Text<"by">& by) {
  if (is_list(t))
    return rows_at<1>(
        self, t, parameter_kind(by),
        [length = PathLength(path_of(self).named.path)](
            const Path&, const Place& at) -> std::array<Real, 1> { return {length.value(at)}; });
  const Rational at = rational(t, "t");
  const PathObject& path = path_of(self);
  const Place place = place_of(path, at, parameter_kind(by), "t");
  const auto length = [along = path.named.path, place] { return PathLength(along).value(place); };
  return to_python(at_place("t", [&] { return path.ph ? length() : without_gil(length); }),
                   recipe_by(self, "arc_length", at, by));
}

/// A vector, each component of which is pickled as that of what the method answers.
nb::object derivative(nb::handle self, nb::handle t, nb::handle order, const Text<"by">& by) {
  const auto n = static_cast<std::size_t>(count(order, "order", 0, 100));
  const ParameterKind kind = parameter_kind(by);
  const auto of = [n](const Path& along, const Place& at) {
    return phrame::derivative(along, n, at);
  };
  if (is_list(t)) return rows_at<3>(self, t, kind, of);
  const Rational at = rational(t, "t");
  const PathObject& path = path_of(self);
  const Place place = place_of(path, at, kind, "t");
  const Vector<Real> found = at_place("t", [&] {
    return without_gil([of, along = path.named.path, place] { return of(along, place); });
  });
  nb::list components;
  for (long k = 0; k < 3; ++k)
    components.append(
        to_python(found[static_cast<std::size_t>(k)],
                  recipe(imported("phrame._pickle", "component"), self, nb::str("derivative"),
                         to_python(at), k, nb::int_(n), nb::str(by.c_str()))));
  return nb::tuple(components);
}

nb::object parameter_at(nb::handle self, nb::handle s) {
  const Rational length = rational(s, "s");
  const Place at = at_place("s", [&] {
    return without_gil(
        [path = path_of(self).named.path, length] { return PathLength(path).point(length); });
  });
  const auto known = algebraic_parameter(at);
  return known ? to_python(*known)
               : to_python(parameter(at), method_recipe(self, "parameter_at", to_python(length)));
}

nb::object bounding_box(nb::handle self) {
  const auto box = at_place("bounding_box", [&] {
    return without_gil([along = path_of(self).named.path] { return bounding_box(along); });
  });
  nb::list axes;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto end = [&](const PathExtreme& x, long of) {
      return to_python(x.value, recipe(imported("phrame._pickle", "extreme"), self, k, of));
    };
    axes.append(nb::make_tuple(end(box[k].least, 0), end(box[k].greatest, 1)));
  }
  return nb::tuple(axes);
}

nb::object nearest(nb::handle self, nb::handle point) {
  const Vector<Rational> p = given_point(point, "point");
  const PathExtreme found = at_place("nearest", [&] {
    return without_gil([along = path_of(self).named.path, p] { return nearest_point(along, p); });
  });
  const auto known = algebraic_parameter(found.at);
  const nb::object kept = to_python(p);
  const auto part = [&](long k) {
    return recipe(imported("phrame._pickle", "component"), self, nb::str("nearest"), kept, k);
  };
  return nb::make_tuple(known ? to_python(*known) : to_python(parameter(found.at), part(0)),
                        to_python(found.value, part(1)));
}

nb::object domain(nb::handle self, const Text<"by">& by) {
  const PathObject& path = path_of(self);
  const ParameterKind kind = parameter_kind(by);
  const Parametrization along = parametrization(path.named, kind);
  const Real from = along.from();
  const Real to = along.to();
  const auto end = [&](const Real& x, long k) {
    return to_python(x, recipe(imported("phrame._pickle", "component"), self, nb::str("domain"),
                               nb::str(by.c_str()), k));
  };
  return nb::make_tuple(end(from, 0), end(to, 1));
}

void bind_places(PathClass& path) {
#define PHRAME_AT(name, of, what)                                                    \
  path.def(                                                                          \
      name,                                                                          \
      [](nb::handle self, nb::handle t, const Text<"by">& by) {                      \
        if (is_list(t))                                                              \
          return rows_at<1>(self, t, parameter_kind(by),                             \
                            [](const Path& along, const Place& place) {              \
                              return std::array<Real, 1>{of(along, place).value};    \
                            });                                                      \
        const Rational at = rational(t, "t");                                        \
        const KnownReal found =                                                      \
            asked_by(self, "t", at, parameter_kind(by),                              \
                     [](const auto& along, const auto& x) { return of(along, x); }); \
        return to_python(found.value, recipe_by(self, name, at, by), found.bound);   \
      },                                                                             \
      argument("t"), argument("by") = "t", nb::sig(PHRAME_NUMBER_OR_ARRAY(name)), what)
  PHRAME_AT("curvature", curvature_at, "κ ≥ 0 at t, or at many.");
  PHRAME_AT("torsion", torsion_at, "τ at t, or at many.");
#undef PHRAME_AT
  path.def("arc_length", arc_length, argument("t"), argument("by") = "t",
           nb::sig(PHRAME_NUMBER_OR_ARRAY("arc_length")),
           "The length from the start to t, or to many.")
      .def("derivative", derivative, argument("t"), argument("order") = 1, argument("by") = "t",
           nb::sig("@typing.overload\ndef derivative(self, t: float | fractions.Fraction | "
                   "decimal.Decimal, order: int = 1, " PHRAME_BY_SIG ") -> " PHRAME_REAL_VECTOR_SIG
                   ": ...\n@typing.overload\ndef derivative(self, t: Numbers, order: int = "
                   "1, " PHRAME_BY_SIG ") -> " PHRAME_ARRAY),
           "The derivative of r by t, of this order: a vector, or a row of doubles for each of "
           "many t.")
      .def("parameter_at", parameter_at, argument("s"),
           nb::sig("def parameter_at(self, s: Number) -> " PHRAME_REAL_SIG),
           "The t where the length from the start is s.")
      .def("point", point, argument("t"), argument("by") = "t",
           nb::sig("def point(self, t: Number, " PHRAME_BY_SIG ") -> " PHRAME_REAL_VECTOR_SIG),
           "r(t).")
      .def_prop_ro(
          "bounding_box", [](nb::handle self) { return bounding_box(self); },
          nb::sig("def bounding_box(self) -> tuple[tuple[" PHRAME_REAL_SIG ", " PHRAME_REAL_SIG
                  "], ...]"),
          "From where to where x, y and z go, by the zeros of their derivatives.")
      .def("nearest", nearest, argument("point"),
           nb::sig("def nearest(self, point: Vector) -> tuple[" PHRAME_REAL_SIG ", " PHRAME_REAL_SIG
                   "]"),
           "Where the path is nearest to the point: t, and the distance.")
      .def("domain", domain, argument("by") = "t",
           nb::sig("def domain(self, " PHRAME_BY_SIG ") -> tuple[" PHRAME_REAL_SIG
                   ", " PHRAME_REAL_SIG "]"),
           "From where to where a parameter goes along the path: t, native (that of the file, of "
           "knots or of formulas), unit, arc-length or fraction.");
}

}  // namespace

void bind_path_numbers(PathClass& path) {
  bind_totals(path);
  bind_places(path);
}

}  // namespace phrame::python
