#pragma once
#include <optional>
#include <string>
#include <string_view>

#include "phrame/algebra/rational_function.hpp"
#include "phrame/export.hpp"

namespace phrame::inline v0 {

/// A rational function that somebody has typed.
struct Expression {
  RationalFunction value;  ///< in lowest terms
  std::string variable;    ///< as given or found; empty for a constant
};

/// What is refused, and what the refusal advises.
struct ExpressionLimits {
  std::size_t max_length = 1'000'000;  ///< of the text, in bytes
  SizeLimits size = {};                ///< of the value and of each part of it
  std::string variable_option = {};    ///< what names the variable, for advice: "--var"
};

/// Letters (Latin or Greek), digits and _, a letter first.
PHRAME_API bool is_variable_name(std::string_view text);

/// Reads a rational function of one variable over ℚ:
///   +  −  *  /  ^ and parentheses; ^ binds tightest and to the right, −x^2 is −(x^2), and its
///   exponent is an integer, as in x^-2 or x^(2*3);
///   numbers, exactly: 12, 0.1 = 1/10, 1.5e-3, 0x1.8p-3;
///   one variable, given or the only name that occurs; with "" given, none may occur. The names e,
///   i, pi and π mean numbers to many and are a variable only where it is given.
/// Also ** for ^, and the characters of typeset mathematics: − · × ÷ and exponents as in t⁴, but
/// not x²^3, of which it is not clear what it means. A product needs its sign: 2x and x(x + 1) are
/// refused, with advice. Throws InputError: for what is not such an expression, for a division by
/// zero and for what is beyond the limits. Its place is "column N", counted from 1 in characters.
PHRAME_API Expression parse_expression(std::string_view text,
                                       const std::optional<std::string>& variable = std::nullopt,
                                       const ExpressionLimits& limits = {});

}  // namespace phrame
