#pragma once
#include <string>
#include <string_view>

#include "phrame/algebra/rational.hpp"

namespace phrame {

/// The text without the blanks around it.
std::string_view trimmed(std::string_view text);

/// A number as people type it: what parse_rational reads, or a quotient of two such, "1.5/2.5",
/// "1e3/7"; blanks around it, and around the "/", do not matter. Throws InputError (no place).
Rational parse_number(std::string_view text);

}  // namespace phrame
