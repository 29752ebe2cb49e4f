#include "phrame/cli/command.hpp"
#include "phrame/io/check_report.hpp"
#include "phrame/io/frame_csv.hpp"

namespace phrame::cli {
namespace {

struct CheckCommand {
  CurveOptions curve;
  std::string frames;
  std::string tolerance = "1e-6";
  std::string start_angle;
  std::string tangent_axis = "x";
  bool is_inverse = false;
  std::string print = "text";
  TextLength length;
};

std::vector<GivenFrame> read(const CheckCommand& command, const QuaternionConvention& convention) {
  const std::string text = read_file(command.frames);
  return at_place(name_of_file(command.frames), ":", [&] { return read_frames(text, convention); });
}

void run(const CheckCommand& command) {
  const auto print = choose<std::string (*)(const CheckReport&)>(
      "--print", command.print, {{"text", to_text}, {"json", to_json}});
  command.length.require_text(command.print);
  const QuaternionConvention convention{
      choose<std::size_t>("--tangent-axis", command.tangent_axis, {{"x", 0}, {"y", 1}, {"z", 2}}),
      command.is_inverse};
  FrameCheckOptions options;
  options.tolerance = parse_option("--tol", command.tolerance);
  if (options.tolerance < 0)
    throw InputError("--tol", abbreviated(to_string(options.tolerance)) + " is negative");
  if (!command.start_angle.empty())
    options.start_angle = parse_option("--theta0", command.start_angle);
  if (command.curve.path == "-" && command.frames == "-")
    throw InputError("check", "the curve and the frames are both to be read from standard input");

  const NamedSpline named = as_spline(command.curve.read_curve_or_spline());
  const std::vector<GivenFrame> frames = read(command, convention);
  const CheckReport report{named.name, frames, options,
                           check_frames(named.spline, frames, options)};
  command.length.write(command.curve.output, print(report));
  if (!report.verdict.passes) throw AnswerNo{};
}

}  // namespace

void add_check(CLI::App& app) {
  auto* command = app.add_subcommand("check", "how far somebody's frames are from the exact one");
  const auto options = std::make_shared<CheckCommand>();
  options->curve.add_to(*command);
  command
      ->add_option("FRAMES", options->frames, "a table of frames (CSV), \"-\" for standard input")
      ->required()
      ->type_name("");
  command
      ->add_option("--tol", options->tolerance,
                   "radians, cosines and lengths that may be off (default 1e-6)")
      ->type_name("BOUND");
  command
      ->add_option("--theta0", options->start_angle,
                   "compare with the frame at this angle to e2 at t = 0, not with the first sample")
      ->type_name("ANGLE");
  command
      ->add_option("--tangent-axis", options->tangent_axis,
                   "of quaternions: the axis of the body along the tangent, x (default), y or z")
      ->type_name("AXIS");
  command->add_flag("--inverse", options->is_inverse,
                    "of quaternions: they turn the world to the body");
  command->add_option("--print", options->print, "text (default) or json")->type_name("NAME");
  options->length.add_to(*command);
  command->footer(
      "FRAMES has a header: t and f2x,f2y,f2z, optionally f3x,... and e1x,... (the tangent), or t\n"
      "and qw,qx,qy,qz. Other columns are skipped. Exit status 0: within the tolerance, 1: not.\n"
      "Examples:\n"
      "  phrame check curve.json frames.csv --tol 1e-9\n"
      "  phrame check curve.json poses.csv --tangent-axis z --print json -o check.json");
  command->callback([options] { run(*options); });
}

}  // namespace phrame::cli
