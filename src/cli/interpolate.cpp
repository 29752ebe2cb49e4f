#include "phrame/algebra/as_written.hpp"
#include "phrame/answer/machine_path.hpp"
#include "phrame/cli/feed_options.hpp"
#include "phrame/io/write/frame_table.hpp"
#include "phrame/io/write/gcode.hpp"

namespace phrame::inline v0::cli {
namespace {

struct InterpolateOptions {
  CurveOptions curve;
  std::string period;
  FeedOptions feed;
  std::string format = "csv";
  std::string tool = "f3";  ///< in G-code
  long places = 4;
  StartOptions start;
  UpOption up;
};

template <class Query>
auto answer_of(const NamedPath& path, const Query& query) {
  try {
    return answer(path, query);
  } catch (const InputError& error) {
    if (error.place() == "places") throw InputError("--places", error.reason());
    if (!error.place().empty()) throw;
    throw InputError("--period", error.reason());
  }
}

MachinePath machine_path(const Command& command, const InterpolateOptions& options,
                         const NamedPath& path, const InterpolationQuery& motion) {
  MachineQuery query{motion};
  query.tool = choose<ToolAxis>("--tool", options.tool,
                                {{"f3", ToolAxis::f3}, {"f2", ToolAxis::f2}, {"e1", ToolAxis::e1}});
  if (query.tool == ToolAxis::e1)
    command.refuse({"--start", "--theta0", "--start-normal", "--up"},
                   "e1, which the tool is along, does not depend on it");
  query.places = options.places;
  query.start = options.start.start();
  if (!options.start.given()) query.through = path.frame;
  query.up = options.up.chosen(path.path, options.start.is_up());
  options.start.check(path.path, query.up);
  return answer_of(path, query);
}

void run(const Command& command, const InterpolateOptions& options) {
  const auto format = choose<std::string (*)(const FrameTable&)>(
      "--format", options.format,
      {{"csv", to_csv}, {"json", to_json}, {"npy", to_npy}, {"gcode", nullptr}});
  const Rational period = parse_option("--period", options.period);
  if (period <= 0) throw InputError("--period", as_written(period) + " is not positive");
  const Feedrate feed = options.feed.feedrate();
  const NamedPath path = options.curve.read_any_path();
  const InterpolationQuery query{feed, period};
  write_output(options.curve.output, format == nullptr
                                         ? to_gcode(machine_path(command, options, path, query))
                                         : format(answer_of(path, query)));
}

}  // namespace

void add_interpolate(Program& program) {
  Command& command = program.add("interpolate", "the points of a motion at equal times");
  const auto options = std::make_shared<InterpolateOptions>();
  options->curve.add_to(command);
  command.add_option("--period", "TIME", options->period,
                     "the time from one point to the next, such as 1/1000");
  command.require("--period");
  options->feed.add_to(
      command,
      "the speed V: a constant, or a function of s, t or kappa with sqrt, sin or exp;\n"
      "min and max of such, and pieces, 's < 3 ? 10 : 20'");
  command.require("--feed");
  command.add_format("--format", options->format, {"csv", "json", "npy", "gcode"},
                     "csv (default), json, npy, or gcode: for a machine with the axes X Y Z A C");
  command.add_choice("--tool", options->tool, {"f3", "f2", "e1"},
                     "the vector of the rotation-minimizing frame, or of that through the\n"
                     "orientations of the file, that the tool is along, from\n"
                     "its tip to the spindle: f3 (default), f2 or e1");
  command.add_number("--places", options->places, {1, 9}, "decimals of all numbers (default 4)",
                     "N");
  options->start.add_to(command, StartOptions::Rule::least_rotation);
  options->up.add_to(command,
                     "frame that --start up starts with (default: one that is nowhere along the\n"
                     "tangent)");
  command.only_with({"--tool", "--places", "--start", "--theta0", "--start-normal"},
                    {"--format gcode"});
  command.only_with({"--up"}, {"--start up"});
  command.set_notes(
      "The columns are k, time, t, s, x, y, z: the parameter t with the integral of |r'|/V from 0\n"
      "to t equal to the time k*PERIOD, the arc length s and the point there; the last row is the\n"
      "end of the curve with the total time. All numbers are correctly rounded doubles.\n"
      "Along a spline, time, t, s and V run on through the joints.\n"
      "V is positive and a function of one of s (arc length from t = 0), t (parameter) and kappa\n"
      "(curvature of a plane curve, > 0 in a left turn). A product needs its sign: 2*s, not 2s.\n"
      "With a limit of the acceleration V is the greatest speed, and the motion the fastest one\n"
      "under all limits, each by itself; column v is its speed.\n"
      "In G-code times are in seconds, F is 1/minutes of a move (G93), and X, Y, Z are the tip of\n"
      "the tool: tool center point control must be on. A and C, in degrees, are those of a tool\n"
      "along (sin C sin A, -cos C sin A, cos A); they go on without jumps, and where A is 0 or "
      "180\n"
      "C is kept.\n"
      "Examples:\n"
      "  phrame interpolate curve.json --period 0.001 --feed 50\n"
      "  phrame interpolate curve.json --period 1/1000 --feed '10 + 2*s' -o points.csv\n"
      "  phrame interpolate curve.json --period 0.01 --feed '5 + t^2' --format json\n"
      "  phrame interpolate plane.json --period 0.01 --feed '5/(1 + 2*kappa)'\n"
      "  phrame interpolate curve.json --period 0.01 --feed 50 --max-normal-acceleration 800 \\\n"
      "    --max-tangential-acceleration 500\n"
      "  phrame interpolate curve.json --period 0.01 --feed 50 --tool f2 -o path.nc");
  command.does(options, run);
}

}  // namespace phrame::cli
