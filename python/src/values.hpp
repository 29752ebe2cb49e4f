#pragma once
#include "numbers.hpp"

namespace phrame::inline v0::python {

/// A Polynomial, or its coefficients from the lowest on.
Polynomial polynomial(nb::handle x, const std::string& place);
/// A polynomial in one of the bases "power" and "bernstein".
Polynomial polynomial(nb::handle x, const std::string& place, const std::string& basis);

/// function(arguments…), by which an object is pickled.
template <class... T>
nb::object recipe(const nb::object& function, T&&... arguments) {
  return nb::make_tuple(function, nb::make_tuple(std::forward<T>(arguments)...));
}

/// The same by a function of this module, which has no pickle.
template <class... T>
nb::object remade(const char* function, T&&... arguments) {
  return recipe(imported("phrame._pickle", "rebuild"), function, std::forward<T>(arguments)...);
}

/// What does not change needs no copies.
template <class C>
void bind_copies(C& type) {
  type.def(
          "__copy__", [](nb::handle self) { return nb::borrow(self); },
          nb::sig("def __copy__(self) -> typing.Self"))
      .def(
          "__deepcopy__", [](nb::handle self, nb::handle) { return nb::borrow(self); },
          argument("memo"), nb::sig("def __deepcopy__(self, memo: object) -> typing.Self"));
}

/// A method that is a function of a module of the package, whose first argument is the object.
template <class C>
void bind_python(C& type, const char* method, const char* module, const char* function,
                 const char* signature, const char* what = "") {
  type.def(
      method,
      [module, function](nb::handle self, const nb::args& arguments, const nb::kwargs& named) {
        return imported(module, function)(self, *arguments, **named);
      },
      nb::sig(signature), what);
}

#define PHRAME_REDUCE_SIG nb::sig("def __reduce__(self) -> tuple[typing.Any, ...]")

}  // namespace phrame::python
