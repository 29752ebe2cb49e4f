#include "answers.hpp"

namespace phrame::inline v0::python {
namespace {

struct ClassificationObject {
  ClassificationAnswer found;
  nb::object recipe;
};

const Classification& of_curve(const ClassificationObject& self) {
  const auto& segments = self.found.classification.segments;
  if (segments.size() > 1 || !segments.front())
    throw DomainError("classification: that is asked of single PH curves; classify path.segments");
  return *segments.front();
}

nb::object vector_or_none(const std::optional<Vector<Rational>>& v) {
  return v ? to_python(*v) : nb::none();
}

#define PHRAME_ROOTS_SIG "tuple[tuple[fractions.Fraction | Real, int], ...]"

}  // namespace

void bind_classification(nb::module_& m, PathClass& path) {
  const auto classify = [](nb::handle self) {
    const NamedPath& named = path_of(self).named;
    return nb::cast(
        ClassificationObject{without_gil([named] { return answer(named, ClassificationQuery{}); }),
                             method_recipe(self, "classify")});
  };
  path.def("classify", classify, nb::sig("def classify(self) -> Classification"),
           "Of which kinds a path and its segments that are PH curves are, decided exactly.");
  auto type = nb::class_<ClassificationObject>(
      m, "Classification", "Of which kinds a path is, with witnesses: docs/classification.md.");
  using C = ClassificationObject;
  type.def_prop_ro(
          "path", [](const C& c) { return wrap(c.found.path); }, nb::sig("def path(self) -> Path"),
          "That is classified.")
      .def_prop_ro(
          "is_regular", [](const C& c) { return c.found.classification.is_regular; },
          "Has it no cusps?")
      .def_prop_ro(
          "line", [](const C& c) { return vector_or_none(c.found.classification.line); },
          nb::sig("def line(self) -> " PHRAME_VECTOR_SIG " | None"),
          "The direction of a straight line.")
      .def_prop_ro(
          "normal", [](const C& c) { return vector_or_none(c.found.classification.normal); },
          nb::sig("def normal(self) -> " PHRAME_VECTOR_SIG " | None"),
          "Of the plane of a plane path.")
      .def_prop_ro(
          "helix",
          [](const C& c) -> nb::object {
            const auto& helix = c.found.classification.helix;
            if (!helix) return nb::none();
            return nb::make_tuple(to_python(helix->axis), to_python(helix->cosine_squared));
          },
          nb::sig("def helix(self) -> tuple[" PHRAME_VECTOR_SIG ", fractions.Fraction] | None"),
          "The axis and cos² of the constant angle to it.")
      .def_prop_ro(
          "erf_is_rotation_minimizing",
          [](const C& c) { return c.found.classification.erf_is_rotation_minimizing; }, "Is h = 0?")
      .def_prop_ro(
          "cusps", [](const C& c) { return to_python(of_curve(c).cusps); },
          nb::sig("def cusps(self) -> " PHRAME_ROOTS_SIG),
          "On [0, 1], with their orders; of a curve, as all below.")
      .def_prop_ro(
          "inflections", [](const C& c) { return to_python(of_curve(c).inflections); },
          nb::sig("def inflections(self) -> " PHRAME_ROOTS_SIG), "On [0, 1], with their orders.")
      .def_prop_ro(
          "control_cone",
          [](const C& c) -> nb::object {
            const auto& cone = of_curve(c).control_cone;
            if (!cone) return nb::none();
            return nb::make_tuple(to_python(cone->cosine_squared), cone->is_obtuse,
                                  to_python(cone->azimuth_cosine));
          },
          nb::sig("def control_cone(self) -> tuple[fractions.Fraction, bool, fractions.Fraction] | "
                  "None"),
          "Of a cubic, cos² of the half-angle of the cone on which the first and the last leg of "
          "its "
          "control polygon are around the middle one, is it obtuse, and the cosine of the turn "
          "between them.")
      .def_prop_ro(
          "double_ph",
          [](const C& c) -> nb::object {
            const auto& found = of_curve(c).double_ph;
            if (!found) return nb::none();
            return nb::make_tuple(to_python(found->constant), nb::cast(found->omega));
          },
          nb::sig("def double_ph(self) -> tuple[fractions.Fraction, Polynomial] | None"),
          "(c, ω) with ρ = c·ω².")
      .def_prop_ro(
          "content", [](const C& c) { return of_curve(c).content; }, "gcd(x′, y′, z′).")
      .def_prop_ro(
          "rational_frame",
          [](const C& c) -> nb::object {
            const auto* frame = std::get_if<RationalFrame>(&of_curve(c).rational_frame);
            if (frame == nullptr) return nb::none();
            return nb::make_tuple(nb::cast(frame->w.re), nb::cast(frame->w.im));
          },
          nb::sig("def rational_frame(self) -> tuple[Polynomial, Polynomial] | None"),
          "The parts of w with θ = 2·arg w where the rotation-minimizing frame is rational.")
      .def_prop_ro(
          "erf_is_monotone", [](const C& c) { return of_curve(c).erf_turning.is_monotone; },
          "Does the Euler–Rodrigues frame turn one way?")
      .def(
          "text", [](const C& c) { return for_reading(to_text(c.found), true); }, "For reading.")
      .def(
          "latex", [](const C& c) { return to_latex(c.found); }, "For LaTeX.")
      .def(
          "json", [](const C& c) { return to_json(c.found); }, "classify/1.")
      .def("__str__", [](const C& c) { return for_reading(to_text(c.found), false); })
      .def("_repr_latex_", [](const C& c) -> std::optional<std::string> {
        if (c.found.path.path.segments().size() > 1) return std::nullopt;
        return between_dollars(to_latex(c.found));
      });
  bind_python(type, "__repr__", "phrame._show", "classification_repr", "def __repr__(self) -> str");
  bind_python(type, "_repr_html_", "phrame._show", "classification_html",
              "def _repr_html_(self) -> str");
  bind_recipe(type);
}

}  // namespace phrame::python
