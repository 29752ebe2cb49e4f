#pragma once
#include <string>
#include <string_view>

#include "phrame/algebra/angle.hpp"
#include "phrame/algebra/bivariate.hpp"
#include "phrame/algebra/factor.hpp"
#include "phrame/algebra/gaussian_polynomial.hpp"
#include "phrame/algebra/real_algebraic.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/algebra/sturm.hpp"
#include "phrame/algebra/surd.hpp"
#include "phrame/ph/curve/quaternion.hpp"
#include "phrame/ph/frame/frame_angle.hpp"

namespace phrame {

/// How formulas are written: for a screen, or for a paper.
enum class Notation { unicode, latex };

// A text for reading has passages in two lengths: all of it, and what a screen line can bear. Such
// a text is made of strings as any other; who prints it chooses between the two with for_reading().
// In between both are there, among control characters, which names and numbers never have.

/// A passage. In neither length is there another passage.
std::string passage(std::string_view full, std::string_view abridged);
/// A text with its passages in full, or abridged and with a last line that says how to see them.
std::string for_reading(std::string_view text, bool in_full);
/// A text with its passages abridged.
std::string abridged(std::string_view text);

/// "37t⁴ − 72t³ + 1/2", highest power first; "0" for 0.
std::string formatted(const Polynomial& p, Notation notation, std::string_view variable = "t");
/// "4t(t − 1)", factored over ℚ. Cost: the factorization.
std::string formatted_factors(const Polynomial& p, Notation notation,
                              std::string_view variable = "t");
/// "(4t² − 24t + 12) + (2t² + 14t − 6)i".
std::string formatted(const GaussianPolynomial& p, Notation notation,
                      std::string_view variable = "t");
/// "t² − t + (2x + 1)", by powers of t: coefficients with an x stand in parentheses.
std::string formatted(const Bivariate& v, Notation notation, std::string_view variable = "t",
                      std::string_view index = "x");
/// "3/7", `\frac{3}{7}`; a minus sign is "−" in Unicode.
std::string formatted(const Rational& x, Notation notation);
/// "(…)", in LaTeX as high as what it holds.
std::string in_parentheses(std::string_view text, Notation notation);
/// c times a number with a name: "√2", "−3π/4".
std::string formatted_multiple(const Rational& c, std::string_view name, Notation notation);
/// A decimal, "1.5e-12", as `1.5 \cdot 10^{-12}`.
std::string latex_decimal(const std::string& decimal);
/// "1/3", "−3π/4", "1/3 + π/4".
std::string formatted(const Angle& angle, Notation notation);
/// "π/4", "atan2(4, 3)", "1/3 + atan2(−1, 2)".
std::string formatted(const FrameAngle& angle, Notation notation);
/// "1/2 + 3√2/8".
std::string formatted(const Surd& x, Notation notation);
/// "t² − √2·t + (1 + √2)", highest power first.
std::string formatted(const SurdPolynomial& p, Notation notation, std::string_view variable = "t");

/// The text on one line, safe for a terminal: control characters (C0, DEL, C1) become "\u001b".
std::string printable(std::string_view text);

/// `text` with `line`, a line break and what the next line begins with, for each line break.
std::string indented(std::string_view text, std::string_view line);

/// The number of characters, where one code point is one character; of the abridged text.
std::size_t text_width(std::string_view text);
/// The texts with blanks behind them, all equally wide in either length.
std::vector<std::string> aligned(const std::vector<std::string>& texts);
/// `text`, or, where it is longer than a screen line can bear, a passage: abridged, it says what
/// the polynomial is, "⟨degree 160, coefficients of up to 53 digits⟩".
std::string readable(std::string text, const Polynomial& p);
/// @{ The same of v: "⟨degree 12 in t⟩", and of g and p, in Unicode.
std::string readable(const Bivariate& v, std::string_view variable = "t",
                     std::string_view index = "x");
std::string readable(const GaussianPolynomial& g);
std::string readable(const SurdPolynomial& p, std::string_view variable);
/// @}

/// A number in closed form, a passage where it is longer than `limit`: by default what a screen can
/// bear.
std::string readable_exact(const std::string& text, std::size_t limit = 4000);

/// "1 digit", "2 digits".
std::string counted(std::size_t count, std::string_view noun);
/// "name: " as a report begins, or nothing for an empty name.
std::string name_prefix(const std::string& name);
/// "  label      value", the values below each other.
std::string row(std::string_view label, const std::string& value, std::size_t width);
/// x, a passage where it is longer than `limit`; beside a fraction of more than 20 digits above or
/// below the line stands its decimal, correctly rounded: "123456789012345678901/7 ≈
/// 1.76366841446e19".
std::string shown(const Rational& x, std::size_t limit = 240);
/// @{ For reading, numbers in it as above: "1/3 + π/4", "(1, 0, 2/3)", "t² − 1".
std::string shown(const FrameAngle& x);
std::string shown(const Vector<Rational>& v);
std::string shown(const Polynomial& p);
/// @}
/// x where it is exact, and the decimal it was rounded to where it is not or is a long fraction.
std::string shown(const Real& x, const Decimal& rounded);
/// A place: "1/2", "0.707106781187…", cut off and not rounded.
std::string shown(const RealAlgebraic& x);

}  // namespace phrame
