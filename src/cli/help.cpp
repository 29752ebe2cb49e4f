#include "phrame/cli/command.hpp"
#include "phrame/cli/listing.hpp"
#include "phrame/cli/option_list.hpp"

namespace phrame::inline v0::cli {
namespace {

struct HelpOptions {
  std::string name;
  bool is_json = false;
  bool is_schema = false;
};

void run(const Program& program, const HelpOptions& options) {
  if (!options.is_json && !options.is_schema)
    throw InputError("help", "a command is needed, as in phrame help angle");
  std::vector<const Command*> commands = program.commands();
  if (!options.name.empty()) {
    std::vector<std::pair<std::string, const Command*>> known;
    for (const Command* command : commands) known.emplace_back(command->name(), command);
    commands = {choose("COMMAND", options.name, known)};
  }
  if (options.is_schema && !options.name.empty() && !is_question(*commands.front()))
    throw InputError("COMMAND", "no line of a batch asks \"" + options.name + "\"");
  write_output("-", options.is_json ? listing(commands) : line_schema(commands));
}

}  // namespace

// "phrame help angle" is read as "phrame angle --help" before CLI11 sees it; this lists the command
// and completes it.
void add_help(Program& program) {
  Command& command = program.add("help", "the help of a command");
  const auto options = std::make_shared<HelpOptions>();
  std::vector<std::string> names;
  for (const Command* other : program.commands()) names.push_back(other->name());
  command.add_choice("COMMAND", options->name, std::move(names),
                     "one of those that phrame --help lists");
  command.add_flag("--json", options->is_json,
                   "for other programs: all commands, or this one, with their options");
  command.add_flag("--schema", options->is_schema,
                   "the JSON Schema of a line of phrame batch that asks one of all questions, or\n"
                   "this one");
  command.not_with({"--schema"}, {"--json"});
  command.set_notes(
      "Of an option --json says its names, its key in a line of a batch and in Python's\n"
      "phrame.ask(), its kind (flag, name, number, file or text), choices, range, default, and\n"
      "what it goes with and without.\n"
      "Examples:\n"
      "  phrame help\n"
      "  phrame help angle\n"
      "  phrame help frames --json");
  command.does([&program, options] { run(program, *options); });
}

}  // namespace phrame::cli
