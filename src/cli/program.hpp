#pragma once
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace phrame::inline v0::cli {

/// Whole numbers, the ends included.
struct WholeNumbers {
  long least;
  long most;
};

/// What CLI11 does not know of an option; help, completion and manual pages say it, too.
struct OptionFacts {
  std::vector<std::string> names;  ///< that it takes; empty where it takes something else
  std::vector<std::string> words;  ///< that it takes, too, where it takes something else
  /// Choices like "--at", "--from and --to" or "--frame mtf": it means something with one of these
  /// only, …
  std::vector<std::string> with;
  std::vector<std::string> without;  ///< … and with none of these
  std::string required_but_with;     ///< it is required, but with this choice; else empty
  std::optional<WholeNumbers> range;
  std::optional<std::string> by_default;  ///< where that is one value, whatever else is given
  std::optional<std::string> in_lines;    ///< the same of a line of a batch, where that is another
};

/// "json" of "runs/x.JSON", "3mf" of "x.3mf"; empty where the name has no ".", or only digits after
/// it, as in "t-0.5".
std::string ending(const std::string& path);

/// A command of the program: what can be given to it, and what it then does.
///
/// It is CLI11 that reads the command line. Its header takes longer to compile than a command does,
/// so that only the files that read and explain command lines include it.
class Command {
 public:
  /// "angle"
  std::string name() const;
  /// In a line, for the list of commands.
  std::string what() const;
  /// What the help says below the options: lines that may be filled, lines that begin with two
  /// blanks as they are, and "Examples:".
  const std::string& notes() const { return notes_; }
  void set_notes(const std::string& text) { notes_ = text; }
  /// "Not with --a or --b: --c, --d.", for all options that do not go with others.
  std::vector<std::string> restrictions() const;

  // What can be given. Each `value` is written when the command line is read; until then it is the
  // default. `value_name` stands for it in the help: "FILE".
  void add_argument(const std::string& argument, std::string& value, const std::string& what);
  void add_optional_argument(const std::string& argument, std::string& value,
                             const std::string& what);
  /// Any number of them, behind the others.
  void add_optional_arguments(const std::string& argument, std::vector<std::string>& values,
                              const std::string& what);
  void add_option(const std::string& option, const std::string& value_name, std::string& value,
                  const std::string& what);
  void add_option(const std::string& option, const std::string& value_name,
                  std::optional<std::string>& value, const std::string& what);
  /// Lists separated by commas, which split() takes apart; it may be given several times.
  void add_list(const std::string& option, const std::string& value_name,
                std::vector<std::string>& values, const std::string& what);
  void add_number(const std::string& option, long& value, WholeNumbers range,
                  const std::string& what, const std::string& value_name = "N");
  void add_flag(const std::string& option, bool& value, const std::string& what);
  /// One that says what is so without it, too.
  void add_hidden_flag(const std::string& option);
  /// An option or argument that takes one of these names; `value` is the default.
  void add_choice(const std::string& option, std::string& value, std::vector<std::string> names,
                  const std::string& what);
  /// An option that takes a list of these names.
  void add_choices(const std::string& option, std::vector<std::string>& values,
                   std::vector<std::string> names, const std::string& what);
  /// An option of add_option() that takes a list, of these words among other things.
  void add_words(const std::string& option, std::vector<std::string> words);
  /// The choice of a format. Where it is not made, the ending of the output file makes it.
  void add_format(const std::string& option, std::string& value, std::vector<std::string> names,
                  const std::string& what);
  /// It has JSON only with this choice, "--exact".
  void json_only_with(const std::string& choice);
  /// -o
  void add_output(std::string& path);
  /// What --output is always in, "a page in HTML", with the endings of such files: those that mean
  /// another format are refused.
  void writes(std::string what, std::vector<std::string> endings);

  /// --time-limit, of the whole command or, where the command says so, of what it does one by one.
  void add_time_limit();
  /// As given. Throws InputError for what is no number of seconds > 0.
  std::optional<double> time_limit() const;
  /// The command itself sees to it.
  void limits_time_of(std::string what) { what_is_limited_ = std::move(what); }

  // To be called after all options were added.
  void require(const std::string& option);
  void require_but_with(const std::string& choice, const std::string& option);
  void only_with(const std::vector<std::string>& options, const std::vector<std::string>& choices);
  void not_with(const std::vector<std::string>& options, const std::vector<std::string>& choices);
  const OptionFacts& facts(const std::string& option) const;

  /// What the command does with its options, which it keeps: what they are now are their defaults.
  template <class Options>
  void does(std::shared_ptr<Options> options, void (*action)(const Command&, const Options&)) {
    action_ = [this, options, action] { action(*this, *options); };
    to_defaults_.emplace_back([options, defaults = *options] { *options = defaults; });
  }
  template <class Options>
  void does(std::shared_ptr<Options> options, void (*action)(const Options&)) {
    action_ = [options, action] { action(*options); };
    to_defaults_.emplace_back([options, defaults = *options] { *options = defaults; });
  }
  /// What a command about the program does.
  void does(std::function<void()> action) { action_ = std::move(action); }
  /// Does it. Throws InputError for an option that does not apply, and what the action throws.
  void run();

  // A command that answers a line of a batch has its options from there.
  /// As if it were on the command line. Throws InputError.
  void give(const std::string& option, const std::string& value);
  /// Does the option go with those that are given?
  bool applies(const std::string& option) const;
  /// Chooses JSON where no format is given and it has that.
  void prefer_json();
  /// Has it the choice of a format, and is that JSON?
  bool writes_json() const { return format_ != nullptr && *format_ == "json"; }
  /// What run() does, in the midst of others: no line says how far it is, nothing ends the program.
  void answer();
  /// Forgets what was given: the options are their defaults again.
  void forget();
  /// Throws InputError: "--format: \"npy\" `why`".
  [[noreturn]] void refuse_format(const std::string& why) const;

  bool is_given(const std::string& option) const;
  /// All that are given, with their values, of which several are a list with commas.
  std::vector<std::pair<std::string, std::string>> given() const;
  /// Throws InputError for one that is given: "--digits: `why`".
  void refuse(const std::vector<std::string>& options, const std::string& why) const;

  const CLI::App& app() const { return app_; }

 private:
  friend class Program;
  explicit Command(CLI::App& app) : app_(app) {}

  CLI::Option& named(const std::string& name) const;  ///< throws where there is none
  OptionFacts& facts_of(const CLI::Option& option);
  bool is_chosen(const std::string& choice) const;
  /// Throws InputError where one of its values is none of these.
  void require_known_names(const std::string& option, const std::vector<std::string>& names) const;
  void require_applicable() const;
  void choose_format() const;
  void check_ending() const;
  void describe_output();

  CLI::App& app_;                                                  ///< within the program's
  mutable std::unordered_map<std::string, CLI::Option*> options_;  ///< that were asked for
  std::map<std::string, OptionFacts> facts_;
  std::map<std::string, std::function<std::vector<std::string>()>> values_;  ///< of choices, now
  std::string notes_;
  std::string format_option_;
  std::string json_needs_;
  std::string* format_ = nullptr;
  std::string* output_ = nullptr;
  std::optional<std::string> time_limit_;
  std::string what_is_limited_;  ///< where that is not the command
  std::string what_it_writes_;   ///< where that is in one format
  std::vector<std::string> own_endings_;
  std::function<void()> action_;
  std::vector<std::function<void()>> to_defaults_;
};

/// The program: its commands.
class Program {
 public:
  Program(const std::string& name, const std::string& what, const std::string& notes);
  ~Program();
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  std::string what() const;
  const std::string& notes() const { return notes_; }

  /// A new command; it lives as long as the program.
  Command& add(const std::string& name, const std::string& what);
  /// One that help does not list.
  Command& add_hidden(const std::string& name, const std::string& what);
  /// The commands, without hidden ones.
  std::vector<const Command*> commands() const;
  /// The one with that name, hidden or not; null where there is none.
  Command* find(const std::string& name) const;

  CLI::App& app() const { return *app_; }

 private:
  std::unique_ptr<CLI::App> app_;
  std::string notes_;
  std::vector<std::unique_ptr<Command>> commands_;
};

}  // namespace phrame::cli
