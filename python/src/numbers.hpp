#pragma once
#include <nanobind/nanobind.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "insides.hpp"

namespace phrame::inline v0::python {

namespace nb = nanobind;

/// A str of bytes that may be of a broken file: what is not UTF-8 is replaced.
nb::object readable(const std::string& bytes);

/// What a caller gave is not what was asked for: phrame.InputError with the name of the argument.
[[noreturn]] void refuse(const std::string& place, const std::string& reason, nb::handle value);
/// The same as a TypeError.
[[noreturn]] void refuse_type(const std::string& place, const char* wanted, nb::handle value);

/// What a name stands for in a list of pairs; of others it is said which there are.
template <class T, class List = std::initializer_list<std::pair<const char*, T>>>
T chosen(const std::string& name, const char* place, const List& list) {
  std::string names;
  for (const auto& [known, value] : list) {
    if (name == known) return value;
    names += std::string(names.empty() ? "" : ", ") + known;
  }
  refuse(place, "\"" + abbreviated(name) + "\" is not one of " + names, nb::str(name.c_str()));
}

/// An argument of this name, which may be None: what it may not be is refused by its name.
inline auto argument(const char* name) { return nb::arg(name).none(); }

/// work(), without Python's lock. Called by the main thread, it is ended at once by Ctrl-C: the
/// work then goes on in a thread of its own, with nobody waiting.
void run_apart(std::function<void()> work);

/// f() as run_apart() does it. It owns all that it uses, so it captures by value, and no objects of
/// Python.
template <class F>
auto without_gil(F f) {
  const auto result = std::make_shared<std::optional<decltype(f())>>();
  run_apart([result, f = std::move(f)] { result->emplace(f()); });
  return std::move(**result);
}

/// The number that a Python object is, exactly: int, Fraction, Decimal, str, float, and those of
/// other packages (phrame/_numbers.py). `place` is the argument's name.
Rational rational(nb::handle x, const std::string& place);
/// An angle: a number of radians, a text such as "pi/4" or "45deg", or a quantity of an angle.
Angle angle_number(nb::handle x, const std::string& place);
/// A number of digits ≥ 1, or of bits.
long count(nb::handle x, const std::string& place, long least, long most);

/// Is it a list, an array, a column, a table, …: not one number, with a unit or without?
bool is_list(nb::handle x);
/// It as a sequence of numbers; `wanted` is what else it is not.
nb::object listed(nb::handle x, const std::string& place, const char* wanted);
/// It as a list of rows; the columns of a table are taken by these names, or in their order.
nb::list rows(nb::handle x, const std::string& place, const char* wanted,
              std::initializer_list<const char*> columns);
/// A list, a tuple or an array, one element each; numbers are named "place[3]".
std::vector<Rational> rationals(nb::handle list, const std::string& place);
/// Three numbers.
Vector<Rational> vector(nb::handle x, const std::string& place);
/// Three numbers, or two of a point or direction in the plane z = 0.
Vector<Rational> given_point(nb::handle x, const std::string& place);
/// Rows of such numbers, all of as many, `least` of them or more.
std::vector<Vector<Rational>> given_points(nb::handle list, const std::string& place,
                                           std::size_t least);
/// Rows of three numbers, `least` of them or more.
std::vector<Vector<Rational>> vectors(nb::handle list, const std::string& place, std::size_t least);

nb::object to_python(const Integer& x);   ///< int
nb::object to_python(const Rational& x);  ///< fractions.Fraction
template <class T>
nb::object to_python(const Vector<T>& v) {
  return nb::make_tuple(to_python(v[0]), to_python(v[1]), to_python(v[2]));
}
nb::object to_python(const std::vector<Rational>& list);  ///< a tuple
/// decimal.Decimal, with all digits.
nb::object to_decimal(const std::string& digits);

/// An attribute of a module of Python, looked up once.
nb::object& imported(const char* module, const char* name);

/// A real number that is known by enclosures. `recipe` is (function, arguments), by which it is
/// pickled: a number that is computed is computed again.
struct RealNumber {
  Real value;
  nb::object recipe;
  ZeroBound bound = {};  ///< where it is known to be algebraic
  long depth = 0;        ///< how many numbers it is made of, each from the one before
};
/// A Fraction where it is exact, or seen to be rational; else a RealNumber. Throws Undecided where
/// the stack may not do for that depth.
nb::object to_python(const Real& x, const nb::object& recipe, const ZeroBound& bound = {},
                     long depth = 0);
nb::object to_python(const RealAlgebraic& x);
/// [(number, order), …].
nb::object to_python(const std::vector<RealRoot>& roots);
/// The number of a RealNumber, or what rational() reads.
Real real(nb::handle x, const std::string& place);

/// Both ends of a ball, exactly, as Fractions.
nb::object ends(const RealBall& ball);

/// A DomainError about an argument.
struct ArgumentError : DomainError {
  std::string place;
  ArgumentError(std::string at, const std::string& reason)
      : DomainError(reason), place(std::move(at)) {}
};
/// f(), whose DomainErrors name the argument.
template <class F>
auto at_place(const std::string& place, const F& f) {
  try {
    return f();
  } catch (const ArgumentError&) {
    throw;
  } catch (const DomainError& error) {
    throw ArgumentError(place, error.what());
  }
}

void bind_numbers(nb::module_& m);
void bind_real(nb::module_& m);
void bind_paths(nb::module_& m);

}  // namespace phrame::python
