#pragma once
#include <bit>
#include <cstddef>
#include <cstdint>
#include <string>

#include "phrame/ph/curve/quaternion.hpp"

namespace phrame::inline v0 {

// What binary files are made with.

/// Appends the bytes of an unsigned number, the least first.
template <class Number>
void append_number(std::string& bytes, Number x) {
  if constexpr (std::endian::native == std::endian::little)
    bytes.append(reinterpret_cast<const char*>(&x), sizeof x);
  else
    for (unsigned k = 0; k < sizeof x; ++k) bytes += static_cast<char>((x >> (8 * k)) & 0xFFU);
}

/// Appends the four bytes of a float likewise.
inline void append_float(std::string& bytes, float x) {
  append_number(bytes, std::bit_cast<std::uint32_t>(x));
}

/// The bytes in base 64, with "=" at the end where they are no multiple of three [RFC 4648].
std::string base64(const std::string& bytes);

/// Of a node of glTF: ",\"translation\":[1000,0,0]"; nothing of 0.
std::string translation_json(const Vector<double>& to);

/// What a glTF 2.0 file in one begins with, its JSON there: then comes its buffer, of so many
/// bytes, a multiple of 4.
std::string glb_head(std::string json, std::uint64_t buffer_size);

}  // namespace phrame
