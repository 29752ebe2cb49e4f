#pragma once
#include <algorithm>
#include <string>

#include "numbers.hpp"

namespace phrame::inline v0::python {

/// What an argument is called.
template <std::size_t N>
struct ArgumentName {
  char text[N];

  consteval ArgumentName(const char (&name)[N]) {  // NOLINT(google-explicit-constructor)
    std::copy_n(name, N, text);
  }
};

/// @{ A text, and true or false, as the argument of this name, which is named where it is neither.
template <ArgumentName Name>
struct Text : std::string {};
template <ArgumentName Name>
struct Flag {
  bool value;
  operator bool() const { return value; }  // NOLINT(google-explicit-constructor)
};
/// @}

/// Refuses what is no text, or none of Unicode.
std::string text(nb::handle x, const std::string& place);
/// Refuses what is neither True nor False nor of NumPy's.
bool flag(nb::handle x, const std::string& place);
/// The name of a file, as open() takes it.
nb::object file_name(nb::handle x, const std::string& place);
/// The bytes of a file, and what is written to one.
std::string bytes_of_file(nb::handle file, const std::string& place);
void write_file(nb::handle file, const std::string& place, const std::string& bytes);

/// Takes any object: what is wrong with it is found when it is converted, where there may be
/// exceptions.
template <class T>
struct LateCaster {
  using Value = T;
  template <class>
  using Cast = T;
  template <class>
  static constexpr bool can_cast() {
    return true;
  }

  nb::handle given;

  bool from_python(nb::handle x, std::uint8_t, nb::detail::cleanup_list*) noexcept {
    given = x;
    return true;
  }
};

}  // namespace phrame::python

namespace nanobind::detail {

template <phrame::python::ArgumentName Of>
struct type_caster<phrame::python::Text<Of>>
    : phrame::python::LateCaster<phrame::python::Text<Of>> {
  static constexpr auto Name = const_name("str");
  explicit operator phrame::python::Text<Of>() {
    return {phrame::python::text(this->given, Of.text)};
  }
};

template <phrame::python::ArgumentName Of>
struct type_caster<phrame::python::Flag<Of>>
    : phrame::python::LateCaster<phrame::python::Flag<Of>> {
  static constexpr auto Name = const_name("bool");
  explicit operator phrame::python::Flag<Of>() {
    return {phrame::python::flag(this->given, Of.text)};
  }
};

}  // namespace nanobind::detail
