#include "phrame/cli/command.hpp"
#include "phrame/io/curve_info.hpp"

namespace phrame::cli {
namespace {

struct InfoOptions {
  CurveOptions curve;
  bool json = false;
  long digits = 17;
};

void run(const InfoOptions& options) {
  const NamedCurve named = options.curve.read();
  const CurveInfo info = curve_info(named, options.digits);
  write_output(options.curve.output, options.json ? to_json(info) : to_text(info));
}

}  // namespace

void add_info(CLI::App& app) {
  auto* command = app.add_subcommand("info", "the polynomials and totals of a curve");
  const auto options = std::make_shared<InfoOptions>();
  options->curve.add_to(*command);
  add_digits(*command, options->digits);
  const std::map<std::string, bool> prints{{"text", false}, {"json", true}};
  command->add_option("--print", options->json, "text (default) or json")
      ->transform(choice(prints));
  command->footer("Example:\n  phrame info curve.json --digits 30");
  command->callback([options] { run(*options); });
}

}  // namespace phrame::cli
