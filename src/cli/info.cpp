#include "phrame/answer/info.hpp"
#include "phrame/cli/command.hpp"
#include "phrame/io/write/answers.hpp"

namespace phrame::inline v0::cli {
namespace {

struct InfoOptions {
  CurveOptions curve;
  std::string print = "text";
  TextLength length;
  long digits = 17;
  bool wants_box = false;
  std::optional<std::string> nearest;
};

void run(const InfoOptions& options) {
  const auto print = choose<std::string (*)(const InfoAnswer&)>(
      "--print", options.print, {{"text", to_text}, {"json", to_json}, {"latex", to_latex}});
  InfoQuery query{options.digits, options.wants_box, {}};
  if (options.nearest) query.nearest = parse_vector_option("--nearest", *options.nearest);
  NamedPath path = options.curve.read_any_path();
  options.length.write(options.curve.output, print(answer(std::move(path), query)));
}

}  // namespace

void add_info(Program& program) {
  Command& command = program.add("info", "the polynomials and totals of a curve or spline");
  const auto options = std::make_shared<InfoOptions>();
  options->curve.add_to(command);
  add_digits(command, options->digits);
  command.add_format("--print", options->print, {"text", "json", "latex"},
                     "text (default), json or latex");
  options->length.add_to(command);
  command.add_flag("--box", options->wants_box,
                   "the box around the path, exactly: x, y and z from, to");
  command.add_option("--nearest", "X,Y,Z", options->nearest,
                     "where the path is nearest to this point, and how near");
  command.set_notes(
      "In JSON, arc_length is an exact text, or a value with its radius where the multiplier\n"
      "changes sign on [0, 1] and it is irrational; bending_energy is null where it is infinite.\n"
      "Of curves that are not Pythagorean-hodograph the twist is that of the frame of a vector v.\n"
      "Examples:\n"
      "  phrame info curve.json --digits 30\n"
      "  phrame info curve.json --box --nearest 1,2,3\n"
      "  phrame info curve.json --print json -o info.json");
  command.does(options, run);
}

}  // namespace phrame::cli
