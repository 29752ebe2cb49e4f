#pragma once
#include <string>
#include <string_view>

#include "phrame/algebra/rational.hpp"

namespace phrame::inline v0 {

/// The text without the blanks, or these characters, around it.
std::string_view trimmed(std::string_view text, std::string_view around = " \t\r\n");

/// Takes the first line off the text, and gives it without its end.
std::string_view take_line(std::string_view& text);

/// The text without the mark of UTF-8 in front of it.
std::string_view without_mark(std::string_view text);

/// "line 12", the place of an error.
std::string line_place(long line);

/// "line:column" of the byte before `offset`, counted from 1; that of the first byte where there is
/// none before it on its line.
std::string line_and_column(std::string_view text, std::size_t offset);

/// A number as people type it: what parse_rational reads, or a quotient of two such, "1.5/2.5",
/// "1e3/7"; blanks around it, and around the "/", do not matter. Throws InputError (no place).
Rational parse_number(std::string_view text);

/// Of a number in a curve, a profile, a feed rate or an angle: 1e6000 is short enough.
inline constexpr long most_number_bits = 20'000;
/// Throws InputError (no place) for one with more bits, whose algebra would take minutes;
/// `text` is how it is written.
void refuse_long_number(const Rational& x, std::string_view text);
/// What parse_number() reads, and this does not refuse.
Rational parse_short_number(std::string_view text);

}  // namespace phrame
