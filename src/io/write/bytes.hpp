#pragma once
#include <cstddef>
#include <string>

#include "phrame/ph/curve/quaternion.hpp"

namespace phrame::inline v0 {

// What binary files are made with.

/// Appends the bytes of an unsigned number, the least first.
template <class Number>
void append_number(std::string& bytes, Number x) {
  for (unsigned k = 0; k < sizeof x; ++k) bytes += static_cast<char>((x >> (8 * k)) & 0xFFU);
}

/// Appends the four bytes of a float likewise.
void append_float(std::string& bytes, float x);

/// The bytes in base 64, with "=" at the end where they are no multiple of three [RFC 4648].
std::string base64(const std::string& bytes);

/// Of a node of glTF: ",\"translation\":[1000,0,0]"; nothing of 0.
std::string translation_json(const Vector<double>& to);

/// A glTF 2.0 file in one: its JSON and its buffer.
std::string glb_file(std::string json, std::string buffer);

}  // namespace phrame
