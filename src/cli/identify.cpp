#include <fmt/format.h>

#include "phrame/algebra/rounding.hpp"
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

/// The curve, or the one that stands for it; null where there is none.
const Curve* curve_of(const IdentificationAnswer& answer) {
  if (const auto* curve = std::get_if<Curve>(&answer.result)) return curve;
  const auto* near = answer.near ? std::get_if<NearCurve>(&answer.near->found) : nullptr;
  return near != nullptr ? &near->curve : nullptr;
}

std::string why_none(const IdentificationAnswer& answer) {
  if (answer.near)
    return fmt::format("no PH curve was found within {}; the nearest one is {} away",
                       abbreviated(to_string(answer.near->epsilon)),
                       upper_bound_text(std::get<NotNear>(answer.near->found).distance));
  return "this is no PH curve: " + to_string(std::get<NotPythagorean>(answer.result));
}

std::string to_curve_file(const IdentificationAnswer& answer) {
  const Curve* curve = curve_of(answer);
  if (curve == nullptr) throw AnswerNo{why_none(answer)};
  return write_curve({answer.name, *curve});
}

void run(const IdentifyOptions& options) {
  const auto print = choose<std::string (*)(const IdentificationAnswer&)>(
      "--print", options.print, {{"text", to_text}, {"json", to_json}, {"curve", to_curve_file}});
  const auto epsilon = options.curve.epsilon();
  const NamedHodograph read = options.curve.read_hodograph();
  const IdentificationAnswer found = answer(read, epsilon);
  options.length.write(options.curve.output, print(found));
  if (curve_of(found) == nullptr) throw AnswerNo{};
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
      "of least degree and f with r' = f A i A*. Exit status 1: the curve is not PH over Q, and "
      "with\n"
      "--near EPS there is none found within EPS, the distance of control points. Where one is, "
      "it\n"
      "is told how near it is, proved, and by how much rotation-minimizing frames may differ.\n"
      "Examples:\n"
      "  phrame identify bezier.json\n"
      "  phrame identify doubles.json --near 1e-14\n"
      "  phrame identify bezier.json --print curve -o ph.json");
  command.does([options] { run(*options); });
}

}  // namespace phrame::cli
