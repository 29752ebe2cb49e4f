#include "values.hpp"

#include <nanobind/operators.h>

#include <sstream>

namespace phrame::inline v0::python {
namespace {

template <class T>
std::string streamed(const T& x) {
  std::ostringstream out;
  out << x;
  return out.str();
}

std::string dollars(const std::string& latex) { return "$" + latex + "$"; }

void bind_polynomial(nb::module_& m) {
  auto type =
      nb::class_<Polynomial>(m, "Polynomial", "A polynomial in t with fractions as coefficients.");
  type.def(
          "__init__",
          [](Polynomial* self, nb::handle coefficients) {
            new (self) Polynomial(rationals(coefficients, "coefficients"));
          },
          argument("coefficients"),
          nb::sig("def __init__(self, coefficients: collections.abc.Sequence[Number]) -> None"),
          "Of the coefficients of 1, t, t², …")
      .def_prop_ro(
          "coefficients", [](const Polynomial& p) { return to_python(p.coefficients()); },
          nb::sig("def coefficients(self) -> tuple[fractions.Fraction, ...]"),
          "Of 1, t, t², …; none for 0.")
      .def_prop_ro("degree", &Polynomial::degree, "−1 for 0.")
      .def(
          "__call__",
          [](const Polynomial& p, nb::handle t) { return to_python(p(rational(t, "t"))); },
          argument("t"), nb::sig("def __call__(self, t: Number) -> fractions.Fraction"),
          "The value at t, exactly.")
      .def(
          "derivative", [](const Polynomial& p) { return differentiate(p); }, "By t.")
      .def(nb::self + nb::self)
      .def(nb::self - nb::self)
      .def(nb::self * nb::self)
      .def(-nb::self)
      .def(
          "__eq__",
          [](const Polynomial& p, nb::handle other) {
            return nb::isinstance<Polynomial>(other) && p == nb::cast<const Polynomial&>(other);
          },
          nb::sig("def __eq__(self, other: object) -> bool"))
      .def("__hash__", [](const Polynomial& p) { return nb::hash(to_python(p.coefficients())); })
      .def(
          "sympy",
          [](nb::handle p, nb::handle symbol) {
            return imported("phrame._convert", "sympy_polynomial")(p, symbol);
          },
          argument("symbol") = "t",
          nb::sig("def sympy(self, symbol: typing.Any = 't') -> typing.Any"),
          "A sympy.Poly over QQ.")
      .def(
          "flint",
          [](nb::handle p) { return imported("phrame._convert", "polynomial_for_flint")(p); },
          nb::sig("def flint(self) -> typing.Any"), "For python-flint: a polynomial over ℚ.")
      .def("__str__", [](const Polynomial& p) { return to_string(p); })
      .def("__repr__", [](const Polynomial& p) { return "<Polynomial " + to_string(p) + ">"; })
      .def("_repr_latex_",
           [](const Polynomial& p) { return dollars(formatted(p, Notation::latex)); })
      .def(
          "__reduce__",
          [](nb::handle self) {
            return recipe(nb::borrow(self.type()),
                          to_python(nb::cast<const Polynomial&>(self).coefficients()));
          },
          PHRAME_REDUCE_SIG);
  bind_copies(type);
}

void bind_rational_function(nb::module_& m) {
  auto type = nb::class_<RationalFunction>(m, "RationalFunction",
                                           "A quotient of polynomials in lowest terms.");
  type.def(
          "__init__",
          [](RationalFunction* self, nb::handle n, nb::handle d) {
            new (self) RationalFunction(polynomial(n, "numerator"), polynomial(d, "denominator"));
          },
          argument("numerator"), argument("denominator"),
          nb::sig("def __init__(self, numerator: Polynomial | collections.abc.Sequence[Number], "
                  "denominator: Polynomial | collections.abc.Sequence[Number]) -> None"),
          "Of two polynomials, or lists of coefficients of 1, t, t², …")
      .def_prop_ro(
          "numerator", [](const RationalFunction& f) { return f.numerator(); }, "In lowest terms.")
      .def_prop_ro(
          "denominator", [](const RationalFunction& f) { return f.denominator(); },
          "In lowest terms.")
      .def(
          "__call__",
          [](const RationalFunction& f, nb::handle t) { return to_python(f(rational(t, "t"))); },
          argument("t"), nb::sig("def __call__(self, t: Number) -> fractions.Fraction"),
          "The value at t, exactly.")
      .def(
          "__eq__",
          [](const RationalFunction& f, nb::handle other) {
            return nb::isinstance<RationalFunction>(other) &&
                   f == nb::cast<const RationalFunction&>(other);
          },
          nb::sig("def __eq__(self, other: object) -> bool"))
      .def("__hash__",
           [](const RationalFunction& f) {
             return nb::hash(nb::make_tuple(to_python(f.numerator().coefficients()),
                                            to_python(f.denominator().coefficients())));
           })
      .def(
          "sympy",
          [](const RationalFunction& f, nb::handle symbol) {
            const nb::object& make = imported("phrame._convert", "sympy_polynomial");
            return make(nb::cast(f.numerator()), symbol).attr("as_expr")() /
                   make(nb::cast(f.denominator()), symbol).attr("as_expr")();
          },
          argument("symbol") = "t",
          nb::sig("def sympy(self, symbol: typing.Any = 't') -> typing.Any"), "A SymPy expression.")
      .def("__str__", [](const RationalFunction& f) { return streamed(f); })
      .def("__repr__",
           [](const RationalFunction& f) { return "<RationalFunction " + streamed(f) + ">"; })
      .def(
          "_repr_latex_",
          [](const RationalFunction& f) { return dollars(formatted_quotient(f, Notation::latex)); })
      .def(
          "__reduce__",
          [](nb::handle self) {
            const auto& f = nb::cast<const RationalFunction&>(self);
            return recipe(nb::borrow(self.type()), to_python(f.numerator().coefficients()),
                          to_python(f.denominator().coefficients()));
          },
          PHRAME_REDUCE_SIG);
  bind_copies(type);
}

}  // namespace

Polynomial polynomial(nb::handle x, const std::string& place) {
  if (nb::isinstance<Polynomial>(x)) return nb::cast<const Polynomial&>(x);
  return Polynomial(rationals(x, place));
}

Polynomial polynomial(nb::handle x, const std::string& place, const std::string& basis) {
  if (basis == "power" || nb::isinstance<Polynomial>(x)) return polynomial(x, place);
  const auto list = rationals(x, place);
  if (list.empty()) refuse(place, "there are no coefficients", x);
  return from_bernstein(list);
}

void bind_numbers(nb::module_& m) {
  bind_polynomial(m);
  bind_rational_function(m);
  bind_real(m);
}

}  // namespace phrame::python
