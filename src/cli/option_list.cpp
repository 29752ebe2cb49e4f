#include "phrame/cli/option_list.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>

namespace phrame::inline v0::cli {
namespace {

std::string on_one_line(const std::string& text) {
  std::string line = text;
  std::replace(line.begin(), line.end(), '\n', ' ');
  return line;
}

/// `facts` says those of an option.
template <class Facts>
std::vector<ListedOption> options_of(const CLI::App& app, const Facts& facts) {
  std::vector<ListedOption> list;
  for (const CLI::Option* option : app.get_options()) {
    if (option->get_group().empty()) continue;
    ListedOption listed;
    for (const std::string& name : option->get_snames()) listed.names.push_back("-" + name);
    for (const std::string& name : option->get_lnames()) listed.names.push_back("--" + name);
    listed.is_argument = option->get_positional();
    if (listed.is_argument) listed.names = {option->get_name(true)};
    if (option->get_items_expected_max() > 0) listed.value = option->get_type_name();
    listed.what = on_one_line(option->get_description());
    listed.group = option->get_group();
    listed.facts = facts(option->get_name());
    listed.takes_list = listed.value.ends_with(",...");
    listed.is_required = option->get_required() || !listed.facts.required_but_with.empty();
    listed.takes_file =
        listed.value == "FILE" ||
        (listed.is_argument && listed.names[0] != "EXPR" && listed.facts.names.empty());
    list.push_back(std::move(listed));
  }
  const auto rank = [](const ListedOption& option) {
    return option.is_argument ? 0 : option.group == "Options" ? 1 : 2;
  };
  std::stable_sort(list.begin(), list.end(),
                   [&](const ListedOption& a, const ListedOption& b) { return rank(a) < rank(b); });
  return list;
}

}  // namespace

bool is_question(const Command& command) {
  const ListedOption first = listed_options(command).front();
  return first.is_argument && first.is_required;
}

std::string ListedOption::key() const {
  std::string key = name();
  if (key == "--help" || key == "--version" || key == "--output") return "";
  key.erase(0, key.find_first_not_of('-'));
  for (char& c : key)
    c = c == '-' ? '_' : static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return key;
}

std::string ListedOption::kind() const {
  if (is_flag()) return "flag";
  if (!facts.names.empty()) return "name";
  if (facts.range) return "number";
  return takes_file ? "file" : "text";
}

std::vector<ListedOption> listed_options(const Command& command) {
  return options_of(command.app(),
                    [&](const std::string& option) { return command.facts(option); });
}

std::vector<ListedOption> listed_options(const Program& program) {
  return options_of(program.app(), [](const std::string&) { return OptionFacts{}; });
}

}  // namespace phrame::cli
