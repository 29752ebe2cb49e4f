#pragma once
#include "phrame/cli/program.hpp"

namespace phrame::inline v0::cli {

// What --help shows, made of the list of options that manual pages and completion are made of, too.

/// Lines of at most `width` characters; headings and names stand out `in_colour`.
struct HelpStyle {
  std::size_t width = 110;
  bool in_colour = false;
};

/// @{ Of a command, and of the program with its commands.
std::string help_text(const Command& command, const HelpStyle& style);
std::string help_text(const Program& program, const HelpStyle& style);
/// @}

}  // namespace phrame::cli
