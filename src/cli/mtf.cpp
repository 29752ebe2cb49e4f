#include "phrame/cli/command.hpp"
#include "phrame/io/angle_text.hpp"
#include "phrame/io/twist_report.hpp"

namespace phrame::cli {
namespace {

struct MtfOptions {
  CurveOptions curve;
  Parameters parameters;
  std::string from;
  std::string to;
  std::string from_vector;
  std::string to_vector;
  bool is_closed = false;
  long turns = 0;
  std::string print = "text";
  long digits = 17;
};

Vector<Rational> parse_vector(const std::string& option, const std::string& text) {
  const auto parts = split({text});
  if (parts.size() != 3)
    throw InputError(option, "\"" + abbreviated(text) + "\" is not a vector x,y,z");
  return {parse_option(option, parts[0]), parse_option(option, parts[1]),
          parse_option(option, parts[2])};
}

/// The angle given as such or by a vector, at t on the curve.
FrameAngle boundary(const std::string& name, const std::string& angle, const std::string& vector,
                    const Curve& curve, const Rational& t) {
  if (!angle.empty()) return at_place(name, "", [&] { return parse_angle(angle); });
  const std::string option = name + "-vector";
  const auto v = parse_vector(option, vector);
  try {
    return angle_of(v, euler_rodrigues_frame(curve, t));
  } catch (const DomainError& error) {
    throw InputError(option, error.what());
  }
}

void require_one(const std::string& name, int given) {
  if (given != 1)
    throw InputError(name, given == 0 ? "the angle is missing" : "the angle is given twice");
}

void run(const MtfOptions& options) {
  const auto print = choose<std::string (*)(const TwistReport&)>(
      "--print", options.print, {{"text", to_text}, {"json", to_json}});
  const auto given = [](const std::string& text) { return text.empty() ? 0 : 1; };
  require_one("--from", given(options.from) + given(options.from_vector));
  require_one("--to", given(options.to) + given(options.to_vector) + (options.is_closed ? 1 : 0));

  const NamedSpline named = as_spline(options.curve.read_curve_or_spline());
  const auto& segments = named.spline.segments();
  const FrameAngle from =
      boundary("--from", options.from, options.from_vector, segments.front(), 0);
  FrameAngle to;
  if (options.is_closed) {
    const auto closing = named.spline.closing_turn();
    if (!closing) throw DomainError("--closed: the curve is not closed with a continuous tangent");
    to = from + angle_of(*closing * *closing);
  } else {
    to = boundary("--to", options.to, options.to_vector, segments.back(), 1);
  }
  SplineAngle rmf(named.spline);
  const MinimalTwist mtf(rmf, from, to, options.turns);
  write_output(options.curve.output,
               print(twist_report(named.name, named.spline, from, to, mtf,
                                  options.parameters.values(named.spline.end()), options.digits)));
}

}  // namespace

void add_mtf(CLI::App& app) {
  auto* command = app.add_subcommand("mtf", "the frame of minimal twist between two orientations");
  const auto options = std::make_shared<MtfOptions>();
  options->curve.add_to(*command);
  command->add_option("--from", options->from, "the angle of f2 to e2 at the start")
      ->type_name("ANGLE");
  command->add_option("--to", options->to, "the same at the end")->type_name("ANGLE");
  command
      ->add_option("--from-vector", options->from_vector,
                   "f2 at the start, projected to the normal plane")
      ->type_name("X,Y,Z");
  command->add_option("--to-vector", options->to_vector, "f2 at the end, projected")
      ->type_name("X,Y,Z");
  command->add_flag("--closed", options->is_closed,
                    "of a closed spline: the frame ends as it starts");
  command->add_option("--turns", options->turns, "so many revolutions more (default 0)")
      ->type_name("K")
      ->check(CLI::Range(-1'000'000L, 1'000'000L).description(""));
  options->parameters.add_to(*command);
  add_digits(*command, options->digits);
  command->add_option("--print", options->print, "text (default) or json")->type_name("NAME");
  command->footer(
      "Angles are radians or multiples of pi: 0.3927, pi/8, -31pi/40, 5/8*pi. e2 is that of the\n"
      "Euler-Rodrigues frame, which phrame frames --frame erf shows.\n"
      "Examples:\n"
      "  phrame mtf curve.json --from pi/8 --to -pi/2 --samples 11\n"
      "  phrame mtf curve.json --from-vector 0,0,1 --to-vector 1,1,0 --digits 30 --print json\n"
      "  phrame mtf closed.json --from 0 --closed");
  command->callback([options] { run(*options); });
}

}  // namespace phrame::cli
