// An option of a command is described once: one more is told of and taken everywhere.
#include "cli/workshop.hpp"
#include "phrame/cli/ask.hpp"
#include "phrame/cli/exchange.hpp"
#include "phrame/cli/help_text.hpp"
#include "phrame/cli/listing.hpp"

namespace table_test {

using namespace phrame;
using namespace phrame::test;

namespace {

struct Ink {
  std::string colour = "red";
  bool is_bright = false;
};

void write(const Ink& ink) {
  cli::write_output("-", Json{{"ink", ink.colour}, {"bright", ink.is_bright}}.dump());
}

/// The command totals with an option more, which is all that it then tells of.
void add_totals_with_more(cli::Program& program) {
  cli::add_totals(program);
  cli::Command& command = *program.find("totals");
  const auto ink = std::make_shared<Ink>();
  command.add_choice("--ink-colour", ink->colour, {"red", "blue"}, "what the answer is written in");
  command.add_flag("--bright-ink", ink->is_bright, "more of it");
  command.not_with({"--bright-ink"}, {"--ink-colour blue"});
  command.does(ink, write);
}

const cli::CommandTable with_more{{"totals", add_totals_with_more}};

/// What a command of the program writes.
std::string written(cli::Program& program, const std::string& command, const std::string& argument,
                    const std::string& value) {
  cli::Exchange exchange;
  program.find(command)->give(argument, value);
  program.find(command)->answer();
  return exchange.output;
}

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

Json ask(const Json& line) { return Json::parse(cli::ask(line.dump(), std::nullopt, with_more)); }

}  // namespace

TEST_CASE("table: an option more is in help, manual page, completion, listing and schema") {
  cli::Program program("phrame", "", "");
  add_totals_with_more(program);
  cli::add_completion(program);
  cli::add_man(program);
  const cli::Command& command = *program.find("totals");
  CHECK(has(help_text(command, {}), "--ink-colour NAME"));
  CHECK(has(help_text(command, {}), "Not with --ink-colour blue: --bright-ink."));
  CHECK(has(written(program, "man", "COMMAND", "totals"), "\\-\\-ink\\-colour"));
  for (const std::string shell : {"bash", "zsh", "fish"}) {
    cli::Program other("phrame", "", "");
    add_totals_with_more(other);
    cli::add_completion(other);
    const std::string script = written(other, "completion", "SHELL", shell);
    CHECK(has(script, "ink-colour"));
    CHECK(has(script, "red blue"));
  }
  const Json options = Json::parse(cli::listing({&command}))["commands"][0]["options"];
  const auto listed = std::find_if(options.begin(), options.end(), [](const Json& option) {
    return option["key"] == "ink_colour";
  });
  REQUIRE(listed != options.end());
  CHECK((*listed)["choices"] == Json{"red", "blue"});
  CHECK((*listed)["default"] == "red");
  const Json schema = Json::parse(cli::line_schema({&command}))["$defs"]["totals"];
  CHECK(schema.at("properties").at("ink_colour").at("enum") == Json{"red", "blue"});
  CHECK(schema.at("properties").at("bright_ink").at("type") == "boolean");
  CHECK(has(schema.at("allOf").dump(), "ink_colour"));
}

TEST_CASE("table: an option more is a key of a line and a keyword of Python's ask()") {
  const Json line{{"question", "totals"}, {"curve", Json::object()}};
  const auto with = [&line](const Json& more) {
    Json all = line;
    all.update(more);
    return all;
  };
  CHECK(ask(line) == Json{{"ink", "red"}, {"bright", false}});
  CHECK(ask(with({{"ink_colour", "blue"}})) == Json{{"ink", "blue"}, {"bright", false}});
  CHECK(ask(with({{"bright_ink", true}})) == Json{{"ink", "red"}, {"bright", true}});
  CHECK_THROWS_WITH_AS(ask(with({{"ink_colour", "blue"}, {"bright_ink", true}})),
                       "/bright_ink: does not apply with --ink-colour blue", InputError);
  CHECK_THROWS_AS(cli::ask(with({{"ink_colour", "blue"}}).dump()), InputError);
  CHECK(has(cli::question_table(with_more), "\"ink_colour\""));
  CHECK_FALSE(has(cli::question_table(), "\"ink_colour\""));
}

}  // namespace table_test
