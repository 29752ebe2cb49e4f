#include "phrame/cli/usage.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>

#include "phrame/algebra/rational.hpp"
#include "phrame/io/read/suggestion.hpp"

namespace phrame::inline v0::cli {
namespace {

using Options = std::vector<const CLI::Option*>;

std::string in_quotes(const std::string& word) { return "\"" + abbreviated(word) + "\""; }

std::string question(const std::optional<std::string>& meant) {
  return meant ? "; did you mean " + *meant + "?" : "";
}

/// "-o", "--output".
std::vector<std::string> names_of(const CLI::Option& option) {
  std::vector<std::string> names;
  for (const std::string& name : option.get_snames()) names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) names.push_back("--" + name);
  return names;
}

std::vector<std::string> names_of(const Options& options) {
  std::vector<std::string> names;
  for (const CLI::Option* option : options)
    for (const std::string& name : names_of(*option)) names.push_back(name);
  return names;
}

bool is_in(const std::string& word, const std::vector<std::string>& words) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

/// The word without "=value".
std::string option_in(const std::string& word) { return word.substr(0, word.find('=')); }

/// Has the program or a command this option: "--digits", or "--digits=30"?
bool has_option(const CLI::App& app, const std::string& word) {
  return is_in(option_in(word), names_of(app.get_options()));
}

bool looks_like_option(const std::string& word) { return word.size() > 1 && word[0] == '-'; }

/// "--turns is no option of info; frames and mtf have it".
std::string about_unknown_option(const Program& program, const CLI::App& command,
                                 const std::string& word) {
  const std::string option = option_in(word);
  std::string text = abbreviated(option) + " is no option";
  if (&command == &program.app())
    return text + question(suggestion(option, names_of(command.get_options())));
  text += " of " + command.get_name();
  std::string others;
  for (const Command* other : program.commands())
    if (has_option(other->app(), word)) others += (others.empty() ? "" : ", ") + other->name();
  if (!others.empty()) return text + "; it is one of " + others;
  return text + question(suggestion(option, names_of(command.get_options())));
}

/// The arguments that found no place.
std::string about_rest(const Program& program, const CLI::App& command) {
  const std::vector<std::string> rest = command.remaining();
  const auto option = std::find_if(rest.begin(), rest.end(), looks_like_option);
  if (option != rest.end()) return about_unknown_option(program, command, *option);
  if (rest.empty()) return "";
  std::string wanted;
  for (const CLI::Option* positional : command.get_options())
    if (positional->get_positional()) wanted += " " + positional->get_name();
  return wanted.empty() ? fmt::format("{} is one argument too many", in_quotes(rest.front()))
                        : fmt::format("{} is one argument too many: phrame {} takes{}",
                                      in_quotes(rest.front()), command.get_name(), wanted);
}

std::string about_swallowed(const CLI::App& command) {
  const Options options = command.get_options();
  const std::vector<std::string> names = names_of(options);
  for (const CLI::Option* option : options)
    for (const std::string& value : option->results())
      if (!option->get_positional() && is_in(option_in(value), names) && value != "-")
        return fmt::format("{}: a value is needed before {}", option->get_name(),
                           abbreviated(value));
  return "";
}

/// The option that CLI11's message begins with.
const CLI::Option* option_of(const CLI::App& command, const std::string& message) {
  const std::string name = message.substr(0, message.find_first_of(": "));
  for (const CLI::Option* option : command.get_options())
    if (option->get_name() == name || is_in(name, names_of(*option)) ||
        is_in("--" + name, names_of(*option)))
      return option;
  return nullptr;
}

std::string about_mismatch(const CLI::App& command, const std::string& message) {
  const CLI::Option* option = option_of(command, message);
  if (option == nullptr) return message;
  const std::string name = option->get_name();
  if (option->get_items_expected_max() == 0) return name + " takes no value";
  if (option->results().size() > 1)
    return fmt::format("{} is given {} times", name, option->results().size());
  return fmt::format("{}: a value is needed, {}", name, option->get_type_name());
}

/// What is to be given and is not.
std::string about_missing(const CLI::App& command) {
  for (const CLI::Option* option : command.get_options())
    if (option->get_required() && option->count() == 0) {
      const std::string what = option->get_description();
      return fmt::format("{} is required: {}", option->get_name(), what.substr(0, what.find('\n')));
    }
  return "";
}

}  // namespace

std::string about_swallowed_option(const Command& command) {
  return about_swallowed(command.app());
}

std::string complaint_about_command(const Program& program, const std::vector<std::string>& words) {
  std::vector<std::string> names;
  for (const Command* command : program.commands()) names.push_back(command->name());
  const std::string there_are = fmt::format("there are {} (phrame --help)", fmt::join(names, ", "));
  if (words.empty()) return "a command is needed: " + there_are;
  const std::string& word = words.front();
  if (program.find(word) != nullptr) return "";
  if (looks_like_option(word)) {
    const auto commands = program.commands();
    const bool is_theirs =
        std::any_of(commands.begin(), commands.end(),
                    [&](const Command* command) { return has_option(command->app(), word); });
    return has_option(program.app(), word) || !is_theirs
               ? ""
               : abbreviated(word) + ": options come after the command (phrame --help)";
  }
  const auto meant = suggestion(word, names);
  return fmt::format("{} is not a command{}", in_quotes(word),
                     meant ? question(meant) + " (phrame --help)" : ": " + there_are);
}

std::string complaint(const Program& program, const CLI::ParseError& error) {
  const auto chosen = program.app().get_subcommands();
  const CLI::App& command = chosen.empty() ? program.app() : *chosen.front();
  const std::string message = error.what();
  std::string text = about_swallowed(command);
  const bool is_extra = dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr;
  const bool is_missing = dynamic_cast<const CLI::RequiredError*>(&error) != nullptr;
  if (text.empty() && (is_extra || is_missing)) text = about_rest(program, command);
  if (text.empty() && is_missing) text = about_missing(command);
  if (text.empty() && dynamic_cast<const CLI::ArgumentMismatch*>(&error) != nullptr)
    text = about_mismatch(command, message);
  if (text.empty() && dynamic_cast<const CLI::ConversionError*>(&error) != nullptr)
    if (const CLI::Option* option = option_of(command, message))
      text = option->get_items_expected_max() == 0 ? option->get_name() + " takes no value" : "";
  if (text.empty()) text = message;  // of a Validator, which is ours
  return fmt::format("{} (phrame {}--help)", text, chosen.empty() ? "" : command.get_name() + " ");
}

}  // namespace phrame::cli
