// Manual pages in the man(7) macros, made of what --help says: one of the program, one a command.
#include <fmt/format.h>

#include <algorithm>

#include "phrame/cli/command.hpp"
#include "phrame/cli/option_list.hpp"
#include "phrame/io/read/number.hpp"
#include "phrame/version.hpp"

namespace phrame::inline v0::cli {
namespace {

/// Text that roff shows as it is: a "-" may be copied, nothing is a command.
std::string literal(std::string_view text) {
  std::string result;
  for (const char c : text) switch (c) {
      case '\\':
        result += "\\e";
        break;
      case '-':
        result += "\\-";
        break;
      case '\'':
        result += "\\(aq";
        break;
      case '`':
        result += "\\(ga";
        break;
      case '^':
        result += "\\(ha";
        break;
      case '~':
        result += "\\(ti";
        break;
      default:
        result += c;
    }
  return result.starts_with('.') ? "\\&" + result : result;
}

std::string heading(const std::string& title) { return fmt::format(".SH {}\n", title); }

/// The lines below --help's options: text, indented lines as they are, and "Examples:".
std::string body(const std::string& notes) {
  std::string page;
  bool is_indented = false;
  std::string_view rest = notes;
  while (!rest.empty()) {
    const std::string_view line = take_line(rest);
    const bool indented = line.starts_with("  ");
    if (indented && !is_indented) page += ".PP\n.RS 4\n.nf\n";
    if (!indented && is_indented) page += ".fi\n.RE\n.PP\n";
    is_indented = indented;
    page += line == "Examples:" ? heading("EXAMPLES")
                                : literal(indented ? line.substr(2) : line) + "\n";
  }
  return page + (is_indented ? ".fi\n.RE\n" : "");
}

std::string item(const ListedOption& option) {
  std::string names;
  for (const std::string& name : option.names)
    names += fmt::format("{}{}{}\\fR", names.empty() ? "" : ", ",
                         option.is_argument ? "\\fI" : "\\fB", literal(name));
  if (!option.value.empty()) names += " \\fI" + literal(option.value) + "\\fR";
  return fmt::format(".TP\n{}\n{}{}\n", names, literal(option.what),
                     option.is_required && !option.is_argument ? " (required)" : "");
}

std::string synopsis(const Command& command) {
  std::string text = fmt::format(".B phrame {}\n", literal(command.name()));
  std::string arguments;
  for (const ListedOption& option : listed_options(command)) {
    if (option.is_argument)
      arguments += fmt::format(fmt::runtime(option.is_required ? " \\fI{}\\fR" : " [\\fI{}\\fR]"),
                               option.names[0]);
    else if (option.is_required)
      arguments +=
          fmt::format(" \\fB{}\\fR \\fI{}\\fR", literal(option.names[0]), literal(option.value));
  }
  return text + "[\\fIOPTIONS\\fR]" + arguments + "\n";
}

std::string options(const Command& command) {
  std::string text;
  std::string group;
  for (const ListedOption& option : listed_options(command)) {
    if (option.group != group && option.group != "Options" && !option.is_argument)
      text += fmt::format(".SS {}\n", literal(option.group));
    if (!option.is_argument) group = option.group;
    text += item(option);
  }
  return text;
}

std::string restrictions(const Command& command) {
  std::string text;
  for (const std::string& sentence : command.restrictions()) text += literal(sentence) + "\n.PP\n";
  return text;
}

/// Of man(1): without a date, so that a build can be repeated.
std::string title(const std::string& name) {
  std::string upper = name;
  for (char& c : upper) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return fmt::format(".TH \"{}\" 1 \"\" \"phrame {}\" \"phrame\"\n", literal(upper), version);
}

constexpr const char* exit_status =
    ".TP\n0\ndone\n.TP\n1\nthe answer is no, or does not hold\n.TP\n2\nbad input or usage: one "
    "line on "
    "standard error says what and where\n.TP\n3\nmathematically undefined: a pole, a cusp\n.TP\n4\n"
    "undecided within the limits, of which the one is named\n";

std::string page_of(const Command& command) {
  const std::string name = "phrame-" + command.name();
  return title(name) + heading("NAME") +
         fmt::format("{} \\- {}\n", literal(name), literal(command.what())) + heading("SYNOPSIS") +
         synopsis(command) + heading("OPTIONS") + options(command) + heading("NOTES") +
         restrictions(command) + body(command.notes()) + heading("EXIT STATUS") + exit_status +
         heading("SEE ALSO") + ".BR phrame (1)\n";
}

std::string page_of_program(const Program& program) {
  std::string commands;
  std::string pages;
  for (const Command* command : program.commands()) {
    const std::string name = literal(command->name());
    commands += fmt::format(".TP\n.B {}\n{}\n", name, literal(command->what()));
    pages += fmt::format("{}.BR phrame\\-{} (1)", pages.empty() ? "" : ",\n", name);
  }
  return title("phrame") + heading("NAME") + "phrame \\- " +
         literal("exact rotation-minimizing frames of Pythagorean-hodograph curves") + "\n" +
         heading("SYNOPSIS") + ".B phrame\n\\fICOMMAND\\fR [\\fIOPTIONS\\fR] ...\n.br\n" +
         ".B phrame help\n\\fICOMMAND\\fR\n" + heading("DESCRIPTION") + literal(program.what()) +
         "\n" + heading("COMMANDS") + commands + heading("NOTES") + body(program.notes()) +
         heading("EXIT STATUS") + exit_status + heading("SEE ALSO") + pages + "\n";
}

}  // namespace

void add_man(Program& program) {
  Command& command = program.add_hidden("man", "a manual page, in roff");
  const auto name = std::make_shared<std::string>();
  command.add_optional_argument("COMMAND", *name, "of this command; of the program if not given");
  command.does([&program, name] {
    if (name->empty()) return write_output("-", page_of_program(program));
    std::vector<std::pair<std::string, const Command*>> pages;
    for (const Command* known : program.commands()) pages.emplace_back(known->name(), known);
    write_output("-", page_of(*choose("COMMAND", *name, pages)));
  });
}

}  // namespace phrame::cli
