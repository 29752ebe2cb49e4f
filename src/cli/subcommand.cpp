#include "phrame/cli/subcommand.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "phrame/cli/command.hpp"

namespace phrame::cli {
namespace {

/// "a", "a or b", "a, b or c".
std::string alternatives(const std::vector<std::string>& choices) {
  std::string text;
  for (std::size_t k = 0; k < choices.size(); ++k)
    text += (k == 0 ? "" : k + 1 == choices.size() ? " or " : ", ") + choices[k];
  return text;
}

/// The endings of files that say what is in them.
const std::vector<std::pair<std::string, std::string>>& formats_by_ending() {
  static const std::vector<std::pair<std::string, std::string>> table{
      {"txt", "text"},    {"text", "text"},  {"out", "text"},      {"log", "text"},
      {"json", "json"},   {"csv", "csv"},    {"npy", "npy"},       {"tex", "latex"},
      {"latex", "latex"}, {"py", "sympy"},   {"m", "mathematica"}, {"wl", "mathematica"},
      {"mpl", "maple"},   {"mac", "maxima"}, {"gp", "pari"}};
  return table;
}

/// "json" of "runs/x.JSON"; empty where the name ends in no ".letters".
std::string ending(const std::string& path) {
  const std::size_t name = path.rfind('/') + 1;  // npos + 1 is 0
  const std::size_t dot = path.rfind('.');
  if (dot == std::string::npos || dot <= name) return "";
  std::string result = path.substr(dot + 1);
  for (char& c : result) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  const bool is_word = !result.empty() &&
                       std::isalpha(static_cast<unsigned char>(result[0])) != 0 &&
                       std::all_of(result.begin(), result.end(),
                                   [](unsigned char c) { return std::isalnum(c) != 0; });
  return is_word ? result : "";
}

}  // namespace

Command* Command::add(CLI::App& program, const std::string& name, const std::string& what) {
  const std::shared_ptr<Command> command(new Command(what, name, &program));
  command->group("Commands");
  program.add_subcommand(command);
  return command.get();
}

void Command::add_choice(const std::string& option, std::string& value,
                         std::vector<std::string> names, const std::string& what) {
  add_option(option, value, what)->type_name("NAME");
  facts_[option].names = std::move(names);
  values_[option] = [&value] { return std::vector{value}; };
}

void Command::add_choices(const std::string& option, std::vector<std::string>& values,
                          std::vector<std::string> names, const std::string& what) {
  add_option(option, values, what)->type_name("NAME,...")->expected(1)->take_all();
  facts_[option].names = std::move(names);
  facts_[option].takes_list = true;
  values_[option] = [&values] { return split(values); };
}

void Command::add_format(const std::string& option, std::string& value,
                         std::vector<std::string> names, const std::string& what) {
  add_choice(option, value, std::move(names), what);
  format_option_ = option;
  format_ = &value;
  describe_output();
}

void Command::add_output(std::string& path) {
  add_option("-o,--output", path, "write to this file instead of standard output")
      ->type_name("FILE");
  output_ = &path;
  describe_output();
}

void Command::describe_output() {
  if (format_ != nullptr && output_ != nullptr)
    get_option("--output")
        ->description("write to this file instead of standard output; without " + format_option_ +
                      "\nits ending chooses the format");
}

void Command::only_with(const std::vector<std::string>& options,
                        const std::vector<std::string>& choices) {
  for (const std::string& option : options) {
    get_option(option)->group("Only with " + alternatives(choices));
    facts_[option].with = choices;
  }
}

void Command::not_with(const std::vector<std::string>& options,
                       const std::vector<std::string>& choices) {
  for (const std::string& option : options) {
    get_option(option);  // throws where there is none
    facts_[option].without = choices;
  }
}

OptionFacts Command::facts(const CLI::Option& option) const {
  const auto found = facts_.find(option.get_name());
  return found == facts_.end() ? OptionFacts{} : found->second;
}

void Command::refuse(const std::vector<std::string>& options, const std::string& why) const {
  for (const std::string& option : options)
    if (is_given(option)) throw InputError(option, why);
}

bool Command::is_chosen(const std::string& choice) const {
  constexpr std::string_view conjunction = " and ";
  if (const std::size_t at = choice.find(conjunction); at != std::string::npos)
    return is_chosen(choice.substr(0, at)) && is_chosen(choice.substr(at + conjunction.size()));
  const std::size_t blank = choice.find(' ');
  const std::string option = choice.substr(0, blank);
  if (blank == std::string::npos) return is_given(option);
  const std::vector<std::string> values = values_.at(option)();
  return std::find(values.begin(), values.end(), choice.substr(blank + 1)) != values.end();
}

void Command::require_applicable() const {
  const auto chosen = [this](const std::string& choice) { return is_chosen(choice); };
  for (const auto& [option, facts] : facts_) {
    if (!is_given(option)) continue;
    if (!facts.with.empty() && std::none_of(facts.with.begin(), facts.with.end(), chosen))
      throw InputError(option, "needs " + alternatives(facts.with));
    const auto against = std::find_if(facts.without.begin(), facts.without.end(), chosen);
    if (against != facts.without.end()) throw InputError(option, "does not apply with " + *against);
  }
}

void Command::choose_format() const {
  if (format_ == nullptr || output_ == nullptr || is_given(format_option_)) return;
  const std::string end = ending(*output_);
  if (end.empty()) return;
  const auto& names = facts_.at(format_option_).names;
  for (const auto& [known, format] : formats_by_ending())
    if (known == end && std::find(names.begin(), names.end(), format) != names.end()) {
      *format_ = format;
      return;
    }
  throw InputError(
      "--output", fmt::format("\"{}\": \".{}\" is no format of {}; {} {} writes {} there",
                              abbreviated(*output_), end, get_name(), format_option_, names.front(),
                              names.front()));
}

void Command::run() {
  choose_format();
  require_applicable();
  action_();
}

std::vector<Command*> commands_of(CLI::App& program) {
  std::vector<Command*> commands;
  for (CLI::App* command :
       program.get_subcommands([](CLI::App* app) { return !app->get_group().empty(); }))
    commands.push_back(static_cast<Command*>(command));
  return commands;
}

}  // namespace phrame::cli
