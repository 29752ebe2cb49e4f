#include "phrame/answer/classification.hpp"
#include "phrame/cli/command.hpp"
#include "phrame/io/write/answers.hpp"
#include "phrame/ph/curve/special_points.hpp"

namespace phrame::inline v0::cli {
namespace {

struct ClassifyOptions {
  CurveOptions curve;
  std::string print = "text";
  TextLength length;
};

void run(const ClassifyOptions& options) {
  const auto print = choose<std::string (*)(const ClassificationAnswer&)>(
      "--print", options.print, {{"text", to_text}, {"json", to_json}, {"latex", to_latex}});
  options.length.write(options.curve.output,
                       print(answer(options.curve.read_any_path(), ClassificationQuery{})));
}

}  // namespace

void add_classify(Program& program) {
  Command& command =
      program.add("classify", "what kind of curve it is, each answer with its witness");
  const auto options = std::make_shared<ClassifyOptions>();
  options->curve.add_to(command);
  command.add_format("--print", options->print, {"text", "json", "latex"},
                     "text (default), json or latex");
  options->length.add_to(command);
  command.set_notes(
      "Decided exactly: regular, inflections, straight line, plane, helix, double PH, primitive,\n"
      "whether the Euler-Rodrigues frame (ERF) or any rational frame is rotation-minimizing\n"
      "(RMF), and where the ERF turns back. Of a spline each segment, and what is true of all;\n"
      "of segments that are not Pythagorean-hodograph what they are with the others.\n"
      "Examples:\n"
      "  phrame classify curve.json\n"
      "  phrame classify curve.json --print json -o class.json");
  command.does(options, run);
}

}  // namespace phrame::cli
