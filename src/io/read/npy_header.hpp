#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace phrame::inline v0 {

/// A constant of Python: strings, numbers, True and False, tuples and lists.
struct PythonLiteral {
  enum class Kind { text, number, truth, sequence } kind;
  std::string text{};  ///< of a truth "True" or "False", of a sequence "(" or "["
  std::size_t number = 0;
  std::vector<PythonLiteral> items = {};
};

/// What the header of an array in NumPy's .npy format says.
struct NpyHeader {
  PythonLiteral descr;  ///< a type, or a list of fields
  std::vector<std::size_t> shape;
  bool is_fortran = false;
};

/// Reads the dictionary. Throws InputError, whose place is "header".
NpyHeader read_npy_header(std::string_view text);

}  // namespace phrame
