#include "phrame/cli/command.hpp"

namespace phrame::cli {

// "phrame help angle" is read as "phrame angle --help" before CLI11 sees it; this lists the command
// and completes it.
void add_help(Program& program) {
  Command& command = program.add("help", "the help of a command");
  const auto name = std::make_shared<std::string>();
  std::vector<std::string> names;
  for (const Command* other : program.commands()) names.push_back(other->name());
  command.add_choice("COMMAND", *name, std::move(names), "one of those that phrame --help lists");
  command.set_notes(
      "Examples:\n"
      "  phrame help\n"
      "  phrame help angle");
  command.does(
      [name] { throw InputError("help", "a command is needed, as in phrame help angle"); });
}

}  // namespace phrame::cli
