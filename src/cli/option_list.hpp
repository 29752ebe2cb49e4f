#pragma once
#include "phrame/cli/program.hpp"

namespace phrame::inline v0::cli {

/// An option or argument of a command, as manual pages and completion tell of it, and as a key of a
/// line of a batch and a keyword of Python's ask().
struct ListedOption {
  std::vector<std::string> names;  ///< "-o", "--output"; or "CURVE"
  std::string value;               ///< "FILE"; empty for a flag and for an argument
  std::string what;                ///< on one line
  std::string group;
  OptionFacts facts;
  bool takes_list = false;  ///< several values, separated by commas
  bool is_argument = false;
  bool is_required = false;
  bool takes_file = false;
  bool is_flag() const { return value.empty() && !is_argument; }
  const std::string& name() const { return names.back(); }
  /// Of a line: "start_normal", "curve"; empty for what is the business of a program only.
  std::string key() const;
  /// "flag", "name", "number", "file" or "text".
  std::string kind() const;
  /// What a shell can complete: names, or words among other values.
  const std::vector<std::string>& completions() const {
    return facts.names.empty() ? facts.words : facts.names;
  }
};

/// What lines of a batch that do not say otherwise ask.
inline constexpr const char* default_question = "angle";
/// Can a line of a batch ask it? What has something to be asked about, which is its argument.
bool is_question(const Command& command);

/// @{ The visible ones: arguments, options that always apply, others.
std::vector<ListedOption> listed_options(const Command& command);
std::vector<ListedOption> listed_options(const Program& program);
/// @}

}  // namespace phrame::cli
