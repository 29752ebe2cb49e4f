#include "answers.hpp"

namespace phrame::inline v0::python {
namespace {

struct AngleObject {
  PathObject path;
  PathAngle angle;
  StartAngle at_zero;
  FrameStart start;
  std::string form;
  nb::object recipe;
};

nb::object make_angle(nb::handle self, nb::handle frame, nb::handle start, nb::handle start_normal,
                      const Text<"form">& form, nb::handle up) {
  const PathObject& path = path_of(self);
  const Reference reference = reference_named(frame, "frame", path, up);
  const Form how = form_named(form);
  const PathAngle angle = reference == Reference::up
                              ? angle_to_up(path.named.path, up)
                              : without_gil([of = path.named.path, reference, how] {
                                  return PathAngle(of, reference, how);
                                });
  const FrameStart from =
      frame_start(start, start_normal, StartRule::reference, path.named.path, reference);
  const StartAngle at_zero = without_gil([&] { return start_angle(from, angle); });
  const auto kept = [](nb::handle v, const char* place) {
    return v.is_none() ? nb::none() : to_python(vector(v, place));
  };
  return nb::cast(
      AngleObject{path, angle, at_zero, from, form,
                  remade("_angle", self, frame, start, kept(start_normal, "start_normal"),
                         nb::str(form.c_str()), kept(up, "up"))});
}

/// θ(t).
auto value_of(const AngleObject& self) {
  return [angle = self.angle, start = self.at_zero](const Rational& t) {
    return angle.value(t, start);
  };
}

std::string frame_of(const AngleObject& self) {
  if (self.angle.reference() == Reference::euler_rodrigues) return "Euler–Rodrigues frame";
  if (self.angle.reference() == Reference::frenet) return "Frenet frame";
  const auto& [x, y, z] = self.angle.up();
  return "frame of (" + to_string(x) + ", " + to_string(y) + ", " + to_string(z) + ")";
}

/// Throws DomainError, which names what was asked for, where there is no closed form.
const PathAngle& closed_form(const AngleObject& self, const char* asked) {
  if (self.path.ph) return self.angle;
  throw DomainError(asked +
                    (": the angle has no closed form: " + why_not_ph(self.path.named.path)));
}

AngleAnswer formula(const AngleObject& self, const std::string& form, const std::string& style) {
  AngleQuery query;
  query.reference = self.angle.reference();
  if (query.reference == Reference::up) query.up = self.angle.up();
  query.start = self.start;
  query.form = form_named(form);
  query.style = style_named(style);
  query.most_poles = 100;
  return without_gil([named = self.path.named, query] { return answer(named, query); });
}

/// The number of a segment.
const RmfAngle& angle_along(const AngleObject& self, const char* asked, nb::handle segment) {
  const PathAngle& angle = closed_form(self, asked);
  const std::size_t n = angle.path().segments().size();
  return *angle.closed_form(
      static_cast<std::size_t>(count(segment, "segment", 0, static_cast<long>(n) - 1)));
}

nb::object angle_of_what(const AngleObject& self, nb::handle ts, const Text<"by">& by,
                         nb::handle progress) {
  const ParameterKind kind = parameter_kind(by);
  if (!is_list(ts)) {
    const Rational t = rational(ts, "ts");
    if (kind != ParameterKind::t) {
      const Place at = place_of(self.path, t, kind, "ts");
      return nb::float_(at_place("ts", [&] {
        return without_gil([angle = self.angle, start = self.at_zero, at] {
          return round_to_double(angle.value(at, start));
        });
      }));
    }
    return nb::float_(at_place("ts", [&] {
      return without_gil([value = value_of(self), t] { return round_to_double(value(t)); });
    }));
  }
  return angles(self.path.named, self.angle, self.at_zero, ts, kind, progress);
}

nb::object up_of(const AngleObject& self) {
  if (self.angle.reference() != Reference::up) return nb::none();
  return to_python(self.angle.up());
}

/// θ(0) + F(t) − F(0), where F must not jump: sums over residues may, those over poles do not.
nb::object angle_for_sympy(const AngleObject& self, nb::handle symbol, const Text<"style">& style) {
  const Style how = style_named(style);
  if (closed_form(self, "sympy").path().segments().size() > 1)
    throw DomainError("sympy: a formula for SymPy is one of a single curve");
  const bool has_sums = how == Style::logarithms || how == Style::radicals;
  const AngleAnswer found = formula(self, has_sums ? "partial-fractions" : "auto", style);
  const auto [angle, z] = terms(std::get<FrameAngle>(found.start_angle));
  return imported("phrame._convert", "sympy_angle")(
      to_script(found, Language::sympy), symbol, to_python(angle.half_turns),
      to_python(angle.radians), to_python(z ? z->re : Integer(1)),
      to_python(z ? z->im : Integer(0)));
}

std::optional<std::string> latex_of(const AngleObject& self) {
  if (!self.path.ph || self.angle.path().segments().size() > 1) return std::nullopt;
  const AngleAnswer found = formula(self, self.form, "textbook");
  const Antiderivative& F = found.formulas.front()->antiderivative;
  const std::string terms = [&] {
    if (const auto* book = std::get_if<TextbookForm>(&found.formulas.front()->other))
      return formatted_sum(formatted_terms(*book, Notation::latex), "", Notation::latex);
    return formatted_sum(formatted_terms(F, Notation::latex), "", Notation::latex);
  }();
  return "$\\displaystyle \\theta(t) = " + terms + " + \\mathrm{const}$";
}

}  // namespace

#define PHRAME_STYLE_SIG(name) nb::sig("def " name "(self, style: str = 'logarithms') -> str")
#define PHRAME_WRITTEN(name, of, what)                             \
  type.def(                                                        \
      name,                                                        \
      [](const AngleObject& self, const Text<"style">& style) {    \
        const AngleAnswer found = formula(self, self.form, style); \
        return of;                                                 \
      },                                                           \
      argument("style") = "logarithms", PHRAME_STYLE_SIG(name), what)

void bind_angle(nb::module_& m, PathClass& path) {
  m.def("_angle", make_angle, argument("path"), argument("frame"), argument("start"),
        argument("start_normal"), argument("form"), argument("up"));
  path.def(
      "angle", make_angle, argument("frame") = nb::none(), PHRAME_START_PARAMETERS,
      argument("form") = "auto", argument("up") = nb::none(),
      nb::sig("def angle(self, frame: str | None = None, " PHRAME_START_SIG
              ", form: str = 'auto', " PHRAME_UP_SIG ") -> Angle"),
      "The angle of the rotation-minimizing frame to the Euler–Rodrigues frame (erf) of PH curves, "
      "to the Frenet frame, or to the frame of a vector `up`, e2 = up × e1/|up × e1|; without a "
      "name to erf where the path is PH, else to up.");
  auto type = nb::class_<AngleObject>(
      m, "Angle",
      "The angle θ(t) of the rotation-minimizing frame of a path: in closed form to the "
      "Euler–Rodrigues and Frenet frames of PH curves, else to any number of digits.");
  bind_value(type,
             "θ(t): a Fraction where it is rational, else a Real; with `digits` a Decimal "
             "with so many.",
             [](const AngleObject& self) { return value_of(self); });
  type.def("__call__", angle_of_what, argument("ts"), nb::kw_only(), argument("by") = "t",
           argument("progress") = nb::none(),
           nb::sig("@typing.overload\ndef __call__(self, ts: float | fractions.Fraction | "
                   "decimal.Decimal, *, by: str = 't', progress: "
                   "collections.abc.Callable[[int, int], object] | None = None) -> float: ...\n"
                   "@typing.overload\ndef __call__(self, ts: Numbers, *, by: str = 't', progress: "
                   "collections.abc.Callable[[int, int], object] | None = None) -> "
                   "numpy.typing.NDArray[numpy.float64]"),
           "θ as correctly rounded doubles: of one parameter, or an array of many; `by` says what "
           "they are: t, native, unit, arc-length or fraction.")
      .def_prop_ro(
          "path", [](const AngleObject& self) { return nb::cast(self.path); },
          nb::sig("def path(self) -> Path"), "Along which it is.")
      .def_prop_ro(
          "reference",
          [](const AngleObject& self) { return phrame::name_of(self.angle.reference()); },
          "The frame that it is measured from: \"erf\", \"frenet\" or \"up\".")
      .def_prop_ro("up", up_of, nb::sig("def up(self) -> " PHRAME_VECTOR_SIG " | None"),
                   "v, where it is to the frame of a vector v.")
      .def_prop_ro(
          "is_zero", [](const AngleObject& self) { return self.angle.is_zero(); },
          "Is θ the same all along, as in a plane with its normal for `up`?")
      .def(
          "rate",
          [](const AngleObject& self, nb::handle segment) {
            return angle_along(self, "rate", segment).rate();
          },
          argument("segment") = 0, nb::sig("def rate(self, segment: int = 0) -> RationalFunction"),
          "θ′ of a closed form, a rational function.")
      .def(
          "poles",
          [](const AngleObject& self, nb::handle segment) {
            return to_python(without_gil([rate = angle_along(self, "poles", segment).rate()] {
              return pole_table(integrate(rate, Form::partial_fractions), 100);
            }));
          },
          argument("segment") = 0,
          nb::sig("def poles(self, segment: int = 0) -> " PHRAME_POLES_SIG),
          "The poles of θ′ with their residues, to 12 digits or more; none of more than 100.");
  PHRAME_WRITTEN("text", for_reading(to_text(found), true),
                 "The closed form and the poles, where there are some, for reading.");
  PHRAME_WRITTEN("latex", to_latex(found), "The same for LaTeX.");
  PHRAME_WRITTEN("json", to_json(found), "angle/1 or spline-angle/1.");
  type.def("sympy", angle_for_sympy, argument("symbol") = nb::none(),
           argument("style") = "textbook",
           nb::sig("def sympy(self, symbol: typing.Any = None, style: str = 'textbook') -> "
                   "typing.Any"),
           "θ of a single curve in closed form, a SymPy expression of this symbol or a real t: "
           "from θ(0), and continuous, as value() is.")
      .def("__repr__",
           [](const AngleObject& self) {
             const std::string& name = self.path.named.name;
             return "<Angle to the " + frame_of(self) +
                    (name.empty() ? "" : " of " + abbreviated(name)) + ">";
           })
      .def("__str__",
           [](const AngleObject& self) {
             return for_reading(to_text(formula(self, self.form, "logarithms")), false);
           })
      .def("_repr_latex_", latex_of);
  bind_python(type, "plot", "phrame._plot", "angle",
              "def plot(self, ts: Numbers | None = None, *, ax: typing.Any = None, **style: "
              "typing.Any) -> typing.Any",
              "θ over t, by Matplotlib; the axes.");
  bind_python(type, "_repr_html_", "phrame._show", "angle_html", "def _repr_html_(self) -> str");
  bind_recipe(type);
}

}  // namespace phrame::python
