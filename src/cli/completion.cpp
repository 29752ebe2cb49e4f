// What the shells complete: scripts made of the commands and options that there are, which need
// nothing but the shell.
#include <fmt/format.h>

#include <algorithm>

#include "phrame/cli/command.hpp"
#include "phrame/cli/option_list.hpp"

namespace phrame::inline v0::cli {
namespace {

std::string words(const std::vector<std::string>& list, const char* separator = " ") {
  return fmt::format("{}", fmt::join(list, separator));
}

std::string replaced(std::string text, std::string_view what, std::string_view by) {
  for (std::size_t at = text.find(what); at != std::string::npos;
       at = text.find(what, at + by.size()))
    text.replace(at, what.size(), by);
  return text;
}

/// Within '…' of bash and zsh.
std::string shell_quoted(const std::string& text) {
  return "'" + replaced(text, "'", "'\\''") + "'";
}

constexpr const char* bash_script = R"(# bash completion of phrame
_phrame_names() {{  # the word, "list" or "one", names
  local prefix=
  if [[ $2 == list ]]; then
    [[ $1 == *,* ]] && prefix=${{1%,*}},
    compopt -o nospace 2>/dev/null
  fi
  COMPREPLY=($(compgen -P "$prefix" -W "$3" -- "${{1##*,}}"))
}}
_phrame_files() {{
  local IFS=$'\n'
  compopt -o filenames 2>/dev/null
  COMPREPLY=($(compgen -f -- "$1"))
}}
_phrame() {{
  local cur=${{COMP_WORDS[COMP_CWORD]}} prev=${{COMP_WORDS[COMP_CWORD-1]}} options names
  COMPREPLY=()
  if ((COMP_CWORD == 1)); then
    COMPREPLY=($(compgen -W '{commands} --help --version' -- "$cur"))
    return
  fi
  if [[ $cur == = ]]; then  # --option=value is three words
    cur=
  elif [[ $prev == = ]]; then
    prev=${{COMP_WORDS[COMP_CWORD-2]}}
  fi
  case ${{COMP_WORDS[1]}} in
{cases}  *) return ;;
  esac
  if [[ $cur == -* ]]; then
    COMPREPLY=($(compgen -W "$options" -- "$cur"))
  elif [[ $names == - ]]; then
    _phrame_files "$cur"
  else
    COMPREPLY=($(compgen -W "$names" -- "$cur"))
  fi
}}
complete -F _phrame phrame
)";

/// The case of one command.
std::string bash_case(const Command& command) {
  std::string text = fmt::format("  {})\n    case $prev in\n", command.name());
  std::vector<std::string> options;
  std::string names;  // of the argument, "-" for a file
  for (const ListedOption& option : listed_options(command)) {
    if (option.is_argument) {
      names = option.takes_file ? "-" : words(option.completions());
      continue;
    }
    options.insert(options.end(), option.names.begin(), option.names.end());
    if (option.is_flag()) continue;
    const std::string then =
        option.takes_file ? "_phrame_files \"$cur\"; "
        : option.completions().empty()
            ? ""
            : fmt::format("_phrame_names \"$cur\" {} '{}'; ", option.takes_list ? "list" : "one",
                          words(option.completions()));
    text += fmt::format("    {}) {}return ;;\n", words(option.names, "|"), then);
  }
  return text +
         fmt::format("    esac\n    options='{}' names='{}'\n    ;;\n", words(options), names);
}

std::string bash(const Program& program) {
  std::vector<std::string> commands;
  std::string cases;
  for (const Command* command : program.commands()) {
    commands.push_back(command->name());
    cases += bash_case(*command);
  }
  return fmt::format(bash_script, fmt::arg("commands", words(commands)), fmt::arg("cases", cases));
}

/// A text within [ ] and ' ' of _arguments.
std::string zsh_text(const std::string& text) {
  return replaced(replaced(replaced(text, "\\", "\\\\"), "[", "\\["), "]", "\\]");
}

/// A specification for _arguments.
std::string zsh_option(const ListedOption& option) {
  const auto colons = [](const std::string& text) { return replaced(text, ":", "\\:"); };
  std::string action;
  if (option.takes_file)
    action = "_files";
  else if (option.takes_list && !option.completions().empty())
    action = "_values -s , name " + words(option.completions());
  else if (!option.completions().empty())
    action = "(" + words(option.completions()) + ")";
  if (option.is_argument)
    return shell_quoted(
        fmt::format("1:{}:{}", colons(option.names[0]), action.empty() ? " " : action));
  std::string text = "[" + zsh_text(option.what) + "]";
  if (!option.is_flag())
    text += fmt::format(":{}:{}", colons(option.value), action.empty() ? " " : action);
  const std::string repeated = option.takes_list ? "*" : "";
  if (option.names.size() == 1) return shell_quoted(repeated + option.names[0] + text);
  return fmt::format("'({})'{{{}}}{}", words(option.names), words(option.names, ","),
                     shell_quoted(text));
}

std::string zsh(const Program& program) {
  std::string commands;
  std::string cases;
  for (const Command* command : program.commands()) {
    commands += fmt::format("      {}\n", shell_quoted(command->name() + ":" + command->what()));
    cases += fmt::format("    {})\n      _arguments", command->name());
    for (const ListedOption& option : listed_options(*command))
      cases += " \\\n        " + zsh_option(option);
    cases += "\n      ;;\n";
  }
  return "#compdef phrame\n_phrame() {\n  local curcontext=$curcontext state line\n"
         "  _arguments -C '(- *)'{-h,--help}'[show this help]' '(- *)--version[show the version]' "
         "\\\n"
         "    '1:command:->command' '*::argument:->argument'\n"
         "  case $state in\n  command)\n    local -a commands=(\n" +
         commands +
         "    )\n    _describe command commands\n    ;;\n  argument)\n    case $words[1] in\n" +
         cases +
         "    esac\n    ;;\n  esac\n}\n"
         "if [ \"$funcstack[1]\" = _phrame ]; then\n  _phrame \"$@\"\nelse\n  compdef _phrame "
         "phrame\nfi\n";
}

/// Within '…' of fish.
std::string fish_quoted(const std::string& text) {
  return "'" + replaced(replaced(text, "\\", "\\\\"), "'", "\\'") + "'";
}

std::string fish_option(const std::string& command, const ListedOption& option) {
  std::string line = fmt::format("complete -c phrame -n '__fish_seen_subcommand_from {}'", command);
  if (!option.is_argument)
    for (const std::string& name : option.names)
      line += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
  if (option.takes_file)
    line += option.is_argument ? " -F" : " -r -F";
  else if (!option.is_flag() && !option.is_argument)
    line += " -x";
  if (!option.completions().empty())
    line += option.takes_list
                ? fmt::format(" -a '(__fish_append , {})'", words(option.completions()))
                : fmt::format(" -a '{}'", words(option.completions()));
  if (!option.is_argument) line += " -d " + fish_quoted(option.what);
  return line + "\n";
}

std::string fish(const Program& program) {
  std::string text =
      "# fish completion of phrame\ncomplete -c phrame -f\n"
      "complete -c phrame -n __fish_use_subcommand -s h -l help -d 'show this help'\n"
      "complete -c phrame -n __fish_use_subcommand -l version -d 'show the version'\n";
  for (const Command* command : program.commands())
    text += fmt::format("complete -c phrame -n __fish_use_subcommand -a {} -d {}\n",
                        command->name(), fish_quoted(command->what()));
  for (const Command* command : program.commands())
    for (const ListedOption& option : listed_options(*command))
      if (!option.is_argument || option.takes_file || !option.completions().empty())
        text += fish_option(command->name(), option);
  return text;
}

}  // namespace

void add_completion(Program& program) {
  Command& command = program.add_hidden("completion", "a script that completes the command line");
  const auto shell = std::make_shared<std::string>();
  command.add_choice("SHELL", *shell, {"bash", "zsh", "fish"}, "bash, zsh or fish");
  command.require("SHELL");
  command.does([&program, shell] {
    const auto write = choose<std::string (*)(const Program&)>(
        "SHELL", *shell, {{"bash", bash}, {"zsh", zsh}, {"fish", fish}});
    write_output("-", write(program));
  });
}

}  // namespace phrame::cli
