#include <fmt/format.h>

#include <cstdio>
#include <new>

#include "phrame/cli/command.hpp"
#include "phrame/version.hpp"

namespace {

enum Status { done = 0, bad_input = 2, undefined = 3, undecided = 4 };

int complain(const char* what, int status) {
  fmt::print(stderr, "phrame: {}\n", what);
  return status;
}

int run(int argc, char** argv) {
  CLI::App app("Exact rotation-minimizing frames of Pythagorean-hodograph curves.", "phrame");
  app.set_version_flag("--version", fmt::format("phrame {}", phrame::version));
  app.require_subcommand(0, 1);  // 0: an unknown word is then named, see below
  app.footer(
      "Exit status: 0 done, 2 bad input or usage, 3 mathematically undefined, 4 undecided within\n"
      "the limits. \"phrame COMMAND --help\" shows examples.");
  phrame::cli::add_angle(app);
  phrame::cli::add_info(app);
  phrame::cli::add_frames(app);
  try {
    app.parse(argc, argv);
    if (app.get_subcommands().empty())
      throw phrame::InputError("a command is needed: angle, info or frames (phrame --help)");
    return done;
  } catch (const CLI::Success& success) {  // --help, --version
    app.exit(success);
    phrame::cli::write_output("-", "");  // a closed standard output is an error here too
    return done;
  } catch (const CLI::ParseError& error) {
    return complain(fmt::format("{} (phrame --help)", error.what()).c_str(), bad_input);
  }
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const phrame::InputError& error) {
    return complain(error.what(), bad_input);
  } catch (const phrame::DomainError& error) {
    return complain(error.what(), undefined);
  } catch (const phrame::Undecided& error) {
    return complain(error.what(), undecided);
  } catch (const std::bad_alloc&) {
    return complain("out of memory", undecided);
  } catch (const std::exception& error) {
    return complain(error.what(), undecided);
  }
}
