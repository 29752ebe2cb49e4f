#pragma once
#include <CLI/CLI.hpp>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace phrame::cli {

/// What CLI11 does not know of an option; help, completion and manual pages say it, too.
struct OptionFacts {
  std::vector<std::string> names;  ///< that it takes; empty where it takes something else
  bool takes_list = false;         ///< several, separated by commas
  /// Choices like "--at", "--from and --to" or "--frame mtf": it means something with one of these
  /// only, …
  std::vector<std::string> with;
  std::vector<std::string> without;  ///< … and with none of these
};

/// A command of the program.
class Command : public CLI::App {
 public:
  /// Adds itself to the program, which keeps it.
  static Command* add(CLI::App& program, const std::string& name, const std::string& what);

  /// An option that takes one of these names; `value` is the default.
  void add_choice(const std::string& option, std::string& value, std::vector<std::string> names,
                  const std::string& what);
  /// An option that takes a list of these names.
  void add_choices(const std::string& option, std::vector<std::string>& values,
                   std::vector<std::string> names, const std::string& what);
  /// The choice of a format. Where it is not made, the ending of the output file makes it.
  void add_format(const std::string& option, std::string& value, std::vector<std::string> names,
                  const std::string& what);
  /// -o
  void add_output(std::string& path);

  /// To be called after all options were added.
  void only_with(const std::vector<std::string>& options, const std::vector<std::string>& choices);
  void not_with(const std::vector<std::string>& options, const std::vector<std::string>& choices);
  OptionFacts facts(const CLI::Option& option) const;

  /// What the command does.
  void does(std::function<void()> action) { action_ = std::move(action); }
  /// Does it. Throws InputError for an option that does not apply, and what the action throws.
  void run();

  bool is_given(const std::string& option) const { return get_option(option)->count() > 0; }
  /// Throws InputError for one that is given: "--digits: `why`".
  void refuse(const std::vector<std::string>& options, const std::string& why) const;

 private:
  Command(const std::string& what, const std::string& name, CLI::App* program)
      : CLI::App(what, name, program) {}

  bool is_chosen(const std::string& choice) const;
  void require_applicable() const;
  void choose_format() const;
  void describe_output();

  std::map<std::string, OptionFacts> facts_;
  std::map<std::string, std::function<std::vector<std::string>()>> values_;  ///< of choices, now
  std::string format_option_;
  std::string* format_ = nullptr;
  std::string* output_ = nullptr;
  std::function<void()> action_;
};

/// The commands, without hidden ones.
std::vector<Command*> commands_of(CLI::App& program);

}  // namespace phrame::cli
