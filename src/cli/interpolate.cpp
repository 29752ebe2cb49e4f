#include "phrame/answer/interpolation.hpp"
#include "phrame/cli/command.hpp"
#include "phrame/io/read/feedrate.hpp"
#include "phrame/io/write/frame_table.hpp"

namespace phrame::cli {
namespace {

struct InterpolateOptions {
  CurveOptions curve;
  std::string period;
  std::string feed;
  std::string format = "csv";
};

FrameTable points(const AnyPath& path, const InterpolationQuery& query) {
  try {
    return std::visit([&](const auto& named) { return answer(named, query); }, path);
  } catch (const InputError& error) {
    if (!error.place().empty()) throw;
    throw InputError("--period", error.reason());
  }
}

void run(const InterpolateOptions& options) {
  const auto format = choose<std::string (*)(const FrameTable&)>(
      "--format", options.format, {{"csv", to_csv}, {"json", to_json}, {"npy", to_npy}});
  const Rational period = parse_option("--period", options.period);
  if (period <= 0)
    throw InputError("--period", abbreviated(to_string(period)) + " is not positive");
  const Feedrate feed = at_place("--feed", ", ", [&] { return parse_feedrate(options.feed); });
  const AnyPath path = options.curve.read_any_path();
  write_output(options.curve.output, format(points(path, {feed, period})));
}

}  // namespace

void add_interpolate(Program& program) {
  Command& command = program.add("interpolate", "the points of a motion at equal times");
  const auto options = std::make_shared<InterpolateOptions>();
  options->curve.add_to(command);
  command.add_option("--period", "TIME", options->period,
                     "the time from one point to the next, such as 1/1000");
  command.require("--period");
  command.add_option("--feed", "EXPR", options->feed,
                     "the speed V: a constant, or a rational function of s, t or kappa");
  command.require("--feed");
  command.add_format("--format", options->format, {"csv", "json", "npy"},
                     "csv (default), json or npy");
  command.set_notes(
      "The columns are k, time, t, s, x, y, z: the parameter t with the integral of |r'|/V from 0\n"
      "to t equal to the time k*PERIOD, the arc length s and the point there; the last row is the\n"
      "end of the curve with the total time. All numbers are correctly rounded doubles.\n"
      "Along a spline, time, t, s and V run on through the joints.\n"
      "V is positive and a function of one of s (arc length from t = 0), t (parameter) and kappa\n"
      "(curvature of a plane curve, > 0 in a left turn). A product needs its sign: 2*s, not 2s.\n"
      "Examples:\n"
      "  phrame interpolate curve.json --period 0.001 --feed 50\n"
      "  phrame interpolate curve.json --period 1/1000 --feed '10 + 2*s' -o points.csv\n"
      "  phrame interpolate curve.json --period 0.01 --feed '5 + t^2' --format json\n"
      "  phrame interpolate plane.json --period 0.01 --feed '5/(1 + 2*kappa)'");
  command.does([options] { run(*options); });
}

}  // namespace phrame::cli
