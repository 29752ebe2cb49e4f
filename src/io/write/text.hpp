#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "phrame/algebra/real_algebraic.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/io/write/formula.hpp"
#include "phrame/io/write/passage.hpp"
#include "phrame/ph/curve/quaternion.hpp"

namespace phrame::inline v0 {

// What reports for a screen are made with.

/// The text on one line, safe for a terminal: control characters (C0, DEL, C1) become "\u001b", and
/// bytes that are no UTF-8 "\xff".
std::string printable(std::string_view text);

/// `text` with `line`, a line break and what the next line begins with, for each line break.
std::string indented(std::string_view text, std::string_view line);

/// The texts with blanks behind them, all equally wide in either length.
std::vector<std::string> aligned(const std::vector<std::string>& texts);
/// Rows of equally many texts below each other, a line each behind `margin`.
std::string columns_text(const std::vector<std::vector<std::string>>& rows,
                         std::string_view margin = "");
/// `text`, or, where it is longer than a screen line can bear, a passage: abridged, it says what
/// the polynomial is, "⟨degree 160, coefficients of up to 53 digits⟩".
std::string readable(std::string text, const Polynomial& p);
/// @{ The same of v: "⟨degree 12 in t⟩", and of g and p, in Unicode.
std::string readable(const Bivariate& v, std::string_view variable = "t",
                     std::string_view index = "x");
std::string readable(const GaussianPolynomial& g);
std::string readable(const SurdPolynomial& p, std::string_view variable);
/// @}

/// @{ A decimal for reading: its minus sign is that of formulas.
std::string with_minus_sign(const std::string& decimal);
std::string shown(const Decimal& x);
/// @}

/// A number in closed form, a passage where it is longer than `limit`: by default what a screen can
/// bear.
std::string readable_exact(const std::string& text, std::size_t limit = 4000);

/// "1 digit", "2 digits".
std::string counted(std::size_t count, std::string_view noun);
/// "1 to 20, 22, 25 to 27", of ascending numbers.
std::string ranges(const std::vector<std::size_t>& numbers);
/// "name: " as a report begins, or nothing for an empty name.
std::string name_prefix(const std::string& name);
/// "  label      value", the values below each other.
std::string row(std::string_view label, const std::string& value, std::size_t width);
/// x, a passage where it is longer than `limit`: "12345678…23456789/33333333…33333333 (300/301
/// digits)".
std::string in_brief(const Rational& x, std::size_t limit = 72);
/// The same. Beside a fraction of more than 20 digits above or below the line stands its decimal,
/// correctly rounded: "123456789012345678901/7 ≈ 1.76366841446e19".
std::string shown(const Rational& x, std::size_t limit = 72);
/// @{ For reading, numbers in it as above: "1/3 + π/4", "(1, 0, 2/3)", "t² − 1".
std::string shown(const FrameAngle& x);
std::string shown(const Vector<Rational>& v);
std::string shown(const Polynomial& p);
/// @}
/// x where it is exact, and the decimal it was rounded to where it is not or is a long fraction.
std::string shown(const Real& x, const Decimal& rounded);
std::string shown(const Interval& interval);
/// A place: "1/2", "0.707106781187…", cut off and not rounded.
std::string shown(const RealAlgebraic& x);
/// Text of an element of HTML or XML.
std::string element_text(const std::string& text);

}  // namespace phrame
