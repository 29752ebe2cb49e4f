#pragma once
#include <string>
#include <string_view>

namespace phrame::inline v0 {

/// The SHA-256 hash of the bytes in 64 hexadecimal digits [FIPS 180-4].
std::string sha256(std::string_view bytes);

}  // namespace phrame
