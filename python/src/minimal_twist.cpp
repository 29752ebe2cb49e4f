#include "answers.hpp"

namespace phrame::python {
namespace {

struct MinimalTwistObject {
  MinimalTwist twist;
  nb::object recipe;
};

nb::object minimal_twist(nb::handle self, nb::handle from, nb::handle to, nb::handle extra_turns) {
  const auto& named = nb::cast<const PathObject&>(self).named;
  const Angle a = angle_number(from, "start");
  const Angle b = angle_number(to, "end");
  if (PyIndex_Check(extra_turns.ptr()) == 0) refuse_type("extra_turns", "an int", extra_turns);
  const Integer turns = numerator(rational(extra_turns, "extra_turns"));
  return nb::cast(MinimalTwistObject{
      without_gil([&] { return MinimalTwist(PathAngle(named.path), a, b, turns); }),
      method_recipe(self, "minimal_twist", from, to, extra_turns)});
}

}  // namespace

void bind_minimal_twist(nb::module_& m, nb::class_<PathObject>& path) {
  path.def("minimal_twist", minimal_twist, nb::arg("start"), nb::arg("end"),
           nb::arg("extra_turns") = 0,
           nb::sig("def minimal_twist(self, start: Number, end: Number, extra_turns: int = 0) -> "
                   "MinimalTwist"),
           "The frame that turns least from the angle `start` at the start to `end` at the end.");
  auto type = nb::class_<MinimalTwistObject>(
      m, "MinimalTwist", "The exact frame of minimal twist: docs/minimal-twist.md.");
  using T = MinimalTwistObject;
#define PHRAME_TWIST(name, of, what)                                                         \
  type.def_prop_ro(                                                                          \
      name,                                                                                  \
      [](nb::handle self) {                                                                  \
        return to_python(nb::cast<const T&>(self).twist.of(), attribute_recipe(self, name)); \
      },                                                                                     \
      nb::sig("def " name "(self) -> fractions.Fraction | Real"), what)
  PHRAME_TWIST("twist", twist, "How far it turns about the tangent, in radians.");
  PHRAME_TWIST("nominal_twist", nominal_twist, "The same before whole turns are taken off.");
  PHRAME_TWIST("erf_twist", erf_twist, "Of the Euler–Rodrigues frame.");
  PHRAME_TWIST("rate", rate, "The twist per unit of arc length.");
#undef PHRAME_TWIST
  type.def_prop_ro(
          "length", [](const T& t) { return to_python(t.twist.length()); },
          nb::sig("def length(self) -> fractions.Fraction"))
      .def("__repr__", [](const T& t) {
        return "<MinimalTwist " + round_to_decimal(t.twist.twist(), 6).value + " radians>";
      });
  bind_value(type, "The angle to the Euler–Rodrigues frame.",
             [](const T& self, const Rational& t) { return self.twist.value(t); });
  bind_recipe(type);
}

}  // namespace phrame::python
