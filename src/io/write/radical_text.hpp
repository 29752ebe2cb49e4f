#pragma once
#include <string>
#include <string_view>

#include "phrame/algebra/radical.hpp"

namespace phrame::inline v0 {

/// How radicals are written; what has a {} is a pattern of {fmt}.
struct RadicalNotation {
  std::string_view minus;           ///< the sign
  std::string_view times;           ///< between an integer and what it multiplies
  std::string_view dot;             ///< between other factors
  std::string_view parentheses;     ///< around {}
  std::string_view rational;        ///< 2/3
  std::string_view quotient;        ///< of expressions
  bool quotient_encloses;           ///< its parts need no parentheses
  std::string_view imaginary_unit;  ///< √−1
  /// @{ Of {}; a power of {} and {}.
  std::string_view square_root;
  std::string_view cube_root;
  std::string_view power;
  std::string_view log;
  /// @}
};

/// Unicode and LaTeX, and what computer-algebra systems read. Their √ and ^(1/3) are principal, as
/// those of a Radical are. What is for SymPy is meant to follow "from sympy import *".
namespace radical_notation {
/// @{ Of this language.
extern const RadicalNotation unicode;
extern const RadicalNotation latex;
extern const RadicalNotation sympy;
extern const RadicalNotation mathematica;
extern const RadicalNotation maple;
extern const RadicalNotation maxima;
extern const RadicalNotation pari;
/// @}
}  // namespace radical_notation

/// Is it radical_notation::unicode itself?
inline bool is_unicode(const RadicalNotation& notation) {
  return &notation == &radical_notation::unicode;
}

/// "(−1 + i√3)/2", "(∛(−108 + 12√93) − ∛(108 + 12√93))/6".
std::string formatted(const Radical& x, const RadicalNotation& notation);

/// The same in parentheses where it is a sum or negative.
std::string formatted_factor(const Radical& x, const RadicalNotation& notation);
/// Does the text begin with a minus sign?
bool is_written_negative(const Radical& x);

}  // namespace phrame
