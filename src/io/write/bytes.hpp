#pragma once
#include <cstddef>
#include <string>

namespace phrame {

// What binary files are made with.

/// Appends the bytes of an unsigned number, the least first.
template <class Number>
void append_number(std::string& bytes, Number x) {
  for (unsigned k = 0; k < sizeof x; ++k) bytes += static_cast<char>((x >> (8 * k)) & 0xFFU);
}

/// Appends the four bytes of a float likewise.
void append_float(std::string& bytes, float x);

/// The nearest float, but not beyond the greatest one.
float as_float(double x);

/// The bytes in base 64, with "=" at the end where they are no multiple of three [RFC 4648].
std::string base64(const std::string& bytes);

/// A glTF 2.0 file in one: its JSON and its buffer.
std::string glb_file(std::string json, std::string buffer);

}  // namespace phrame
