#pragma once
#include <string>

namespace phrame::inline v0::cli {

// What the screen is like that is written to, if it is one.

/// The width of lines on standard output: what COLUMNS says, else that of the terminal, from 40 to
/// 110; 110 elsewhere.
std::size_t line_width();

/// May what goes to this file descriptor have colours? On a terminal, and with CLICOLOR_FORCE
/// elsewhere; not with NO_COLOR (https://no-color.org), nor where TERM is "dumb".
bool has_colour(int descriptor);

enum class Emphasis { plain, bold, heading, error };
std::string styled(const std::string& text, Emphasis emphasis, bool in_colour);

}  // namespace phrame::cli
