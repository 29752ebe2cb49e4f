#include "phrame/cli/command.hpp"
#include "phrame/io/write/identify_report.hpp"

namespace phrame::cli {
namespace {

struct IdentifyOptions {
  CurveOptions curve;
  std::string print = "text";
  TextLength length;
};

std::string to_curve_file(const IdentifyReport& report) {
  const auto* reason = std::get_if<NotPythagorean>(&report.result);
  if (reason != nullptr) throw AnswerNo{"this is no PH curve: " + to_string(*reason)};
  return write_curve({report.name, std::get<Curve>(report.result)});
}

void run(const IdentifyOptions& options) {
  const auto print = choose<std::string (*)(const IdentifyReport&)>(
      "--print", options.print, {{"text", to_text}, {"json", to_json}, {"curve", to_curve_file}});
  const NamedHodograph named = options.curve.read_hodograph();
  const IdentifyReport report{named.name, identify(named.hodograph, named.start)};
  options.length.write(options.curve.output, print(report));
  if (std::holds_alternative<NotPythagorean>(report.result)) throw AnswerNo{};
}

}  // namespace

void add_identify(Program& program) {
  Command& command =
      program.add("identify", "is a polynomial curve Pythagorean-hodograph (PH)? its preimage");
  const auto options = std::make_shared<IdentifyOptions>();
  options->curve.add_to(command);
  command.add_format("--print", options->print, {"text", "json", "curve"},
                     "text (default), json, or curve: a curve file with the preimage");
  options->length.add_to(command);
  command.set_notes(
      "Only r' counts, given by control_points or by any preimage and multiplier; found are the A\n"
      "of least degree and f with r' = f A i A*. Exit status 1: the curve is not PH over Q.\n"
      "Examples:\n"
      "  phrame identify bezier.json\n"
      "  phrame identify bezier.json --print curve -o ph.json");
  command.does([options] { run(*options); });
}

}  // namespace phrame::cli
