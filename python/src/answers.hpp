#pragma once
#include "paths.hpp"

namespace phrame::inline v0::python {

Form form_named(const std::string& name);
Style style_named(const std::string& name);

/// x, or with `digits` a Decimal with so many.
nb::object number_or_digits(const Real& x, nb::handle digits, const nb::object& recipe);

/// Rows of an align* for a notebook, where a formula stands between dollars.
std::string between_dollars(std::string latex);

/// (pole, residue) as doubles, conjugate ones both.
nb::object to_python(const std::optional<PoleTable>& poles);
#define PHRAME_POLES_SIG "tuple[tuple[complex, complex], ...]"

#define PHRAME_VALUE_SIG                                                              \
  nb::sig(                                                                            \
      "@typing.overload\ndef value(self, t: Number, digits: None = None) -> "         \
      "fractions.Fraction | Real: ...\n@typing.overload\ndef value(self, t: Number, " \
      "digits: int) -> decimal.Decimal")

/// value(t, digits) and digits(t, n) of what is a function of t, by f(self)(t), where f(self) owns
/// what it uses.
template <class C, class F>
void bind_value(C& type, const char* what, const F& f) {
  const auto value = [f](nb::handle self, nb::handle t, nb::handle digits, const char* place) {
    const Rational at = rational(t, "t");
    const auto& of = nb::cast<const typename C::Type&>(self);
    const long n = digits.is_none() ? 0 : count(digits, place, 1, 1'000'000);
    return at_place("t", [&] {
      if (n == 0)
        return to_python(without_gil([value = f(of), at] { return value(at); }),
                         method_recipe(self, "value", to_python(at)));
      return to_decimal(
          without_gil([value = f(of), at, n] { return round_to_decimal(value(at), n).value; }));
    });
  };
  type.def(
          "value",
          [value](nb::handle self, nb::handle t, nb::handle digits) {
            return value(self, t, digits, "digits");
          },
          argument("t"), argument("digits") = nb::none(), PHRAME_VALUE_SIG, what)
      .def(
          "digits",
          [value](nb::handle self, nb::handle t, nb::handle n) {
            if (n.is_none()) refuse_type("n", "an int", n);
            return value(self, t, n, "n");
          },
          argument("t"), argument("n"),
          nb::sig("def digits(self, t: Number, n: int) -> decimal.Decimal"),
          "value(t) to n digits, correctly rounded.");
}

/// An object that keeps its recipe is pickled by it.
template <class C>
void bind_recipe(C& type) {
  type.def(
      "__reduce__", [](const typename C::Type& self) { return self.recipe; }, PHRAME_REDUCE_SIG);
  bind_copies(type);
}

void bind_angle(nb::module_& m, PathClass& path);
void bind_integral(nb::module_& m);
void bind_classification(nb::module_& m, PathClass& path);
/// The rational frame of a MinimalTwist, `self`.
nb::object rational_twist(nb::handle self, const MinimalTwist& mtf, nb::handle degree,
                          bool has_free_ends, nb::handle subdivide, nb::handle gamma,
                          bool is_proved);
void bind_rational_twist(nb::module_& m);
void bind_minimal_twist(nb::module_& m, PathClass& path);
void bind_path_twist(nb::module_& m, PathClass& path);
void bind_check(nb::module_& m, PathClass& path);
void bind_certificate(nb::module_& m, PathClass& path);

}  // namespace phrame::python
