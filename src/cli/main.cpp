#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <sstream>

#include "phrame/cli/command.hpp"
#include "phrame/io/failure.hpp"
#include "phrame/io/text.hpp"
#include "phrame/version.hpp"

namespace {

enum Status { done = 0, no = 1, bad_input = 2 };  // and those of a Failure

/// One line, whatever a file or an option is called; silent, not fatal, where stderr is closed.
int complain(std::string_view what, int status) {
  std::fprintf(stderr, "phrame: %s\n", phrame::printable(what).c_str());
  return status;
}

/// CLI11 would call the first word and all that follow it "not expected".
void require_known_command(const std::vector<CLI::App*>& commands, int argc, char** argv) {
  std::string names;
  for (const CLI::App* command : commands)
    names += fmt::format("{}{}", names.empty() ? "" : ", ", command->get_name());
  const std::string there_are = fmt::format("there are {} (phrame --help)", names);
  if (argc < 2) throw phrame::InputError(fmt::format("a command is needed: {}", there_are));
  const std::string word = argv[1];
  const bool known = std::any_of(commands.begin(), commands.end(), [&](const CLI::App* command) {
    return command->get_name() == word;
  });
  if (!known && !word.starts_with('-'))
    throw phrame::InputError(
        fmt::format("\"{}\" is not a command: {}", phrame::abbreviated(word), there_are));
}

/// The arguments, last first, as CLI11 wants them. It takes "-x/(x^2+1)" for options, so that an
/// expression gets a blank in front; -h and -o are options.
std::vector<std::string> arguments(int argc, char** argv) {
  std::vector<std::string> list(argv + 1, argv + argc);
  if (list.front() == "integrate")
    for (std::string& word : list)
      if (word.size() > 1 && word[0] == '-' &&
          std::string_view("-ho").find(word[1]) == std::string_view::npos)
        word.insert(0, " ");
  std::reverse(list.begin(), list.end());
  return list;
}

int run(int argc, char** argv) {
  CLI::App app(
      "Exact rotation-minimizing frames of Pythagorean-hodograph curves, and exact integrals of "
      "rational functions.",
      "phrame");
  app.footer(
      "Examples:\n"
      "  phrame angle curve.json --at 0,1/2,1 --digits 50\n"
      "  phrame info curve.json --print json\n"
      "  phrame identify curve.json --print curve -o ph.json\n"
      "  phrame frames curve.json --samples 101 -o frames.csv\n"
      "  phrame interpolate curve.json --period 0.001 --feed '10 + 2*s'\n"
      "  phrame batch curves.jsonl --at 1 -o angles.jsonl\n"
      "  phrame integrate '1/(x^4+1)' --from 0 --to 1 --digits 50\n"
      "A curve file is JSON, such as\n"
      "  {\"phrame\": \"curve/1\", \"basis\": \"power\",\n"
      "   \"preimage\": {\"u\": [1], \"v\": [0, \"1/2\"], \"p\": [0, 0, 3], \"q\": [0.25]}}\n"
      "and means r' = f A i A* with A = u + vi + pj + qk and f = \"multiplier\", 1 if not given.\n"
      "Where f < 0, e1 = A i A*/|A|^2 of all frames is the opposite of the tangent r'/|r'|.\n"
      "Exit status: 0 done, 1 the answer is no, 2 bad input or usage, 3 mathematically undefined,\n"
      "4 undecided within the limits. \"phrame COMMAND --help\" shows examples.");
  phrame::cli::add_angle(app);
  phrame::cli::add_info(app);
  phrame::cli::add_classify(app);
  phrame::cli::add_totals(app);
  phrame::cli::add_frames(app);
  phrame::cli::add_mtf(app);
  phrame::cli::add_interpolate(app);
  phrame::cli::add_identify(app);
  phrame::cli::add_integrate(app);
  phrame::cli::add_batch(app);
  phrame::cli::add_compile(app);
  phrame::cli::add_check(app);
  phrame::cli::add_certify(app);
  phrame::cli::add_verify(app);
  phrame::cli::add_prove(app);
  const auto commands = app.get_subcommands([](const CLI::App*) { return true; });
  const std::string version = fmt::format("phrame {}", phrame::version);
  app.set_version_flag("--version", version);
  for (CLI::App* command : commands) command->set_version_flag("--version", version);
  app.require_subcommand(0, 1);
  require_known_command(commands, argc, argv);
  try {
    app.parse(arguments(argc, argv));
    return done;
  } catch (const CLI::Success& success) {  // --help, --version
    std::ostringstream text;
    app.exit(success, text, text);
    phrame::cli::write_output("-", text.str());  // a full or closed standard output is an error
    return done;
  } catch (const CLI::ParseError& error) {
    const auto chosen = app.get_subcommands();
    const std::string command = chosen.empty() ? "" : chosen.front()->get_name() + " ";
    return complain(fmt::format("{} (phrame {}--help)", error.what(), command), bad_input);
  }
}

}  // namespace

int main(int argc, char** argv) {
  const struct Cleanup {
    ~Cleanup() { phrame::release_caches(); }
  } cleanup;
  try {
    return run(argc, argv);
  } catch (const phrame::cli::AnswerNo& answer) {
    return answer.complaint.empty() ? no : complain(answer.complaint, no);
  } catch (...) {
    const auto [status, message] = phrame::current_failure();
    return complain(message, status);
  }
}
