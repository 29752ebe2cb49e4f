#include "phrame/cli/form.hpp"

namespace phrame::cli {
namespace {

struct AngleOptions {
  CurveOptions curve;
  Parameters parameters;
  std::string frame = "erf";
  FormOptions form;
  std::string start_angle = "0";
  long digits = 17;
};

/// θ(t) + start; where that is undecided, the message names t.
Decimal rounded_angle(RmfAngle& angle, const Rational& t, const Rational& start, long digits) {
  try {
    return round_to_decimal(angle.value(t) + start, digits);
  } catch (const Undecided& error) {
    throw Undecided("theta at t = " + abbreviated(to_string(t)) + ": " + error.what());
  }
}

void run(const AngleOptions& options) {
  const auto reference = choose<Reference>(
      "--frame", options.frame, {{"erf", Reference::erf}, {"frenet", Reference::frenet}});
  const FormChoice form = options.form.chosen_form();
  const auto print = chosen_print<AngleReport>(options.form.print);
  const std::vector<Rational> at = options.parameters.values();
  if (!print.text && !at.empty())
    throw InputError("--print", "\"" + options.form.print +
                                    "\" prints the closed form only, without --at and --samples");
  const Rational start_angle = parse_option("--theta0", options.start_angle);

  const NamedCurve named = options.curve.read();
  RmfAngle angle(named.curve, reference, form.form);
  AngleReport report{named, reference, angle, start_angle, {}, options.digits};
  set_style(report, form, angle.antiderivative());
  for (const Rational& t : at)
    report.values.push_back({t, rounded_angle(angle, t, start_angle, options.digits)});
  write_output(options.curve.output,
               print.text ? print.text(report) : to_script(report, print.language));
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
  options->form.add_to(*command);
  command->add_option("--theta0", options->start_angle, "the angle at t = 0, radians (default 0)")
      ->type_name("ANGLE");
  command->footer(
      "Examples:\n"
      "  phrame angle curve.json --at 0,1/2,1 --digits 50\n"
      "  phrame angle curve.json --frame frenet --samples 11 --print json\n"
      "  phrame angle - --form rothstein-trager < curve.json\n"
      "  phrame angle curve.json --form real --print maxima");
  command->callback([options] { run(*options); });
}

}  // namespace phrame::cli
