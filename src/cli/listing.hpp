#pragma once
#include "phrame/cli/program.hpp"

namespace phrame::inline v0::cli {

// The table of commands and options for other programs, made of what help, manual pages and
// completion are made of. Of all commands, or of `only` this one.

/// {"phrame": "commands/1", "commands": [{"command", "what", "question", "options": […]}, …]}.
std::string listing(const std::vector<const Command*>& commands);

/// The JSON Schema (draft 2020-12) of a line of a batch that asks one of these, or is a bare curve.
/// What it takes may still be refused for its value; what it does not take is refused.
std::string line_schema(const std::vector<const Command*>& commands);

}  // namespace phrame::cli
