#include "answers.hpp"

namespace phrame::python {
namespace {

struct AngleObject {
  NamedPhPath named;
  PathAngle angle;
  FrameStart start;
  FrameAngle start_angle;
  std::string form;
  nb::object recipe;
};

AngleAnswer formula(const AngleObject& self, const std::string& form, const std::string& style) {
  AngleQuery query;
  query.reference = self.angle.reference();
  query.start = self.start;
  query.form = form_named(form);
  query.style = style_named(style);
  query.most_poles = 100;
  return without_gil([named = self.named, query] { return answer(named, query); });
}

AngleAnswer formula(const AngleObject& self, const std::string& style) {
  return formula(self, self.form, style);
}

nb::object make_angle(nb::handle self, const Text<"frame">& frame, nb::handle start,
                      nb::handle start_normal, const Text<"form">& form) {
  const auto& named = nb::cast<const PathObject&>(self).named;
  const Reference reference = reference_named(frame, "frame");
  const Form how = form_named(form);
  const FrameStart from =
      frame_start(start, start_normal, StartRule::reference, named.path, reference);
  auto [angle, at_zero] = without_gil([path = named.path, reference, how, from] {
    return std::pair{PathAngle(path, reference, how), start_angle(from, path, reference)};
  });
  const nb::object along =
      start_normal.is_none() ? nb::none() : to_python(vector(start_normal, "start_normal"));
  return nb::cast(AngleObject{
      named, angle, from, std::move(at_zero), form,
      remade("_angle", self, nb::str(frame.c_str()), start, along, nb::str(form.c_str()))});
}

/// The number of a segment.
std::size_t segment_number(const AngleObject& self, nb::handle segment) {
  const std::size_t n = self.angle.path().segments().size();
  return static_cast<std::size_t>(count(segment, "segment", 0, static_cast<long>(n) - 1));
}

/// θ(t).
auto value_of(const AngleObject& self) {
  return [angle = self.angle, start = self.start_angle](const Rational& t) {
    return angle.value(t, start);
  };
}

nb::object angle_of_what(const AngleObject& self, nb::handle ts, nb::handle progress) {
  if (!is_list(ts)) {
    const Rational t = rational(ts, "ts");
    return nb::float_(at_place("ts", [&] {
      return without_gil([value = value_of(self), t] { return round_to_double(value(t)); });
    }));
  }
  return angles(self.angle, self.start_angle, ts, progress);
}

/// θ(0) + F(t) − F(0), where F must not jump: sums over residues may, those over poles do not.
nb::object angle_for_sympy(const AngleObject& self, nb::handle symbol, const Text<"style">& style) {
  if (!self.named.path.is_curve())
    throw DomainError("sympy: a formula for SymPy is one of a single curve");
  const Style how = style_named(style);
  const bool has_sums = how == Style::logarithms || how == Style::radicals;
  const AngleAnswer found = formula(self, has_sums ? "partial-fractions" : "auto", style);
  const auto [angle, z] = terms(found.start_angle);
  return imported("phrame._convert", "sympy_angle")(
      to_script(found, Language::sympy), symbol, to_python(angle.half_turns),
      to_python(angle.radians), to_python(z ? z->re : Integer(1)),
      to_python(z ? z->im : Integer(0)));
}

}  // namespace

#define PHRAME_STYLE_SIG(name) nb::sig("def " name "(self, style: str = 'logarithms') -> str")

void bind_angle(nb::module_& m, nb::class_<PathObject>& path) {
  m.def("_angle", make_angle, argument("path"), argument("frame"), argument("start"),
        argument("start_normal"), argument("form"));
  path.def(
      "angle", make_angle, argument("frame") = "erf", PHRAME_START_PARAMETERS,
      argument("form") = "auto",
      nb::sig("def angle(self, frame: str = 'erf', " PHRAME_START_SIG
              ", form: str = 'auto') -> Angle"),
      "The angle of the rotation-minimizing frame to the Euler–Rodrigues (erf) or Frenet frame.");
  auto type = nb::class_<AngleObject>(
      m, "Angle", "The angle θ(t) of the rotation-minimizing frame of a path, in closed form.");
  bind_value(type,
             "θ(t): a Fraction where it is rational, else a Real; with `digits` a Decimal "
             "with so many.",
             [](const AngleObject& self) { return value_of(self); });
  type.def("__call__", angle_of_what, argument("ts"), nb::kw_only(),
           argument("progress") = nb::none(),
           nb::sig("@typing.overload\ndef __call__(self, ts: float | fractions.Fraction | "
                   "decimal.Decimal, *, progress: "
                   "collections.abc.Callable[[int, int], object] | None = None) -> float: ...\n"
                   "@typing.overload\ndef __call__(self, ts: Numbers, *, progress: "
                   "collections.abc.Callable[[int, int], object] | None = None) -> "
                   "numpy.typing.NDArray[numpy.float64]"),
           "θ as correctly rounded doubles: of one parameter, or an array of many.")
      .def_prop_ro(
          "path", [](const AngleObject& self) { return wrap(self.named); },
          nb::sig("def path(self) -> Path"), "Along which it is.")
      .def(
          "rate",
          [](const AngleObject& self, nb::handle segment) {
            return self.angle.segment(segment_number(self, segment)).rate();
          },
          argument("segment") = 0, nb::sig("def rate(self, segment: int = 0) -> RationalFunction"),
          "θ′, a rational function.")
      .def(
          "poles",
          [](const AngleObject& self, nb::handle segment) {
            const std::size_t k = segment_number(self, segment);
            return to_python(without_gil([rate = self.angle.segment(k).rate()] {
              return pole_table(integrate(rate, Form::partial_fractions), 100);
            }));
          },
          argument("segment") = 0,
          nb::sig("def poles(self, segment: int = 0) -> " PHRAME_POLES_SIG),
          "The poles of θ′ with their residues, to 12 digits or more; none of more than 100.")
      .def(
          "text",
          [](const AngleObject& self, const Text<"style">& style) {
            return for_reading(to_text(formula(self, style)), true);
          },
          argument("style") = "logarithms", PHRAME_STYLE_SIG("text"),
          "The closed form and the poles, for reading.")
      .def(
          "latex",
          [](const AngleObject& self, const Text<"style">& style) {
            return to_latex(formula(self, style));
          },
          argument("style") = "logarithms", PHRAME_STYLE_SIG("latex"),
          "The closed form, for LaTeX.")
      .def(
          "json",
          [](const AngleObject& self, const Text<"style">& style) {
            return to_json(formula(self, style));
          },
          argument("style") = "logarithms", PHRAME_STYLE_SIG("json"), "angle/1 or spline-angle/1.")
      .def("sympy", angle_for_sympy, argument("symbol") = nb::none(),
           argument("style") = "textbook",
           nb::sig("def sympy(self, symbol: typing.Any = None, style: str = 'textbook') -> "
                   "typing.Any"),
           "θ of a single curve, a SymPy expression of this symbol or a real t: from θ(0), and "
           "continuous, as value() is.")
      .def("__repr__",
           [](const AngleObject& self) {
             return std::string("<Angle to the ") +
                    (self.angle.reference() == Reference::frenet ? "Frenet" : "Euler–Rodrigues") +
                    " frame" +
                    (self.named.name.empty() ? "" : " of " + abbreviated(self.named.name)) + ">";
           })
      .def("__str__",
           [](const AngleObject& self) {
             return for_reading(to_text(formula(self, "logarithms")), false);
           })
      .def("_repr_latex_", [](const AngleObject& self) -> std::optional<std::string> {
        if (!self.named.path.is_curve()) return std::nullopt;
        const AngleAnswer found = formula(self, "textbook");
        const Antiderivative& F = found.formulas.front().antiderivative;
        const std::string terms = [&] {
          if (const auto* book = std::get_if<TextbookForm>(&found.formulas.front().other))
            return formatted_sum(formatted_terms(*book, Notation::latex), "", Notation::latex);
          return formatted_sum(formatted_terms(F, Notation::latex), "", Notation::latex);
        }();
        return "$\\displaystyle \\theta(t) = " + terms + " + \\mathrm{const}$";
      });
  bind_python(type, "plot", "phrame._plot", "angle",
              "def plot(self, ts: Numbers | None = None, *, ax: typing.Any = None, **style: "
              "typing.Any) -> typing.Any",
              "θ over t, by Matplotlib; the axes.");
  bind_python(type, "_repr_html_", "phrame._show", "angle_html", "def _repr_html_(self) -> str");
  bind_recipe(type);
}

}  // namespace phrame::python
