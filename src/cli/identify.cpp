#include "phrame/cli/command.hpp"
#include "phrame/io/read/curve_file.hpp"
#include "phrame/io/write/curve_file.hpp"
#include "phrame/io/write/identification.hpp"

namespace phrame::cli {
namespace {

struct IdentifyOptions {
  CurveOptions curve;
  std::string print = "text";
  TextLength length;
};

std::string to_curve_file(const IdentificationAnswer& answer) {
  const auto* reason = std::get_if<NotPythagorean>(&answer.result);
  if (reason != nullptr) throw AnswerNo{"this is no PH curve: " + to_string(*reason)};
  return write_curve({answer.name, std::get<Curve>(answer.result)});
}

void run(const IdentifyOptions& options) {
  const auto print = choose<std::string (*)(const IdentificationAnswer&)>(
      "--print", options.print,
      {{"text", to_text}, {"json", to_json}, {"latex", to_latex}, {"curve", to_curve_file}});
  const IdentificationAnswer found = answer(options.curve.read_hodograph());
  options.length.write(options.curve.output, print(found));
  if (std::holds_alternative<NotPythagorean>(found.result)) throw AnswerNo{};
}

}  // namespace

void add_identify(Program& program) {
  Command& command =
      program.add("identify", "is a polynomial curve Pythagorean-hodograph (PH)? its preimage");
  const auto options = std::make_shared<IdentifyOptions>();
  options->curve.add_to(command);
  command.add_format("--print", options->print, {"text", "json", "latex", "curve"},
                     "text (default), json, latex, or curve: a curve file with the preimage");
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
