#include "phrame/cli/command.hpp"
#include "phrame/io/curve_info.hpp"

namespace phrame::cli {
namespace {

struct InfoOptions {
  CurveOptions curve;
  std::string print = "text";
  long digits = 17;
};

void run(const InfoOptions& options) {
  const auto print = choose<std::string (*)(const CurveInfo&)>(
      "--print", options.print, {{"text", to_text}, {"json", to_json}});
  const NamedCurve named = options.curve.read();
  write_output(options.curve.output, print(curve_info(named, options.digits)));
}

}  // namespace

void add_info(CLI::App& app) {
  auto* command = app.add_subcommand("info", "the polynomials and totals of a curve");
  const auto options = std::make_shared<InfoOptions>();
  options->curve.add_to(*command);
  add_digits(*command, options->digits);
  command->add_option("--print", options->print, "text (default) or json")->type_name("NAME");
  command->footer(
      "In JSON, arc_length is an exact text, or a value with its radius where the multiplier "
      "changes\n"
      "sign on [0, 1] and it is irrational; bending_energy is null where it is infinite.\n"
      "Examples:\n"
      "  phrame info curve.json --digits 30\n"
      "  phrame info curve.json --print json -o info.json");
  command->callback([options] { run(*options); });
}

}  // namespace phrame::cli
