#pragma once
#include "phrame/cli/program.hpp"

namespace CLI {
class ParseError;
}

namespace phrame::inline v0::cli {

/// What is wrong with the first word, or that it is missing; empty where it is a command or an
/// option.
std::string complaint_about_command(const Program& program, const std::vector<std::string>& words);

/// About an option whose value is the name of another, "--at --digits 5"; empty where there is
/// none.
std::string about_swallowed_option(const Command& command);

/// What CLI11 found wrong with the arguments of a command, or of the program itself, in our words:
/// the same for all its versions, with the nearest option where one is misspelt.
std::string complaint(const Program& program, const CLI::ParseError& error);

}  // namespace phrame::cli
