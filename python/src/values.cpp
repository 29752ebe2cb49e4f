#include "values.hpp"

#include <nanobind/operators.h>

#include <sstream>

namespace phrame::python {
namespace {

template <class T>
std::string streamed(const T& x) {
  std::ostringstream out;
  out << x;
  return out.str();
}

nb::object decimal_digits(const RealNumber& x, nb::handle digits) {
  const long n = count(digits, "n", 1, 1'000'000);
  return to_decimal(without_gil([value = x.value, n] { return round_to_decimal(value, n).value; }));
}

nb::object ball_of(const RealNumber& x, nb::handle bits) {
  const long wanted = count(bits, "bits", 1, 10'000'000);
  const auto found = without_gil([value = x.value, wanted]() -> std::optional<RealBall> {
    for (long more = wanted + 8; more <= 16 * wanted + 100'000; more *= 2)
      if (RealBall ball = value.enclose(more); ball.is_finite() && ball.is_accurate(wanted))
        return ball;
    return std::nullopt;
  });
  if (!found)
    throw Undecided("ball: no enclosure of " + std::to_string(wanted) + " bits was found");
  return ends(*found);
}

/// −1, 0 or 1 for x − y.
int compared(const RealNumber& x, nb::handle y) {
  const Real off = x.value + -real(y, "other");
  if (off.exact()) return off.exact()->sign();
  constexpr long most = 1L << 16;
  const int found = without_gil([off] {
    for (long bits = 64; bits <= most; bits *= 2)
      if (const int which = sign(off.enclose(bits)); which != 0) return which;
    return 0;
  });
  if (found != 0) return found;
  throw Undecided("comparison: " + std::to_string(most) + " bits do not tell the numbers apart");
}

std::string shown_real(const RealNumber& x) {
  return without_gil([value = x.value] {
    try {
      return round_to_decimal(value, 17).value;
    } catch (const Undecided&) {
      return streamed(value);
    }
  });
}

bool is_number(nb::handle x) {
  return nb::isinstance<RealNumber>(x) || PyNumber_Check(x.ptr()) != 0;
}

/// x ∘ y as `name` of the module operator has it, so that it is pickled as that.
template <class F>
nb::object combined(nb::handle x, nb::handle y, const char* name, const F& f) {
  if (!is_number(x) || !is_number(y)) return nb::borrow(Py_NotImplemented);
  return to_python(f(real(x, "operand"), real(y, "operand")),
                   recipe(imported("operator", name), nb::borrow(x), nb::borrow(y)));
}

void bind_real(nb::module_& m) {
  auto type = nb::class_<RealNumber>(m, "Real",
                                     "A real number that is known exactly by what it was computed "
                                     "from: any number of its digits.");
  type.def("__float__",
           [](const RealNumber& x) {
             return without_gil([value = x.value] { return round_to_double(value); });
           })
      .def("digits", decimal_digits, argument("n"),
           nb::sig("def digits(self, n: int) -> decimal.Decimal"),
           "The number with n significant digits, correctly rounded.")
      .def(
          "ball", ball_of, argument("bits"),
          nb::sig("def ball(self, bits: int) -> tuple[fractions.Fraction, fractions.Fraction]"),
          "Two fractions with the number between them, at most 2**(1 - bits)*max(1, abs(x)) apart.")
      .def(
          "mpmath",
          [](nb::handle x, nb::handle bits) { return imported("phrame._convert", "mpf")(x, bits); },
          argument("bits") = nb::none(),
          nb::sig("def mpmath(self, bits: int | None = None) -> typing.Any"),
          "An mpmath.mpf, correctly rounded to so many bits, or to mpmath's precision.")
      .def(
          "_mpmath_",
          [](nb::handle x, nb::handle prec, nb::handle) {
            return imported("phrame._convert", "mpf")(x, prec);
          },
          argument("prec"), argument("rounding"),
          nb::sig("def _mpmath_(self, prec: int, rounding: object) -> typing.Any"))
      .def(
          "sympy",
          [](nb::handle x, nb::handle digits) {
            return imported("phrame._convert", "sympy_float")(x, digits);
          },
          argument("digits") = 17, nb::sig("def sympy(self, digits: int = 17) -> typing.Any"),
          "A sympy.Float with so many digits.")
      .def(
          "_sympy_", [](nb::handle x) { return imported("phrame._convert", "sympy_float")(x, 17); },
          nb::sig("def _sympy_(self) -> typing.Any"))
      .def(
          "flint",
          [](nb::handle x, nb::handle bits) { return imported("phrame._convert", "arb")(x, bits); },
          argument("bits") = 53, nb::sig("def flint(self, bits: int = 53) -> typing.Any"),
          "A flint.arb that holds the number.")
      .def("__repr__", [](const RealNumber& x) { return "Real('" + shown_real(x) + "…')"; })
      .def("__str__", [](const RealNumber& x) { return shown_real(x); })
      .def("_repr_latex_",
           [](const RealNumber& x) { return "$" + latex_decimal(shown_real(x)) + "\\ldots$"; })
      .def("__bool__", [](const RealNumber& x) { return compared(x, nb::int_(0)) != 0; })
      .def(
          "__neg__",
          [](nb::handle x) {
            return to_python(-real(x, "x"), recipe(imported("operator", "neg"), nb::borrow(x)));
          },
          nb::sig("def __neg__(self) -> fractions.Fraction | Real"))
      .def(
          "__pos__", [](nb::handle x) { return nb::borrow(x); },
          nb::sig("def __pos__(self) -> Real"))
      .def(
          "__abs__",
          [](nb::handle x) {
            const auto& number = nb::cast<const RealNumber&>(x);
            if (compared(number, nb::int_(0)) >= 0) return nb::borrow(x);
            return to_python(-number.value, recipe(imported("operator", "neg"), nb::borrow(x)));
          },
          nb::sig("def __abs__(self) -> fractions.Fraction | Real"))
      .def(
          "__reduce__", [](const RealNumber& x) { return x.recipe; }, PHRAME_REDUCE_SIG);
  const auto plus = [](const Real& x, const Real& y) { return x + y; };
  const auto minus = [](const Real& x, const Real& y) { return x + -y; };
  const auto times = [](const Real& x, const Real& y) { return x * y; };
  const auto over = [](const Real& x, const Real& y) {
    if (y.exact() == Rational(0)) {
      PyErr_SetString(PyExc_ZeroDivisionError, "division by zero");
      throw nb::python_error();
    }
    return quotient_of(x, y);
  };
#define PHRAME_OPERATOR(name, of, f)                                                            \
  type.def(                                                                                     \
          "__" name "__", [f](nb::handle x, nb::handle y) { return combined(x, y, of, f); },    \
          argument("other"),                                                                    \
          nb::sig("def __" name "__(self, other: Real | Number) -> fractions.Fraction | Real")) \
      .def(                                                                                     \
          "__r" name "__", [f](nb::handle x, nb::handle y) { return combined(y, x, of, f); },   \
          argument("other"),                                                                    \
          nb::sig("def __r" name "__(self, other: Number) -> fractions.Fraction | Real"))
  PHRAME_OPERATOR("add", "add", plus);
  PHRAME_OPERATOR("sub", "sub", minus);
  PHRAME_OPERATOR("mul", "mul", times);
  PHRAME_OPERATOR("truediv", "truediv", over);
#undef PHRAME_OPERATOR
#define PHRAME_COMPARISON(name, sign)                                                          \
  type.def(                                                                                    \
      "__" name "__", [](const RealNumber& x, nb::handle y) { return compared(x, y) sign 0; }, \
      argument("other"), nb::sig("def __" name "__(self, other: Real | Number) -> bool"))
  PHRAME_COMPARISON("lt", <);
  PHRAME_COMPARISON("le", <=);
  PHRAME_COMPARISON("gt", >);
  PHRAME_COMPARISON("ge", >=);
#undef PHRAME_COMPARISON
  bind_copies(type);

  m.def(
      "digits",
      [](nb::handle x, nb::handle digits) {
        const long n = count(digits, "n", 1, 1'000'000);
        return to_decimal(
            without_gil([value = real(x, "x"), n] { return round_to_decimal(value, n).value; }));
      },
      argument("x"), argument("n"),
      nb::sig("def digits(x: Real | Number, n: int) -> decimal.Decimal"),
      "The number with n significant digits, correctly rounded, whether it is a Real or rational.");
  m.def(
      "root",
      [](nb::handle p, nb::handle lower, nb::handle upper) {
        return to_python(real_root(polynomial(p, "polynomial"),
                                   closed(rational(lower, "lower"), rational(upper, "upper"))));
      },
      argument("polynomial"), argument("lower"), argument("upper"),
      nb::sig("def root(polynomial: Polynomial | collections.abc.Sequence[Number], lower: "
              "Number, upper: Number) -> fractions.Fraction | Real"),
      "The only real root of the polynomial in [lower, upper].");
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
