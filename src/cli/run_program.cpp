#include "phrame/cli/run_program.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <exception>
#include <new>
#include <sstream>

#include "phrame/algebra/out_of_memory.hpp"
#include "phrame/algebra/time_limit.hpp"
#include "phrame/cli/command.hpp"
#include "phrame/cli/help_text.hpp"
#include "phrame/cli/terminal.hpp"
#include "phrame/cli/usage.hpp"
#include "phrame/io/write/failure.hpp"
#include "phrame/io/write/text.hpp"
#include "phrame/version.hpp"

namespace {

enum Status { done = 0, no = 1, bad_input = 2 };  // and those of a Failure

/// One line, whatever a file or an option is called; silent, not fatal, where stderr is closed.
int complain(std::string_view what, int status) {
  const std::string name = phrame::cli::styled("phrame:", phrame::cli::Emphasis::error,
                                               phrame::cli::has_colour(STDERR_FILENO));
  std::fprintf(stderr, "%s %s\n", name.c_str(), phrame::printable(what).c_str());
  return status;
}

/// The arguments, last first, as CLI11 wants them. It takes "-x/(x^2+1)" for options, so that an
/// expression gets a blank in front; -h and -o are options.
std::vector<std::string> arguments(std::vector<std::string> list) {
  if (list.front() == "integrate")
    for (std::string& word : list)
      if (word.size() > 1 && word[0] == '-' &&
          std::string_view("-ho").find(word[1]) == std::string_view::npos)
        word.insert(0, " ");
  std::reverse(list.begin(), list.end());
  return list;
}

/// "help angle" is "angle --help".
std::vector<std::string> without_help_command(std::vector<std::string> words) {
  if (words.empty() || words[0] != "help") return words;
  if (words.size() == 1) return {"--help"};
  if (words.size() == 2 && !words[1].starts_with('-')) return {words[1], "--help"};
  return words;
}

constexpr const char* notes =
    "A curve file is JSON, such as\n"
    "  {\"phrame\": \"curve/1\", \"basis\": \"power\",\n"
    "   \"preimage\": {\"u\": [1], \"v\": [0, \"1/2\"], \"p\": [0, 0, 3], \"q\": [0.25]}}\n"
    "and means r' = f A i A* with A = u + vi + pj + qk and f = \"multiplier\", 1 if not given.\n"
    "Where f < 0, e1 = A i A*/|A|^2 of all frames is the opposite of the tangent r'/|r'|.\n"
    "Numbers are exact: 3/7, 0.1 (which is 1/10), 1e-3; on the command line 1.5/2.5, too.\n"
    "Angles there are radians, multiples of pi or degrees: 0.5, pi/4, -31pi/40, 45deg.\n"
    "Exit status: 0 done, 1 the answer is no, 2 bad input or usage, 3 mathematically undefined,\n"
    "4 undecided within the limits. \"phrame help COMMAND\" shows a command's options and "
    "examples.\n"
    "Examples:\n"
    "  phrame angle curve.json --at 0,1/2,1 --digits 50\n"
    "  phrame info curve.json --print json\n"
    "  phrame identify curve.json --print curve -o ph.json\n"
    "  phrame frames curve.json --samples 101 -o frames.csv\n"
    "  phrame interpolate curve.json --period 0.001 --feed '10 + 2*s'\n"
    "  phrame construct points.csv -o spline.json\n"
    "  phrame page spline.json -o spline.html\n"
    "  phrame batch curves.jsonl --at 1 -o angles.jsonl\n"
    "  phrame integrate '1/(x^4+1)' --from 0 --to 1 --digits 50";

/// Is it about the program itself, and not about curves?
bool is_about_program(const std::string& command) {
  return command == "help" || command == "completion" || command == "man";
}

/// Its commands, with --version and --time-limit of each: of the whole program, or the one asked
/// for.
class CommandLine {
 public:
  explicit CommandLine(const phrame::cli::CommandTable& commands) {
    const std::string version = fmt::format("phrame {}", phrame::version);
    for (const auto& [name, add] : commands) {
      add(program_);
      if (!is_about_program(name)) program_.find(name)->add_time_limit();
    }
    CLI::App& app = program_.app();
    app.set_version_flag("--version", version, "show the version");
    for (CLI::App* command : app.get_subcommands([](CLI::App*) { return true; }))
      command->set_version_flag("--version", version, "show the version");
    app.require_subcommand(0, 1);
  }

  const phrame::cli::Program& program() const { return program_; }
  CLI::App& app() const { return program_.app(); }
  /// The command that was read; null where there is none.
  phrame::cli::Command* chosen() const {
    const auto names = app().get_subcommands();
    return names.empty() ? nullptr : program_.find(names.front()->get_name());
  }

 private:
  phrame::cli::Program program_{
      "phrame",
      "Exact rotation-minimizing frames of Pythagorean-hodograph curves, and exact integrals of "
      "rational functions.",
      notes};
};

int run_chosen(const CommandLine& line) {
  phrame::cli::Command& command = *line.chosen();
  if (const std::string wrong = phrame::cli::about_swallowed_option(command); !wrong.empty())
    throw phrame::InputError(wrong);
  command.run();
  return done;
}

/// Help, and what asks for no command or is wrong, with all commands to say so; the version, which
/// is alone, without them.
int run_any(const std::vector<std::string>& words) {
  const bool is_version = words == std::vector<std::string>{"--version"};
  const CommandLine line(is_version ? phrame::cli::CommandTable() : phrame::cli::all_commands());
  const phrame::cli::Program& program = line.program();
  if (const std::string wrong = phrame::cli::complaint_about_command(program, words);
      !wrong.empty())
    throw phrame::InputError(wrong);
  try {
    line.app().parse(arguments(words));
  } catch (const CLI::CallForHelp&) {
    const phrame::cli::Command* chosen = line.chosen();
    const phrame::cli::HelpStyle style{phrame::cli::line_width(),
                                       phrame::cli::has_colour(STDOUT_FILENO)};
    // A full or closed standard output is an error.
    phrame::cli::write_output(
        "-", chosen == nullptr ? help_text(program, style) : help_text(*chosen, style));
    return done;
  } catch (const CLI::Success& success) {  // --version
    std::ostringstream text;
    line.app().exit(success, text, text);
    phrame::cli::write_output("-", text.str());
    return done;
  } catch (const CLI::ParseError& error) {
    return complain(phrame::cli::complaint(program, error), bad_input);
  }
  if (line.chosen() == nullptr)  // "--"
    throw phrame::InputError(phrame::cli::complaint_about_command(program, {}));
  return run_chosen(line);
}

int run(int argc, char** argv) {
  const std::vector<std::string> words = without_help_command({argv + 1, argv + argc});
  const auto& commands = phrame::cli::all_commands();
  const auto asked = std::find_if(commands.begin(), commands.end(), [&](const auto& entry) {
    return !words.empty() && entry.first == words.front() && !is_about_program(entry.first);
  });
  if (asked == commands.end()) return run_any(words);
  // To make the options of all commands takes longer than many an answer.
  const CommandLine line({*asked});
  try {
    line.app().parse(arguments(words));
  } catch (const CLI::Error&) {
    return run_any(words);
  }
  return run_chosen(line);
}

/// The exit status; what is wrong is told.
int status_of(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const phrame::cli::AnswerNo& answer) {
    return answer.complaint.empty() ? no : complain(answer.complaint, no);
  } catch (...) {
    const auto [status, message] = phrame::current_failure();
    return complain(message, status);
  }
}

std::terminate_handler terminated_otherwise;

[[noreturn]] void leave_undecided(std::string_view line) {
  [[maybe_unused]] const auto written = write(STDERR_FILENO, line.data(), line.size());
  _exit(4);
}

/// For want of memory even the line about it may not be written as others are, or a destructor
/// throw.
[[noreturn]] void give_up() {
  try {
    if (std::current_exception()) throw;
  } catch (const phrame::Stopped&) {
    leave_undecided("phrame: undecided within the time limit\n");
  } catch (const std::bad_alloc&) {
    leave_undecided("phrame: undecided: out of memory\n");
  } catch (...) {
  }
  terminated_otherwise();
  std::abort();
}

}  // namespace

int phrame::cli::run_program(int argc, char** argv) {
  terminated_otherwise = std::set_terminate(give_up);
  phrame::throw_when_out_of_memory();
  const int status = status_of(argc, argv);
  phrame::release_caches();
  return status;
}
