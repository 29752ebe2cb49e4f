#include "phrame/cli/command.hpp"
#include "phrame/io/angle_report.hpp"

namespace phrame::cli {
namespace {

struct AngleOptions {
  CurveOptions curve;
  Parameters parameters;
  std::string frame = "erf";
  std::string form = "auto";
  std::string print = "text";
  std::string start_angle = "0";
  long digits = 17;
};

Real shifted(const Real& x, const Rational& by) {
  if (x.exact()) return Rational(*x.exact() + by);
  if (by == 0) return x;
  return Real(
      [x, by](long bits) { return add(x.enclose(bits + 8), RealBall(by, bits + 8), bits + 8); });
}

/// θ(t) + start; where that is undecided, the message names t.
Decimal rounded_angle(RmfAngle& angle, const Rational& t, const Rational& start, long digits) {
  try {
    return round_to_decimal(shifted(angle.value(t), start), digits);
  } catch (const Undecided& error) {
    throw Undecided("theta at t = " + abbreviated(to_string(t)) + ": " + error.what());
  }
}

void run(const AngleOptions& options) {
  const auto reference = choose<Reference>(
      "--frame", options.frame, {{"erf", Reference::erf}, {"frenet", Reference::frenet}});
  const auto form = choose<Form>("--form", options.form,
                                 {{"auto", Form::automatic},
                                  {"partial-fractions", Form::partial_fractions},
                                  {"rothstein-trager", Form::rothstein_trager}});
  const auto print = choose<std::string (*)(const AngleReport&)>(
      "--print", options.print, {{"text", to_text}, {"json", to_json}, {"latex", to_latex}});
  const std::vector<Rational> at = options.parameters.values();
  const Rational start_angle = parse_option("--theta0", options.start_angle);

  const NamedCurve named = options.curve.read();
  RmfAngle angle(named.curve, reference, form);
  AngleReport report{named, reference, angle, start_angle, {}, options.digits};
  for (const Rational& t : at)
    report.values.push_back({t, rounded_angle(angle, t, start_angle, options.digits)});
  write_output(options.curve.output, print(report));
}

}  // namespace

void add_angle(CLI::App& app) {
  auto* command = app.add_subcommand("angle", "the exact angle of the rotation-minimizing frame");
  const auto options = std::make_shared<AngleOptions>();
  options->curve.add_to(*command);
  options->parameters.add_to(*command);
  command
      ->add_option("--frame", options->frame,
                   "the frame the angle is measured from: erf (default) or frenet")
      ->type_name("NAME");
  add_digits(*command, options->digits);
  command
      ->add_option("--form", options->form,
                   "of the logarithms: auto (default), partial-fractions or rothstein-trager")
      ->type_name("NAME");
  command->add_option("--print", options->print, "text (default), json or latex")
      ->type_name("NAME");
  command->add_option("--theta0", options->start_angle, "the angle at t = 0, radians (default 0)")
      ->type_name("ANGLE");
  command->footer(
      "Examples:\n"
      "  phrame angle curve.json --at 0,1/2,1 --digits 50\n"
      "  phrame angle curve.json --frame frenet --samples 11 --print json\n"
      "  phrame angle - --form rothstein-trager < curve.json");
  command->callback([options] { run(*options); });
}

}  // namespace phrame::cli
