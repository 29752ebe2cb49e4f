#include "answers.hpp"
#include "smooth.hpp"

namespace phrame::python {
namespace {

struct SmoothAngleObject {
  NamedPath named;
  SmoothAngle angle;
  FrameStart start;
  Real start_angle;
  nb::object recipe;
};

SmoothReference smooth_reference(const std::string& name) {
  return chosen<SmoothReference>(
      name, "frame", {{"up", SmoothReference::up}, {"frenet", SmoothReference::frenet}});
}

nb::object make_smooth_angle(nb::handle self, const Text<"frame">& frame, nb::handle up,
                             nb::handle start, nb::handle start_normal) {
  const NamedPath& named = nb::cast<const SmoothPathObject&>(self).named;
  const SmoothReference reference = smooth_reference(frame);
  if (reference == SmoothReference::frenet && !up.is_none())
    refuse("up", "the angle is to the Frenet frame", up);
  SmoothAngle angle =
      reference == SmoothReference::frenet
          ? without_gil([path = named.path] { return SmoothAngle(path, SmoothReference::frenet); })
          : angle_to_up(named.path, up);
  const FrameStart from = smooth_start(start, start_normal, StartRule::reference, angle);
  Real at_zero = without_gil([=] { return start_angle(from, angle); });
  const nb::object v = up.is_none() ? nb::none() : to_python(vector(up, "up"));
  const nb::object along =
      start_normal.is_none() ? nb::none() : to_python(vector(start_normal, "start_normal"));
  return nb::cast(
      SmoothAngleObject{named, angle, from, std::move(at_zero),
                        remade("_smooth_angle", self, nb::str(frame.c_str()), v, start, along)});
}

std::string frame_of(const SmoothAngle& angle) {
  if (angle.reference() == SmoothReference::frenet) return "Frenet frame";
  const auto& [x, y, z] = angle.up();
  return "frame of (" + to_string(x) + ", " + to_string(y) + ", " + to_string(z) + ")";
}

/// θ(t).
auto value_of(const SmoothAngleObject& self) {
  return [angle = self.angle, start = self.start_angle](const Rational& t) {
    return angle.value(locate(angle.path(), t)) + start;
  };
}

SmoothAngleAnswer smooth_answer(const SmoothAngleObject& self) {
  SmoothAngleQuery query;
  query.reference = self.angle.reference();
  if (query.reference == SmoothReference::up) query.up = self.angle.up();
  query.start = self.start;
  return without_gil([named = self.named, query] { return answer(named, query); });
}

nb::object smooth_angle_of_what(const SmoothAngleObject& self, nb::handle ts, nb::handle progress) {
  if (!is_list(ts)) {
    const Rational t = rational(ts, "ts");
    return nb::float_(at_place("ts", [&] {
      return without_gil([value = value_of(self), t] { return round_to_double(value(t)); });
    }));
  }
  return smooth_angles(self.angle, self.start_angle, ts, progress);
}

}  // namespace

void bind_smooth_angle(nb::module_& m, nb::class_<SmoothPathObject>& smooth) {
  m.def("_smooth_angle", make_smooth_angle, argument("path"), argument("frame"), argument("up"),
        argument("start"), argument("start_normal"));
  smooth.def(
      "angle", make_smooth_angle, argument("frame") = "up", argument("up") = nb::none(),
      PHRAME_START_PARAMETERS,
      nb::sig("def angle(self, frame: str = 'up', up: Vector | None = None, " PHRAME_START_SIG
              ") -> SmoothAngle"),
      "The angle of the rotation-minimizing frame to the frame of a vector `up`, e2 = up × "
      "e1/|up × e1|, or of a curve to its Frenet frame.");
  auto type = nb::class_<SmoothAngleObject>(
      m, "SmoothAngle",
      "The angle θ(t) of the rotation-minimizing frame of a path of any kind: without a closed "
      "form, to any number of digits.");
  bind_value(type,
             "θ(t): a Fraction where it is rational, else a Real; with `digits` a Decimal with so "
             "many.",
             [](const SmoothAngleObject& self) { return value_of(self); });
  using A = SmoothAngleObject;
  type.def("__call__", smooth_angle_of_what, argument("ts"), nb::kw_only(),
           argument("progress") = nb::none(),
           nb::sig("@typing.overload\ndef __call__(self, ts: float | fractions.Fraction | "
                   "decimal.Decimal, *, progress: "
                   "collections.abc.Callable[[int, int], object] | None = None) -> float: ...\n"
                   "@typing.overload\ndef __call__(self, ts: Numbers, *, progress: "
                   "collections.abc.Callable[[int, int], object] | None = None) -> "
                   "numpy.typing.NDArray[numpy.float64]"),
           "θ as correctly rounded doubles: of one parameter, or an array of many.")
      .def_prop_ro(
          "path", [](const A& self) { return nb::cast(SmoothPathObject{self.named}); },
          nb::sig("def path(self) -> SmoothPath"), "Along which it is.")
      .def_prop_ro(
          "up", [](const A& self) { return to_python(self.angle.up()); },
          nb::sig("def up(self) -> tuple[fractions.Fraction, fractions.Fraction, "
                  "fractions.Fraction]"),
          "v, to whose frame it is unless it is to the Frenet frame.")
      .def_prop_ro(
          "is_zero", [](const A& self) { return self.angle.is_zero(); },
          "Is θ the same all along, as in a plane with its normal for `up`?")
      .def(
          "text", [](const A& self) { return for_reading(to_text(smooth_answer(self)), true); },
          "What it is, for reading.")
      .def(
          "latex", [](const A& self) { return to_latex(smooth_answer(self)); },
          "The same for LaTeX.")
      .def(
          "json", [](const A& self) { return to_json(smooth_answer(self)); },
          "angle/1 or spline-angle/1.")
      .def("__repr__",
           [](const A& self) {
             return "<SmoothAngle to the " + frame_of(self.angle) +
                    (self.named.name.empty() ? "" : " of " + abbreviated(self.named.name)) + ">";
           })
      .def("__str__",
           [](const A& self) { return for_reading(to_text(smooth_answer(self)), false); });
  bind_python(type, "plot", "phrame._plot", "angle",
              "def plot(self, ts: Numbers | None = None, *, ax: typing.Any = None, **style: "
              "typing.Any) -> typing.Any",
              "θ over t, by Matplotlib; the axes.");
  bind_python(type, "_repr_html_", "phrame._show", "smooth_angle_html",
              "def _repr_html_(self) -> str");
  bind_recipe(type);
}

}  // namespace phrame::python
