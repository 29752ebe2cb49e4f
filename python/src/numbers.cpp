#include "numbers.hpp"

#include <cmath>
#include <map>

#include "arguments.hpp"

namespace phrame::inline v0::python {
namespace {

std::string type_of(nb::handle x) { return nb::type_name(x.type()).c_str(); }

std::string shown_value(nb::handle x) {
  try {
    return abbreviated(nb::repr(x).c_str());
  } catch (nb::python_error&) {
    return "a " + type_of(x);  // an int too long to be printed, say
  }
}

std::optional<Rational> machine_integer(PyObject* x) {
  int overflow = 0;
  const long long small = PyLong_AsLongLongAndOverflow(x, &overflow);
  if (overflow != 0) return std::nullopt;
  return Rational(static_cast<long>(small));
}

/// Of an int, whatever its size: hexadecimal digits take linear time.
Rational integer(nb::handle x) {
  if (const auto small = machine_integer(x.ptr())) return *small;
  const nb::object text = nb::steal(PyNumber_ToBase(x.ptr(), 16));  // "-0x…"
  if (!text.is_valid()) throw nb::python_error();
  std::string digits = nb::cast<std::string>(text);
  const bool is_negative = digits.front() == '-';
  digits.erase(0, is_negative ? 3 : 2);
  const Integer size(digits, 16);
  return Rational(is_negative ? -size : size);
}

/// A number of Python itself, which has neither a unit nor a mask.
bool is_of_python(nb::handle x) {
  PyObject* const p = x.ptr();
  return PyFloat_Check(p) != 0 || PyLong_Check(p) != 0 ||
         x.type().is(imported("fractions", "Fraction")) ||
         x.type().is(imported("decimal", "Decimal"));
}

bool is_plain_list(nb::handle x) {
  return PyList_CheckExact(x.ptr()) != 0 || PyTuple_CheckExact(x.ptr()) != 0;
}

Rational quotient(nb::handle n, nb::handle d) { return integer(n) / integer(d); }

Rational dyadic(double x, nb::handle value, const std::string& place) {
  if (!std::isfinite(x)) refuse(place, "not a finite number: " + shown_value(value), value);
  return exact_rational(x);
}

/// Of a Decimal, a np.float32, …: a pair of ints; that of NaN and infinities raises.
Rational by_ratio(nb::handle x, const std::string& place) {
  nb::object pair;
  try {
    pair = x.attr("as_integer_ratio")();
  } catch (nb::python_error&) {
    refuse(place, "not a finite number: " + shown_value(x), x);
  }
  return quotient(pair[0], pair[1]);
}

Rational by_text(nb::handle x, const std::string& place) {
  const std::string given = text(x, place);
  try {
    return parse_number(given);
  } catch (const InputError& error) {
    refuse(place, error.reason(), x);
  }
}

/// A Decimal whose exponent would make an integer of a million digits is refused before it does.
void require_modest(nb::handle decimal, const std::string& place) {
  const nb::object parts = decimal.attr("as_tuple")();
  const nb::object exponent = parts.attr("exponent");
  if (!PyLong_Check(exponent.ptr())) return;  // "n", "F"
  int overflow = 0;
  const long e = PyLong_AsLongAndOverflow(exponent.ptr(), &overflow);
  if (overflow != 0 || e > max_number_exponent || e < -max_number_exponent)
    refuse(place,
           "the exponent is beyond " + std::to_string(max_number_exponent) + ": " +
               shown_value(decimal),
           decimal);
}

}  // namespace

nb::object& imported(const char* module, const char* name) {
  // Never freed: Python may be gone by then.
  static auto& known = *new std::map<std::pair<std::string, std::string>, nb::object>();
  static auto& lock = *new nb::ft_mutex();
  {
    const nb::ft_lock_guard guard(lock);
    if (auto& found = known[{module, name}]; found.is_valid()) return found;
  }
  // Not under our lock: an import waits for imports of other threads, which may come to be here.
  const nb::object made = nb::module_::import_(module).attr(name);
  const nb::ft_lock_guard guard(lock);
  auto& found = known[{module, name}];
  if (!found.is_valid()) found = made;
  return found;
}

nb::object readable(const std::string& bytes) {
  return nb::steal(
      PyUnicode_DecodeUTF8(bytes.data(), static_cast<Py_ssize_t>(bytes.size()), "replace"));
}

void refuse(const std::string& place, const std::string& reason, nb::handle value) {
  const nb::object error = imported("phrame._errors", "InputError")(
      readable(place + ": " + reason), nb::arg("place") = place,
      nb::arg("reason") = readable(reason), nb::arg("value") = nb::borrow(value));
  PyErr_SetObject(imported("phrame._errors", "InputError").ptr(), error.ptr());
  throw nb::python_error();
}

void refuse_type(const std::string& place, const char* wanted, nb::handle value) {
  throw nb::type_error((place + ": " + wanted + " is wanted, not " + type_of(value)).c_str());
}

Rational rational(nb::handle x, const std::string& place) {
  PyObject* const p = x.ptr();
  if (PyFloat_Check(p)) return dyadic(PyFloat_AsDouble(p), x, place);
  if (PyBool_Check(p)) refuse_type(place, "a number", x);
  if (PyLong_Check(p)) return integer(x);
  if (PyUnicode_Check(p)) return by_text(x, place);
  if (x.type().is(imported("fractions", "Fraction")))
    return quotient(x.attr("numerator"), x.attr("denominator"));
  if (x.type().is(imported("decimal", "Decimal"))) {
    require_modest(x, place);
    return by_ratio(x, place);
  }
  if (nb::isinstance<RealNumber>(x))
    refuse(place, "an irrational number is not taken here; x.digits(n) is rational", x);
  const nb::object found = imported("phrame._numbers", "number")(x, place);
  if (nb::isinstance<nb::tuple>(found)) return quotient(found[0], found[1]);
  if (found.is_none()) refuse_type(place, "a number (int, Fraction, Decimal, float or str)", x);
  return rational(found, place);
}

Angle angle_number(nb::handle x, const std::string& place) {
  if (PyUnicode_Check(x.ptr()) == 0) {
    if (is_of_python(x)) return Angle(rational(x, place));
    const nb::object parts = imported("phrame._numbers", "angle")(x, place);
    const Rational angle = rational(parts[0], place) * rational(parts[1], place);
    return nb::cast<bool>(parts[2]) ? Angle(angle, 0) : Angle(angle);
  }
  try {
    return parse_angle(text(x, place));
  } catch (const InputError& error) {
    refuse(place, error.reason(), x);
  }
}

long count(nb::handle x, const std::string& place, long least, long most) {
  if (PyBool_Check(x.ptr()) || PyIndex_Check(x.ptr()) == 0) refuse_type(place, "an int", x);
  const Rational n = rational(x, place);
  if (n < least || n > most)
    refuse(place,
           shown_value(x) + " is not in " + std::to_string(least) + " … " + std::to_string(most),
           x);
  return static_cast<long>(numerator(n));
}

bool is_list(nb::handle x) {
  if (is_plain_list(x)) return true;
  if (PyUnicode_Check(x.ptr()) != 0 || PyBytes_Check(x.ptr()) != 0) return false;
  if (PySequence_Check(x.ptr()) == 0 && !nb::hasattr(x, "__array__") &&
      !nb::hasattr(x, "__dlpack__"))
    return false;
  if (nb::hasattr(x, "ndim")) return !x.attr("ndim").equal(nb::int_(0));
  return PyIndex_Check(x.ptr()) == 0;  // an mpz has __array__, too
}

nb::object listed(nb::handle x, const std::string& place, const char* wanted) {
  if (!is_list(x)) refuse_type(place, wanted, x);
  if (is_plain_list(x)) return nb::borrow(x);
  return imported("phrame._numbers", "numbers")(x, place);
}

nb::list rows(nb::handle x, const std::string& place, const char* wanted,
              std::initializer_list<const char*> columns) {
  if (!is_list(x)) refuse_type(place, wanted, x);
  if (is_plain_list(x)) return nb::list(nb::borrow(x));
  nb::list names;
  for (const char* name : columns) names.append(name);
  return nb::list(imported("phrame._numbers", "rows")(x, place, names));
}

std::vector<Rational> rationals(nb::handle list, const std::string& place) {
  const nb::object given = listed(list, place, "a list of numbers");
  // A tuple of its own: what a number runs in Python cannot change it.
  const nb::object items = nb::steal(PySequence_Tuple(given.ptr()));
  if (!items.is_valid()) {
    if (PyErr_ExceptionMatches(PyExc_MemoryError) != 0) throw nb::python_error();
    PyErr_Clear();
    refuse_type(place, "a list of numbers", list);
  }
  const auto n = static_cast<std::size_t>(PyTuple_Size(items.ptr()));
  std::vector<Rational> result;
  result.reserve(n);
  for (std::size_t k = 0; k < n; ++k) {
    if (k % 1024 == 1023 && PyErr_CheckSignals() != 0) throw nb::python_error();
    result.push_back(rational(PyTuple_GetItem(items.ptr(), static_cast<Py_ssize_t>(k)),
                              place + "[" + std::to_string(k) + "]"));
  }
  return result;
}

namespace {

/// Three numbers, or perhaps two, where z = 0.
Vector<Rational> coordinates(const std::vector<Rational>& list, bool may_be_plane, nb::handle x,
                             const std::string& place) {
  if (list.size() != 3 && !(may_be_plane && list.size() == 2))
    refuse(place,
           std::string(may_be_plane ? "2 or 3" : "3") + " numbers are wanted, there are " +
               std::to_string(list.size()),
           x);
  return {list[0], list[1], list.size() == 3 ? list[2] : Rational(0)};
}

std::vector<Vector<Rational>> rows_of_coordinates(nb::handle list, bool may_be_plane,
                                                  const std::string& place, std::size_t least) {
  std::vector<Vector<Rational>> result;
  std::size_t dimension = 0;
  for (const nb::handle row : rows(list, place, "a list of points", {"x", "y", "z"})) {
    const std::string at = place + "[" + std::to_string(result.size()) + "]";
    const std::vector<Rational> numbers = rationals(row, at);
    result.push_back(coordinates(numbers, may_be_plane, row, at));
    if (dimension != 0 && numbers.size() != dimension)
      refuse(at,
             std::to_string(numbers.size()) + " numbers, but " + std::to_string(dimension) +
                 " in " + place + "[0]",
             row);
    dimension = numbers.size();
  }
  if (result.size() < least)
    refuse(
        place,
        std::to_string(least) + " are wanted at least, there are " + std::to_string(result.size()),
        list);
  return result;
}

}  // namespace

Vector<Rational> vector(nb::handle x, const std::string& place) {
  return coordinates(rationals(x, place), false, x, place);
}

Vector<Rational> given_point(nb::handle x, const std::string& place) {
  return coordinates(rationals(x, place), true, x, place);
}

std::vector<Vector<Rational>> vectors(nb::handle list, const std::string& place,
                                      std::size_t least) {
  return rows_of_coordinates(list, false, place, least);
}

std::vector<Vector<Rational>> given_points(nb::handle list, const std::string& place,
                                           std::size_t least) {
  return rows_of_coordinates(list, true, place, least);
}

nb::object to_python(const Integer& x) {
  if (bit_length(x) < 63) return nb::int_(static_cast<long>(x));
  return nb::steal(PyLong_FromString(x.str(16).c_str(), nullptr, 16));
}

nb::object to_python(const Rational& x) {
  return imported("fractions", "Fraction")(to_python(numerator(x)), to_python(denominator(x)));
}

nb::object to_python(const std::vector<Rational>& list) {
  nb::list result;
  for (const Rational& x : list) result.append(to_python(x));
  return nb::tuple(result);
}

nb::object to_decimal(const std::string& digits) { return imported("decimal", "Decimal")(digits); }

/// A few bits more are not asked of what it was made from, so that what occurs in it many times, as
/// x does in x + 1/x, is computed once for each 64 bits: else once for each way to it.
Real computed_once(const Real& x) {
  if (x.exact()) return x;
  return {[x, known = Refined<RealBall>()](long bits) {
            const long whole = std::max(1L, bits / 64) * 64;
            return *known.get(whole, [&](const RealBall*) { return x.enclose(whole + 32); });
          },
          x.origin()};
}

nb::object to_python(const Real& x, const nb::object& recipe, const ZeroBound& bound, long depth) {
  if (constexpr long most = 5000; depth > most)
    throw Undecided("a Real is made in " + std::to_string(most) +
                    " steps at most, each from the one before: many are added in pairs, and pairs "
                    "of pairs, or by digits(n)");
  constexpr long soon = 4096;  // bits, which take no time
  const Real known = bound.bits() <= soon ? settled(x, bound) : x;
  if (known.exact()) return to_python(*known.exact());
  return nb::cast(RealNumber{computed_once(known), recipe, bound, depth});
}

nb::object to_python(const RealAlgebraic& x) {
  if (const auto r = x.rational()) return to_python(*r);
  const Interval& around = x.interval();
  return nb::cast(
      RealNumber{to_real(x),
                 nb::make_tuple(imported("phrame._pickle", "rebuild"),
                                nb::make_tuple("root", to_python(x.polynomial().coefficients()),
                                               to_python(*around.lower), to_python(*around.upper))),
                 zero_bound(x)});
}

nb::object to_python(const std::vector<RealRoot>& roots) {
  nb::list result;
  for (const RealRoot& root : roots) result.append(nb::make_tuple(to_python(root.at), root.order));
  return nb::tuple(result);
}

Real real(nb::handle x, const std::string& place) {
  if (nb::isinstance<RealNumber>(x)) return nb::cast<RealNumber&>(x).value;
  return rational(x, place);
}

nb::object ends(const RealBall& ball) {
  if (!ball.is_finite()) throw Undecided("enclosure: it is not finite with so few bits");
  return nb::make_tuple(to_python(ball.lower()), to_python(ball.upper()));
}

}  // namespace phrame::python
