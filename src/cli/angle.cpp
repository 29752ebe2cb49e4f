#include "phrame/cli/form.hpp"
#include "phrame/io/spline_report.hpp"
#include "phrame/io/text.hpp"

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

const std::vector<std::pair<std::string, Reference>> references{{"erf", Reference::erf},
                                                                {"frenet", Reference::frenet}};

std::string curve_report(const AngleOptions& options, const NamedCurve& named) {
  const auto reference = choose<Reference>("--frame", options.frame, references);
  const FormChoice form = options.form.chosen_form();
  const auto print = chosen_print<AngleReport>(options.form.print);
  RmfAngle angle(named.curve, reference, form.form);
  AngleReport report{named, reference,     angle, parse_option("--theta0", options.start_angle),
                     {},    options.digits};
  set_style(report, form, angle.antiderivative());
  for (const Rational& t : options.parameters.values())
    report.values.push_back(
        {t, rounded(angle.value(t) + report.start_angle,
                    "theta at t = " + abbreviated(to_string(t)), options.digits)});
  return print.text ? print.text(report) : to_script(report, print.language);
}

std::string spline_report(const AngleOptions& options, const NamedSpline& named) {
  const auto no_spline = [](const std::string& option, const std::string& value) {
    return InputError(option, "\"" + value + "\" is for single curves; this is a spline");
  };
  const FormChoice form = options.form.chosen_form();
  if (options.frame != "erf") throw no_spline("--frame", options.frame);
  if (form.style != FormChoice::Style::algebraic) throw no_spline("--form", options.form.form);
  if (options.form.print != "text" && options.form.print != "json")
    throw no_spline("--print", options.form.print);
  SplineAngle angle(named.spline, form.form);
  const auto report =
      spline_angle_report(named.name, angle, parse_option("--theta0", options.start_angle),
                          options.parameters.values(named.spline.end()), options.digits);
  return options.form.print == "text" ? to_text(report) : to_json(report);
}

void run(const AngleOptions& options) {
  // What is wrong on the command line is said before the curve is read.
  choose<Reference>("--frame", options.frame, references);
  options.form.chosen_form();
  parse_option("--theta0", options.start_angle);
  const auto print = chosen_print<AngleReport>(options.form.print);
  if (!print.text && !options.parameters.values().empty())
    throw InputError("--print", "\"" + options.form.print +
                                    "\" prints the closed form only, without --at and --samples");

  const auto read = options.curve.read_curve_or_spline();
  const auto* curve = std::get_if<NamedCurve>(&read);
  write_output(options.curve.output, curve ? curve_report(options, *curve)
                                           : spline_report(options, std::get<NamedSpline>(read)));
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
      "A spline of n segments has t from 0 to n; its angle is that to the Euler-Rodrigues frame, "
      "made\n"
      "continuous through the joints, and of a closed spline the holonomy is given.\n"
      "Examples:\n"
      "  phrame angle curve.json --at 0,1/2,1 --digits 50\n"
      "  phrame angle curve.json --frame frenet --samples 11 --print json\n"
      "  phrame angle - --form rothstein-trager < curve.json\n"
      "  phrame angle curve.json --form real --print maxima");
  command->callback([options] { run(*options); });
}

}  // namespace phrame::cli
