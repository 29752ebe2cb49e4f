#include <deque>
#include <sstream>

#include "values.hpp"

namespace phrame::inline v0::python {
namespace {

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

std::string shown_real(const RealNumber& x) {
  return without_gil([value = x.value] {
    try {
      return round_to_decimal(value, 17).value;
    } catch (const Undecided&) {
      std::ostringstream out;
      out << value;
      return out.str();
    }
  });
}

// ---- arithmetic

/// A number with what is known of it.
struct Known {
  Real value;
  ZeroBound bound;
  long depth = 0;
};

Known known(nb::handle x, const std::string& place) {
  if (nb::isinstance<RealNumber>(x)) {
    const auto& number = nb::cast<const RealNumber&>(x);
    return {number.value, number.bound, number.depth};
  }
  const Rational exact = rational(x, place);
  return {exact, zero_bound(exact)};
}

/// Some numbers have no arithmetic of their own: of pyarrow, of old releases of python-flint.
bool is_no_number(nb::handle x) {
  if (PyNumber_Check(x.ptr()) != 0) return false;
  if (PyUnicode_Check(x.ptr()) != 0) return true;
  try {
    return imported("phrame._numbers", "number")(x, "operand").is_none();
  } catch (nb::python_error&) {
    return true;
  }
}

/// Is the other operand's type asked what to do with a number: an array, a quantity?
bool is_left_to(nb::handle x) {
  if (nb::isinstance<RealNumber>(x)) return false;
  if (is_list(x) || is_no_number(x)) return true;
  return nb::hasattr(x, "__array_ufunc__") && !nb::isinstance(x, imported("numpy", "generic"));
}

/// ±∞ or NaN, of whatever type.
std::optional<double> infinity_or_nan(nb::handle x) {
  if (PyFloat_Check(x.ptr()) != 0) {
    const double d = PyFloat_AsDouble(x.ptr());
    return std::isfinite(d) ? std::nullopt : std::optional(d);
  }
  if (PyLong_Check(x.ptr()) != 0 || PyUnicode_Check(x.ptr()) != 0 ||
      nb::isinstance<RealNumber>(x) || x.type().is(imported("fractions", "Fraction")))
    return std::nullopt;
  constexpr double infinity = std::numeric_limits<double>::infinity();
  try {
    if (x.equal(nb::float_(infinity))) return infinity;
    if (x.equal(nb::float_(-infinity))) return -infinity;
    // A ball with a radius is not equal to itself, either.
    if (!x.equal(x) && std::isnan(nb::cast<double>(nb::float_(x)))) return std::nan("");
  } catch (nb::python_error&) {  // a signalling NaN, which is refused as no number
  }
  return std::nullopt;
}

/// Were both computed in the same way from the same objects? Then they are equal.
bool have_same_recipe(nb::handle x, nb::handle y) {
  return nb::cast<bool>(imported("phrame._pickle", "same")(x, y));
}

/// The y that changes no x in x ∘ y, and whether it changes none in y ∘ x.
std::pair<bool, Rational> neutral_of(std::string_view name) {
  return {name == "add" || name == "mul", name == "add" || name == "sub" ? 0 : 1};
}

/// x ∘ y as `name` of the module operator has it, so that it is pickled as that.
template <class F>
nb::object combined(nb::handle x, nb::handle y, const char* name, const F& f) {
  if (is_left_to(x) || is_left_to(y)) return nb::borrow(Py_NotImplemented);
  if (infinity_or_nan(x) || infinity_or_nan(y))
    return imported("phrame._real", "beside_infinity")(name, x, y);
  const Known a = known(x, "operand");
  const Known b = known(y, "operand");
  const auto [is_either, neutral] = neutral_of(name);
  if (b.value.exact() == neutral) return nb::borrow(x);
  if (is_either && a.value.exact() == neutral) return nb::borrow(y);
  const Known found = f(a, b);
  return to_python(found.value, recipe(imported("operator", name), nb::borrow(x), nb::borrow(y)),
                   found.bound, std::max(a.depth, b.depth) + 1);
}

Known sum(const Known& a, const Known& b) { return {a.value + b.value, of_sum(a.bound, b.bound)}; }

Known product(const Known& a, const Known& b) {
  return {a.value * b.value, of_product(a.bound, b.bound)};
}

[[noreturn]] void refuse_division_by_zero() {
  PyErr_SetString(PyExc_ZeroDivisionError, "division by zero");
  throw nb::python_error();
}

Known ratio(const Known& a, const Known& b) {
  if (b.value.exact() == Rational(0)) refuse_division_by_zero();
  return {quotient_of(a.value, b.value), of_product(a.bound, b.bound)};
}

/// xʸ, algebraic where y is an integer or half of one.
Known power(const Known& x, const Known& y) {
  constexpr long most = 100'000;
  if (x.value.exact() == Rational(0) && decided_sign(y.value, y.bound) == -1)
    refuse_division_by_zero();
  if (const auto& exponent = y.value.exact()) {
    const Rational twice = 2 * *exponent;
    if (denominator(twice) == 1 && abs(twice) <= most) {
      const auto k = static_cast<long>(numerator(twice));
      if (k % 2 == 0) return {power_of(x.value, k / 2), of_power(x.bound, k / 2)};
      return {power_of(elementary("sqrt", x.value, false), k),
              of_power(of_square_root(x.bound), k)};
    }
  }
  return {power_of(x.value, y.value), {}};
}

nb::object negative(nb::handle x) {
  const Known a = known(x, "x");
  return to_python(-a.value, recipe(imported("operator", "neg"), nb::borrow(x)), a.bound,
                   a.depth + 1);
}

nb::object difference(nb::handle x, nb::handle y) {
  if (nb::isinstance<RealNumber>(x) && nb::isinstance<RealNumber>(y) && have_same_recipe(x, y))
    return to_python(Rational(0));
  if (PyLong_Check(x.ptr()) != 0 && PyObject_Not(x.ptr()) == 1) return negative(y);
  return combined(x, y, "sub", [](const Known& a, const Known& b) {
    return Known{a.value + -b.value, of_sum(a.bound, b.bound)};
  });
}

/// √ and others, by NumPy's names.
nb::object function_of(nb::handle x, const char* name) {
  const Known a = known(x, "x");
  const Real value = without_gil(
      [a, name = std::string_view(name)] { return elementary(name, a.value, a.bound.is_known()); });
  const bool is_root = std::string_view(name) == "sqrt";
  return to_python(value, recipe(imported("operator", "methodcaller")(name), nb::borrow(x)),
                   is_root ? of_square_root(a.bound) : ZeroBound(), a.depth + 1);
}

nb::object arctan2(nb::handle y, nb::handle x) {
  const Known a = known(y, "x1");
  const Known b = known(x, "x2");
  return to_python(
      without_gil([a, b] { return arctan2_of(a.value, b.value); }),
      recipe(imported("operator", "methodcaller")("arctan2", nb::borrow(x)), nb::borrow(y)), {},
      std::max(a.depth, b.depth) + 1);
}

// ---- order

/// −1, 0 or 1 for x − y. First with few bits; where these do not do by how both were computed, and
/// by algebra.
int compared(nb::handle x, nb::handle y) {
  const Known a = known(x, "x");
  const Known b = known(y, "other");
  const Real off = a.value + -b.value;
  const auto with_few_bits = [off] {
    for (long bits = 64; bits <= 512; bits *= 2)
      if (const int found = sign(off.enclose(bits)); found != 0) return found;
    return 0;
  };
  if (off.exact()) return off.exact()->sign();
  if (const int found = without_gil(with_few_bits); found != 0) return found;
  if (have_same_recipe(x, y)) return 0;
  const auto found =
      without_gil([off, bound = of_sum(a.bound, b.bound)] { return decided_sign(off, bound); });
  if (!found) throw Undecided("comparison: the numbers are equal as far as their digits tell");
  return *found;
}

/// What is compared to NaN and infinities; no value for other numbers.
template <class Holds>
std::optional<bool> beside_infinity(nb::handle y, const Holds& holds) {
  const auto d = infinity_or_nan(y);
  if (!d) return std::nullopt;
  return !std::isnan(*d) && holds(*d > 0 ? -1 : 1);
}

template <class Holds>
nb::object ordered(nb::handle x, nb::handle y, const Holds& holds) {
  if (PyUnicode_Check(y.ptr()) == 0 && is_left_to(y)) return nb::borrow(Py_NotImplemented);
  if (const auto found = beside_infinity(y, holds)) return nb::bool_(*found);
  return nb::bool_(holds(compared(x, y)));
}

/// What is no number is another object.
nb::object is_equal(nb::handle x, nb::handle y) {
  if (x.is(y)) return nb::bool_(true);
  if (is_left_to(y)) return nb::borrow(Py_NotImplemented);
  if (const auto found = beside_infinity(y, [](int) { return false; })) return nb::bool_(*found);
  try {
    known(y, "other");
  } catch (nb::python_error&) {
    return nb::borrow(Py_NotImplemented);
  }
  return nb::bool_(compared(x, y) == 0);
}

/// That of the Fraction which it is, else that of the nearest double: equal numbers have one.
Py_hash_t hash_of(const RealNumber& x) {
  const auto known = without_gil([x = x.value, bound = x.bound]() -> std::pair<Real, double> {
    const Real value = settled(x, bound);
    if (value.exact()) return {value, 0};
    try {
      return {value, round_to_double(value)};
    } catch (const Undecided&) {
      return {value, 0};
    }
  });
  return nb::hash(known.first.exact() ? to_python(*known.first.exact())
                                      : nb::object(nb::float_(known.second)));
}

/// |x|, whose sign need not be known.
nb::object absolute_value(nb::handle x) {
  const auto& number = nb::cast<const RealNumber&>(x);
  const auto found = without_gil(
      [value = number.value, bound = number.bound] { return decided_sign(value, bound); });
  if (found == 0) return to_python(Rational(0));
  if (found == 1) return nb::borrow(x);
  if (found == -1) return negative(x);
  return to_python(Real([value = number.value](long bits) { return absolute(value.enclose(bits)); },
                        {false, number.value.origin().bits}),
                   recipe(imported("operator", "abs"), nb::borrow(x)), {}, number.depth + 1);
}

/// ⌊x⌋, ⌈x⌉ or what is between 0 and x.
enum class Cut { floor, ceil, trunc };

nb::object cut(const RealNumber& x, Cut how) {
  const auto found = without_gil([x = x.value, bound = x.bound, how]() -> std::optional<Integer> {
    const Real value = settled(x, bound);
    auto below = decided_floor(value);
    if (!below || (value.exact() && denominator(*value.exact()) == 1)) return below;
    if (how == Cut::ceil || (how == Cut::trunc && *below < 0)) return Integer(*below + 1);
    return below;
  });
  if (!found) throw Undecided("floor: the number is an integer as far as its digits tell");
  return to_python(*found);
}

// ---- what Python sees

using RealType = nb::class_<RealNumber>;
#define PHRAME_NUMBER_SIG "fractions.Fraction | Real"

void bind_digits(RealType& type) {
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
           [](const RealNumber& x) { return "$" + latex_decimal(shown_real(x)) + "\\ldots$"; });
}

void bind_arithmetic(RealType& type) {
  type.def("__neg__", negative, nb::sig("def __neg__(self) -> " PHRAME_NUMBER_SIG))
      .def(
          "__pos__", [](nb::handle x) { return nb::borrow(x); },
          nb::sig("def __pos__(self) -> Real"))
      .def("__abs__", absolute_value, nb::sig("def __abs__(self) -> " PHRAME_NUMBER_SIG))
      .def("__sub__", difference, argument("other"),
           nb::sig("def __sub__(self, other: Real | Number) -> " PHRAME_NUMBER_SIG))
      .def(
          "__rsub__", [](nb::handle x, nb::handle y) { return difference(y, x); },
          argument("other"), nb::sig("def __rsub__(self, other: Number) -> " PHRAME_NUMBER_SIG));
#define PHRAME_OPERATOR(name, of, f)                                                         \
  type.def(                                                                                  \
          "__" name "__", [](nb::handle x, nb::handle y) { return combined(x, y, of, f); },  \
          argument("other"),                                                                 \
          nb::sig("def __" name "__(self, other: Real | Number) -> " PHRAME_NUMBER_SIG))     \
      .def(                                                                                  \
          "__r" name "__", [](nb::handle x, nb::handle y) { return combined(y, x, of, f); }, \
          argument("other"),                                                                 \
          nb::sig("def __r" name "__(self, other: Number) -> " PHRAME_NUMBER_SIG))
  PHRAME_OPERATOR("add", "add", sum);
  PHRAME_OPERATOR("mul", "mul", product);
  PHRAME_OPERATOR("truediv", "truediv", ratio);
  PHRAME_OPERATOR("pow", "pow", power);
#undef PHRAME_OPERATOR
#define PHRAME_BY_FLOOR(name, result)                                     \
  bind_python(type, "__" name "__", "phrame._real", name,                 \
              "def __" name "__(self, other: Real | Number) -> " result); \
  bind_python(type, "__r" name "__", "phrame._real", "r" name,            \
              "def __r" name "__(self, other: Number) -> " result)
  PHRAME_BY_FLOOR("floordiv", "int");
  PHRAME_BY_FLOOR("mod", PHRAME_NUMBER_SIG);
  PHRAME_BY_FLOOR("divmod", "tuple[int, " PHRAME_NUMBER_SIG "]");
#undef PHRAME_BY_FLOOR
}

void bind_order(RealType& type) {
#define PHRAME_COMPARISON(name, sign)                                 \
  type.def(                                                           \
      "__" name "__",                                                 \
      [](nb::handle x, nb::handle y) {                                \
        return ordered(x, y, [](int found) { return found sign 0; }); \
      },                                                              \
      argument("other"), nb::sig("def __" name "__(self, other: Real | Number) -> bool"))
  PHRAME_COMPARISON("lt", <);
  PHRAME_COMPARISON("le", <=);
  PHRAME_COMPARISON("gt", >);
  PHRAME_COMPARISON("ge", >=);
#undef PHRAME_COMPARISON
#define PHRAME_CUT(name, how)                                               \
  type.def(                                                                 \
      "__" name "__", [](const RealNumber& x) { return cut(x, Cut::how); }, \
      nb::sig("def __" name "__(self) -> int"))
  PHRAME_CUT("floor", floor);
  PHRAME_CUT("ceil", ceil);
  PHRAME_CUT("trunc", trunc);
  PHRAME_CUT("int", trunc);
#undef PHRAME_CUT
  type.def("__eq__", is_equal, argument("other"),
           nb::sig("def __eq__(self, other: object) -> bool"))
      .def("__hash__", hash_of)
      .def("__bool__", [](nb::handle x) { return compared(x, nb::int_(0)) != 0; });
  bind_python(type, "__round__", "phrame._real", "rounded",
              "@typing.overload\ndef __round__(self, ndigits: None = None) -> int: ...\n"
              "@typing.overload\ndef __round__(self, ndigits: int) -> fractions.Fraction");
  bind_python(type, "__format__", "phrame._real", "formatted",
              "def __format__(self, spec: str, /) -> str");
}

/// Under the names that NumPy asks the elements of arrays of objects for.
void bind_functions(RealType& type) {
  static auto& texts = *new std::deque<std::string>();  // which Python's functions point to
  for (const std::string_view name : elementary_functions()) {
    const std::string& kept = texts.emplace_back(name);
    const std::string& signature =
        texts.emplace_back("def " + kept + "(self) -> " PHRAME_NUMBER_SIG);
    const std::string& what = texts.emplace_back("The function " + kept + " of the number.");
    type.def(
        kept.c_str(), [at = kept.c_str()](nb::handle x) { return function_of(x, at); },
        nb::sig(signature.c_str()), what.c_str());
  }
  type.def("arctan2", arctan2, argument("x"),
           nb::sig("def arctan2(self, x: Real | Number) -> " PHRAME_NUMBER_SIG),
           "The angle of the point (x, self), in (-pi, pi].")
      .def(
          "conjugate", [](nb::handle x) { return nb::borrow(x); },
          nb::sig("def conjugate(self) -> Real"), "Itself.")
      .def_prop_ro(
          "real", [](nb::handle x) { return nb::borrow(x); }, nb::sig("def real(self) -> Real"),
          "Itself.")
      .def_prop_ro(
          "imag", [](nb::handle) { return 0; }, nb::sig("def imag(self) -> int"), "0.");
}

}  // namespace

void bind_real(nb::module_& m) {
  RealType type(m, "Real",
                "A real number that is known exactly by what it was computed from: any number of "
                "its digits. Equality and order are decided by algebra where it is algebraic, and "
                "where both numbers were computed in the same way; what is equal but not known to "
                "be raises Undecided.");
  bind_digits(type);
  bind_arithmetic(type);
  bind_order(type);
  bind_functions(type);
  type.def(
      "__reduce__", [](const RealNumber& x) { return x.recipe; }, PHRAME_REDUCE_SIG);
  bind_copies(type);
  m.def(
      "_exact",
      [](nb::handle x) -> nb::object {
        try {
          return to_python(rational(x, "x"));
        } catch (nb::python_error&) {
          return nb::none();
        }
      },
      nb::arg().none(), "The Fraction that a number or a text is; None where it is none.");
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
        return to_python(
            real_root(polynomial(p, "polynomial"),
                      closed_interval(rational(lower, "lower"), rational(upper, "upper"))));
      },
      argument("polynomial"), argument("lower"), argument("upper"),
      nb::sig("def root(polynomial: Polynomial | collections.abc.Sequence[Number], lower: "
              "Number, upper: Number) -> fractions.Fraction | Real"),
      "The only real root of the polynomial in [lower, upper].");
}

}  // namespace phrame::python
