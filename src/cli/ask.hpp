#pragma once
#include "phrame/cli/question.hpp"

namespace phrame::inline v0::cli {

// What a program asks that has no command line: the Python package.

/// The table of the questions, as `phrame help --json` prints it of all commands.
std::string question_table(const CommandTable& table = answering_commands());

/// The answer to a line {"question": …, …} of a batch, as answer_question() has it; with a path,
/// the curve need not be in the line. That the answer is no is {"status": 1, "output": "why"}.
/// Throws what the command does.
std::string ask(const std::string& line, const std::optional<NamedPath>& path = std::nullopt,
                const CommandTable& table = answering_commands());

}  // namespace phrame::cli
