#include "phrame/cli/help_text.hpp"

#include <fmt/format.h>

#include "phrame/cli/option_list.hpp"
#include "phrame/cli/terminal.hpp"
#include "phrame/io/read/number.hpp"
#include "phrame/io/write/passage.hpp"

namespace phrame::inline v0::cli {
namespace {

/// The words of the text in lines of at most `width`, each after the first behind `indent` blanks,
/// as the first is already.
std::string filled(std::string_view text, std::size_t width, std::size_t indent = 0) {
  std::string lines;
  std::size_t used = indent;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(' '), text.size());
    const std::string word(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
    const std::size_t needed = text_width(word);
    if (lines.empty()) {
      lines = word;
    } else if (used + 1 + needed <= width) {
      lines += " " + word;
      ++used;
    } else {
      lines += "\n" + std::string(indent, ' ') + word;
      used = indent;
    }
    used += needed;
  }
  return lines + "\n";
}

/// Names, and what they mean behind them or, on narrow screens, below.
class Column {
 public:
  explicit Column(const HelpStyle& style) : style_(style) {}

  std::string row(const std::string& names, const std::string& value,
                  const std::string& what) const {
    const std::size_t indent = style_.width < 70 ? 6 : 28;
    const std::string shown = styled(names, Emphasis::bold, style_.in_colour) + value;
    const std::size_t used = 2 + text_width(names + value);
    const bool is_beside = used + 2 <= indent;
    return "  " + shown +
           (is_beside ? std::string(indent - used, ' ') : "\n" + std::string(indent, ' ')) +
           filled(what, style_.width, indent);
  }
  std::string heading(const std::string& text) const {
    return "\n" + styled(text + ":", Emphasis::heading, style_.in_colour) + "\n";
  }

 private:
  const HelpStyle& style_;
};

std::string row(const ListedOption& option, const Column& column) {
  const std::string required = option.is_required && !option.is_argument ? "(required) " : "";
  return column.row(fmt::format("{}", fmt::join(option.names, ", ")),
                    option.value.empty() ? "" : " " + option.value, required + option.what);
}

std::string rows(const std::vector<ListedOption>& options, const Column& column) {
  std::string text;
  std::string group;
  for (const ListedOption& option : options) {
    const std::string own = option.is_argument ? "Arguments" : option.group;
    if (own != group) text += column.heading(own);
    group = own;
    text += row(option, column);
  }
  return text;
}

/// Lines that begin with two blanks as they are, the others filled.
std::string notes_text(std::string_view notes, const HelpStyle& style) {
  std::string text;
  std::string paragraph;
  const auto end_paragraph = [&] {
    if (!paragraph.empty()) text += filled(paragraph, style.width);
    paragraph.clear();
  };
  while (!notes.empty()) {
    const std::string line(take_line(notes));
    if (line.starts_with("  ")) {
      end_paragraph();
      text += line + "\n";
    } else if (line.ends_with(':') && line.find(' ') == std::string::npos) {  // "Examples:"
      end_paragraph();
      text += styled(line, Emphasis::heading, style.in_colour) + "\n";
    } else {
      paragraph += (paragraph.empty() ? "" : " ") + line;
    }
  }
  end_paragraph();
  return text;
}

std::string usage(const std::string& words, const HelpStyle& style) {
  return styled("Usage:", Emphasis::heading, style.in_colour) + " " +
         filled(words, style.width, std::string_view("Usage: ").size());
}

}  // namespace

std::string help_text(const Command& command, const HelpStyle& style) {
  const Column column(style);
  const std::vector<ListedOption> options = listed_options(command);
  std::string words = "phrame " + command.name() + " [OPTIONS]";
  for (const ListedOption& option : options) {
    if (option.is_argument)
      words += option.is_required ? " " + option.names[0] : " [" + option.names[0] + "]";
    else if (option.is_required)
      words += " " + option.names.back() + " " + option.value;
  }
  std::string text =
      filled(command.what(), style.width) + usage(words, style) + rows(options, column) + "\n";
  for (const std::string& sentence : command.restrictions()) text += filled(sentence, style.width);
  return text + notes_text(command.notes(), style);
}

std::string help_text(const Program& program, const HelpStyle& style) {
  const Column column(style);
  std::string text = filled(program.what(), style.width) +
                     usage("phrame COMMAND [OPTIONS]", style) +
                     rows(listed_options(program), column) + column.heading("Commands");
  for (const Command* command : program.commands())
    text += column.row(command->name(), "", command->what());
  return text + "\n" + notes_text(program.notes(), style);
}

}  // namespace phrame::cli
