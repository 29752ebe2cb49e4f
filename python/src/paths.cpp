#include "answers.hpp"
#include "offsets.hpp"

#include <algorithm>
#include <sstream>

namespace phrame::inline v0::python {

PathObject::PathObject(NamedPath path) : named(std::move(path)), ph(as_ph(named)) {}

ParameterKind parameter_kind(const std::string& by) {
  return chosen<ParameterKind>(by, "by", parameter_kinds());
}

std::optional<Parameters> by_t(const Parametrization& along, const Parameters& at,
                               std::string_view place) {
  if (along.kind() == ParameterKind::t) return at;
  std::vector<Rational> found;
  for (std::size_t k = 0; k < at.size(); ++k) {
    const std::string name = std::string(place) + "[" + std::to_string(k) + "]";
    const Real t = parameter(at_place(name, [&] { return along.point(at[k]).at; }));
    if (!t.exact()) return std::nullopt;
    found.push_back(*t.exact());
  }
  return parameters(std::move(found));
}

Parametrization parametrization(const NamedPath& named, ParameterKind by) {
  return at_place("by", [&] { return Parametrization(named, by); });
}

Place place_of(const PathObject& path, const Rational& x, ParameterKind by, const char* place) {
  const Parametrization along = parametrization(path.named, by);
  return at_place(place, [&] { return without_gil([along, x] { return along.point(x).at; }); });
}

nb::object wrap(NamedPath named) { return nb::cast(PathObject(std::move(named))); }
const PathObject& path_of(nb::handle self) { return nb::cast<const PathObject&>(self); }

const PathObject& path_argument(nb::handle x, std::string_view place) {
  if (!nb::isinstance<PathObject>(x)) refuse_type(std::string(place), "a Path", x);
  return path_of(x);
}

std::string why_not_ph(const Path& path) {
  const auto& segments = path.segments();
  std::size_t k = 0;
  const Curve* curve = nullptr;
  while ((curve = ph_curve(segments[k])) != nullptr && curve->is_polynomial()) ++k;
  return "segments[" + std::to_string(k) + "] is no " + (curve != nullptr ? "polynomial " : "") +
         "Pythagorean-hodograph curve";
}

/// Throws a DomainError that is an AttributeError, too.
[[noreturn]] void refuse_part(const std::string& message) {
  const nb::object& type = imported("phrame._errors", "MissingPart");
  PyErr_SetObject(type.ptr(), nb::object(type(message, nb::arg("reason") = message)).ptr());
  throw nb::python_error();
}

const NamedPhPath& ph_of(const PathObject& path, const char* asked) {
  if (!path.ph) refuse_part(asked + (": " + why_not_ph(path.named.path)));
  return *path.ph;
}

NamedPhPath with_preimages_of(const PathObject& path, const char* asked) {
  if (auto found = with_preimages(path.named)) return *std::move(found);
  const auto& segments = path.named.path.segments();
  const auto other = std::find_if_not(segments.begin(), segments.end(), ph_curve);
  refuse_part(std::string(asked) + ": segments[" + std::to_string(other - segments.begin()) +
              "] is no Pythagorean-hodograph curve");
}

void require_one(const std::vector<Curve>& segments, const char* asked) {
  if (segments.size() > 1)
    refuse_part(asked + (": of one curve; there are " + std::to_string(segments.size()) +
                         ", each in path.segments"));
}

const Curve& curve_of(const PathObject& path, const char* asked) {
  const auto& segments = ph_of(path, asked).path.segments();
  require_one(segments, asked);
  return segments.front();
}

Curve curve_with_preimage_of(const PathObject& path, const char* asked) {
  if (path.ph) return curve_of(path, asked);
  const NamedPhPath found = with_preimages_of(path, asked);
  require_one(found.path.segments(), asked);
  return found.path.segments().front();
}

nb::object attribute_recipe(nb::handle self, const char* name) {
  return nb::make_tuple(imported("operator", "attrgetter")(name), nb::make_tuple(self));
}

// ---- where frames start

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

FrameStart frame_start(nb::handle start, nb::handle start_normal, StartRule rule, const Path& path,
                       Reference reference) {
  const FrameStart from = asked_start(start, start_normal, rule, phrame::name_of(reference));
  if (const auto* along = std::get_if<StartNormal>(&from)) try {
      require_start_normal(*along, path);
    } catch (const DomainError& error) {
      refuse("start_normal", error.what(), start_normal);
    }
  return from;
}

bool is_to_up(const PathObject& path, nb::handle up, nb::handle start) {
  if (!path.ph || !up.is_none()) return true;
  if (PyUnicode_Check(start.ptr()) == 0) return false;
  std::string words = text(start, "start");
  return taken_rule(words) == "up";
}

namespace {

/// make() without the lock of the interpreter; what it refuses is said of `up`.
template <class Make>
auto at_up(nb::handle up, const Make& make) {
  try {
    return without_gil(make);
  } catch (const DomainError& error) {
    refuse("up", error.what(), up);
  }
}

}  // namespace

std::optional<Vector<Rational>> chosen_up(const PathObject& path, nb::handle up, nb::handle start) {
  const Path& along = path.named.path;
  if (up.is_none()) {
    if (!path.ph || !is_to_up(path, up, start)) return std::nullopt;
    return without_gil([along] { return up_vector(along); });
  }
  const Vector<Rational> v = vector(up, "up");
  return at_up(up, [along, v] {
    require_up_vector(along, v);
    return v;
  });
}

PathAngle angle_to_up(const Path& path, nb::handle up) {
  if (up.is_none()) return without_gil([path] { return PathAngle(path, Reference::up); });
  const Vector<Rational> v = vector(up, "up");
  return at_up(up, [path, v] { return PathAngle(path, v); });
}

Reference reference_named(nb::handle name, const char* place, const PathObject& path,
                          nb::handle up) {
  const bool has_up = !up.is_none();
  if (name.is_none()) return has_up ? Reference::up : reference_of(path.named.path, std::nullopt);
  const auto found = chosen<Reference>(
      text(name, place), place,
      {{"erf", Reference::euler_rodrigues}, {"frenet", Reference::frenet}, {"up", Reference::up}});
  if (found == Reference::euler_rodrigues && !path.ph)
    refuse(place, "\"erf\" is of PH curves, and " + why_not_ph(path.named.path), name);
  if (found != Reference::up && has_up)
    refuse("up",
           std::string("the angle is to the ") +
               (found == Reference::euler_rodrigues ? "Euler–Rodrigues" : "Frenet") + " frame",
           up);
  return found;
}

// ---- what it is

namespace {

const char* kind_of(const Segment& segment) {
  if (const Curve* ph = ph_curve(segment); ph != nullptr && ph->is_polynomial()) return "ph";
  const RationalCurve* curve = rational_curve(segment);
  if (curve == nullptr) return "expressions";
  return curve->weight().is_constant() ? "polynomial" : "rational";
}

std::string kind_of(const PathObject& self) {
  const auto& segments = self.named.path.segments();
  const std::string kind = kind_of(segments.front());
  const auto is_it = [&](const Segment& segment) { return kind == kind_of(segment); };
  return std::all_of(segments.begin(), segments.end(), is_it) ? kind : "mixed";
}

std::string shown(const Segment& segment) {
  if (const Curve* curve = ph_curve(segment)) {
    std::ostringstream out;
    out << *curve;
    return out.str();
  }
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

std::string shown(const PathObject& self) {
  const auto& segments = self.named.path.segments();
  const std::string what = segments.size() == 1 ? shown(segments.front())
                                                : std::to_string(segments.size()) + " segments";
  const std::string& name = self.named.name;
  return "<Path" + (name.empty() ? "" : " " + abbreviated(name)) + ": " + abbreviated(what, 200) +
         ">";
}

void bind_path(nb::module_& m, PathClass& path) {
  m.def(
      "_path",
      [](const std::string& name, nb::handle segments, nb::handle parameters, nb::handle frame) {
        NamedPath made{name, unpacked_path(segments)};
        made.parameters = unpacked_parameters(parameters, made.path);
        made.frame = unpacked_frame(frame);
        return wrap(std::move(made));
      },
      argument("name"), argument("segments"), argument("parameters") = nb::make_tuple(),
      argument("frame") = nb::none());
  path.def_prop_ro(
          "name", [](const PathObject& self) { return self.named.name; }, "May be empty.")
      .def_prop_ro(
          "segments",
          [](const PathObject& self) {
            nb::list list;
            for (const Segment& segment : self.named.path.segments())
              list.append(wrap(NamedPath{"", Path(segment)}));
            return nb::tuple(list);
          },
          nb::sig("def segments(self) -> tuple[Path, ...]"), "The curves it is made of, as paths.")
      .def_prop_ro(
          "is_ph", [](const PathObject& self) { return self.ph.has_value(); },
          "Are all of its segments polynomial PH curves?")
      .def_prop_ro(
          "has_erf", [](const PathObject& self) { return self.named.path.has_erf(); },
          "Are all of its segments PH curves, polynomial or rational ones? They have an "
          "Euler-Rodrigues frame.")
      .def_prop_ro(
          "kind", [](const PathObject& self) { return kind_of(self); },
          "What all of its segments are, \"ph\", \"polynomial\", \"rational\" or \"expressions\"; "
          "else \"mixed\".")
      .def_prop_ro(
          "end", [](const PathObject& self) { return self.named.path.segments().size(); },
          "Of the parameter: the number of segments.")
      .def_prop_ro(
          "is_closed", [](const PathObject& self) { return self.named.path.ends_meet(); },
          "Is the end the start?")
      .def_prop_ro(
          "corners",
          [](const PathObject& self) {
            nb::list list;
            for (const Corner& corner : corners(self.named.path)) list.append(corner.segment);
            return nb::tuple(list);
          },
          nb::sig("def corners(self) -> tuple[int, ...]"),
          "The joints t at which the tangent breaks, and 0 where it does at the ends of a closed "
          "path. Through corners frames are carried by the least rotation.")
      .def_prop_ro(
          "up",
          [](const PathObject& self) {
            return to_python(without_gil([path = self.named.path] { return up_vector(path); }));
          },
          nb::sig("def up(self) -> " PHRAME_VECTOR_SIG),
          "A vector v that is nowhere along the tangent: the angles of paths that are not PH are "
          "those to the frame e2 = v × e1/|v × e1|, e3 = e1 × e2.")
      .def(
          "json", [](const PathObject& self) { return write_path(self.named); },
          "The curve/1 or spline/1 file of the path, which has no formulas.")
      .def(
          "__eq__",
          [](const PathObject& self, nb::handle other) {
            return nb::isinstance<PathObject>(other) &&
                   self.named.path == path_of(other).named.path &&
                   self.named.frame == path_of(other).named.frame;
          },
          nb::sig("def __eq__(self, other: object) -> bool"))
      .def("__hash__",
           [](const PathObject& self) {
             return nb::hash(packed_path(self.named.path, VariableName::left_out));
           })
      .def("__repr__", [](const PathObject& self) { return shown(self); })
      .def(
          "__reduce__",
          [](const PathObject& self) {
            const NamedPath& named = self.named;
            return remade("_path", nb::str(named.name.c_str()), packed_path(named.path),
                          packed_parameters(named),
                          named.frame ? packed_frame(*named.frame) : nb::object(nb::none()));
          },
          PHRAME_REDUCE_SIG);
  bind_python(
      path, "plot", "phrame._plot", "path",
      "def plot(self, ts: Numbers | None = None, *, ax: typing.Any = None, kind: str = "
      "'rmf', ribbon: float | None = None, " PHRAME_START_SIG
      ", f2: Vectors | None = None, **style: typing.Any) -> typing.Any",
      "The path in space, by Matplotlib, with a ribbon that is `ribbon` wide, 0 for none, "
      "along f2 of the frame asked for, or along the f2 that somebody else has at ts; the axes.");
  bind_python(
      path, "plot_offset", "phrame._plot", "offset",
      "def plot_offset(self, distance: Number | Numbers, join: str = 'round', trim: bool = False, "
      "*, "
      "ax: typing.Any = None, **style: typing.Any) -> typing.Any",
      "The offsets of a plane path, as offset() has them, by Matplotlib, beside the path in grey: "
      "rings are at cusps, crosses where an offset meets itself, and with `trim` squares where it "
      "is "
      "cut; the axes.");
  bind_python(path, "_repr_html_", "phrame._show", "path_html", "def _repr_html_(self) -> str");
  bind_python(path, "_repr_latex_", "phrame._show", "path_latex",
              "def _repr_latex_(self) -> str | None");
  bind_copies(path);
}

}  // namespace

void bind_paths(nb::module_& m) {
  PathClass path(
      m, "Path",
      "A curve of any kind, or several joined to one: Pythagorean-hodograph curves r′ = f·A i A*, "
      "polynomials, rational functions, formulas; exactly. Segment k is the part from k to k + 1 "
      "of the parameter.");
  bind_path(m, path);
  bind_path_numbers(path);
  bind_ph_curve(path);
  bind_constructors(m, path);
  bind_any_curves(path);
  bind_arrays(path);
  bind_angle(m, path);
  bind_integral(m);
  bind_classification(m, path);
  bind_minimal_twist(m, path);
  bind_path_twist(m, path);
  bind_check(m, path);
  bind_certificate(m, path);
  bind_products(path);
  bind_offsets(m, path);
  bind_envelope(m);
  bind_sweep(m);
  bind_ask(m);
}

}  // namespace phrame::python
