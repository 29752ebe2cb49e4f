#include "phrame/cli/command.hpp"
#include "phrame/io/write/curve_info.hpp"
#include "phrame/io/write/spline_report.hpp"

namespace phrame::cli {
namespace {

struct InfoOptions {
  CurveOptions curve;
  std::string print = "text";
  TextLength length;
  long digits = 17;
};

enum class Print { text, json };

template <class Info>
std::string printed(const Info& info, Print print) {
  return print == Print::text ? to_text(info) : to_json(info);
}

void run(const InfoOptions& options) {
  const Print print =
      choose<Print>("--print", options.print, {{"text", Print::text}, {"json", Print::json}});
  const auto read = options.curve.read_curve_or_spline();
  const auto* curve = std::get_if<NamedCurve>(&read);
  options.length.write(
      options.curve.output,
      curve ? printed(curve_info(*curve, options.digits), print)
            : printed(spline_info(std::get<NamedSpline>(read), options.digits), print));
}

}  // namespace

void add_info(Program& program) {
  Command& command = program.add("info", "the polynomials and totals of a curve or spline");
  const auto options = std::make_shared<InfoOptions>();
  options->curve.add_to(command);
  add_digits(command, options->digits);
  command.add_format("--print", options->print, {"text", "json"}, "text (default) or json");
  options->length.add_to(command);
  command.set_notes(
      "In JSON, arc_length is an exact text, or a value with its radius where the multiplier\n"
      "changes sign on [0, 1] and it is irrational; bending_energy is null where it is infinite.\n"
      "Examples:\n"
      "  phrame info curve.json --digits 30\n"
      "  phrame info curve.json --print json -o info.json");
  command.does([options] { run(*options); });
}

}  // namespace phrame::cli
