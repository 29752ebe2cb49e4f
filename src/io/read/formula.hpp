#pragma once
#include <optional>
#include <string>
#include <string_view>

#include "phrame/export.hpp"
#include "phrame/ph/curve/formula.hpp"

namespace phrame::inline v0 {

/// A function that somebody has typed.
struct GivenFormula {
  Formula value;         ///< the function
  std::string variable;  ///< as given or found; empty for a constant
};

/// The longest formula that is read, in bytes.
inline constexpr std::size_t max_formula_length = 100'000;

/// Reads a function of one real variable:
///   +  −  *  /  ^ and parentheses, numbers and characters as parse_expression() reads them;
///   an exponent is a rational number, as in x^(2/3), or f^g is exp(g·log f);
///   π or pi, and e, unless that is the variable;
///   sin, cos, tan, cot, sec, csc, exp, log or ln, sqrt, asin, acos, atan or arctan, sinh, cosh,
///   tanh, with parentheses: sin(s), not sin s;
///   one variable, given or the only other name that occurs; with "" given, none may occur.
/// Throws InputError with the place "column N", counted from 1 in characters. That a function is
/// undefined somewhere is not seen here.
PHRAME_API GivenFormula parse_formula(std::string_view text,
                                      const std::optional<std::string>& variable = std::nullopt);

/// f as it is read of what is written of it, until that does not change any more: full_text() of it
/// is that of what is read of the text. Throws DomainError where that does not end.
PHRAME_API Formula canonical(const Formula& f);

}  // namespace phrame
