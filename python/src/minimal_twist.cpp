#include "answers.hpp"
#include "arrays.hpp"

namespace phrame::inline v0::python {
namespace {

struct MinimalTwistObject {
  MinimalTwist twist;
  nb::object recipe;
};

Integer turns_of(nb::handle extra_turns) {
  if (PyBool_Check(extra_turns.ptr()) || PyIndex_Check(extra_turns.ptr()) == 0)
    refuse_type("extra_turns", "an int", extra_turns);
  return numerator(rational(extra_turns, "extra_turns"));
}

/// An angle, or the vector that f₂ is along, or None.
FrameStart end_of_frame(nb::handle x, const std::string& place) {
  if (x.is_none()) return LeastRotation();
  if (is_list(x)) return StartNormal(vector(x, place));
  return angle_number(x, place);
}

nb::object kept_end(const FrameStart& end, nb::handle given) {
  const auto* along = std::get_if<StartNormal>(&end);
  return along == nullptr ? nb::borrow(given) : to_python(along->vector);
}

nb::object minimal_twist(nb::handle self, nb::handle from, nb::handle to, nb::handle extra_turns,
                         nb::handle up) {
  const Path& path = path_of(self).named.path;
  const FrameStart start = end_of_frame(from, "start");
  const FrameStart end = end_of_frame(to, "end");
  const Integer turns = turns_of(extra_turns);
  const PathAngle angle =
      up.is_none() ? without_gil([path] { return PathAngle(path); }) : angle_to_up(path, up);
  return nb::cast(MinimalTwistObject{
      without_gil([=] { return phrame::minimal_twist(angle, start, end, turns); }),
      method_recipe(self, "minimal_twist", kept_end(start, from), kept_end(end, to), extra_turns,
                    up.is_none() ? nb::none() : to_python(vector(up, "up")))});
}

nb::object rational_of(nb::handle self, nb::handle degree, Flag<"free_ends"> has_free_ends,
                       nb::handle subdivide, nb::handle gamma, Flag<"proved"> is_proved) {
  const MinimalTwist& twist = nb::cast<const MinimalTwistObject&>(self).twist;
  return rational_twist(self, twist, degree, has_free_ends, subdivide, gamma, is_proved);
}

}  // namespace

void bind_minimal_twist(nb::module_& m, PathClass& path) {
  path.def(
      "minimal_twist", minimal_twist, argument("start") = nb::none(), argument("end") = nb::none(),
      argument("extra_turns") = 0, argument("up") = nb::none(),
      nb::sig("def minimal_twist(self, start: Number | Vector | None = None, end: Number | "
              "Vector | None = None, extra_turns: int = 0, " PHRAME_UP_SIG ") -> MinimalTwist"),
      "The frame that turns least from `start` to `end`: angles to the Euler–Rodrigues frame "
      "of PH curves, else or with `up` to the frame of that; or vectors that f2 is along; or "
      "None for the least rotation that takes the x axis to the tangent there, which takes "
      "the y axis to f2.");
  bind_rational_twist(m);
  auto type = nb::class_<MinimalTwistObject>(
      m, "MinimalTwist", "The exact frame of minimal twist: docs/minimal-twist.md.");
  using T = MinimalTwistObject;
#define PHRAME_TWIST(name, of, what)                                \
  type.def_prop_ro(                                                 \
      name,                                                         \
      [](nb::handle self) {                                         \
        const MinimalTwist& twist = nb::cast<const T&>(self).twist; \
        return to_python(of, attribute_recipe(self, name));         \
      },                                                            \
      nb::sig("def " name "(self) -> fractions.Fraction | Real"), what)
  PHRAME_TWIST("twist", twist.twist(), "How far it turns about the tangent, in radians.");
  PHRAME_TWIST("nominal_twist", twist.nominal_twist(),
               "The same before whole turns are taken off.");
  PHRAME_TWIST("erf_twist", twist.own_twist(),
               "Of the frame that angles are to, that of Euler–Rodrigues or of `up`.");
  PHRAME_TWIST("rate", twist.rate(), "The twist per unit of arc length.");
  PHRAME_TWIST("length", twist.length(), "Of the path.");
#undef PHRAME_TWIST
  type.def_prop_ro(
      "half_turn_within",
      [](const T& self) -> nb::object {
        const auto& within = self.twist.half_turn_within();
        return within ? to_python(*within) : nb::none();
      },
      nb::sig("def half_turn_within(self) -> fractions.Fraction | None"),
      "Where the twist, without extra turns, is half a turn or not told from that: at most so far "
      "is it from π. −π is as short, and π was taken. Else None.");
  type.def("rational", rational_of, argument("degree") = 2, argument("free_ends") = false,
           argument("subdivide") = nb::tuple(), argument("gamma") = nb::none(),
           argument("proved") = true,
           nb::sig("def rational(self, degree: int = 2, free_ends: bool = False, subdivide: "
                   "collections.abc.Sequence[Number] = (), gamma: Number | None = None, proved: "
                   "bool = True) -> RationalTwist"),
           "The rational frame that turns most evenly, along PH curves and splines: the "
           "Euler–Rodrigues frame turned by 2 arg w, w of this degree, with the rate Ω̄₁ at both "
           "ends unless `free_ends`. `subdivide` has parameters where it is divided and the words "
           "\"inflections\", \"extrema\", \"auto\" and \"rms:X\" (docs/minimal-twist.md); `gamma` "
           "asks for "
           "the w with this γ instead of the best one, and `proved=False` for no proof.");
  type.def(
      "frames",
      [](const T& self, nb::handle ts, nb::handle progress) {
        return twist_frames(self.twist, ts, progress);
      },
      argument("ts"), nb::kw_only(), argument("progress") = nb::none(),
      nb::sig("def frames(self, ts: Numbers, *, " PHRAME_PROGRESS ") -> " PHRAME_ARRAY),
      "Frames as an array (n, 3, 3) with the rows e1, f2, f3, every number correctly rounded.");
  type.def("__repr__", [](const T& t) {
    return "<MinimalTwist " + round_to_decimal(t.twist.twist(), 6).value + " radians>";
  });
  bind_python(type, "_repr_html_", "phrame._show", "twist_html", "def _repr_html_(self) -> str");
  bind_value(type, "The angle to the Euler–Rodrigues frame, or to that of `up`.",
             [](const T& self) {
               return [twist = self.twist](const Rational& t) { return twist.value(t); };
             });
  bind_recipe(type);
}

}  // namespace phrame::python
