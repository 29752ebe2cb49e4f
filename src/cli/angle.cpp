#include "phrame/cli/form.hpp"
#include "phrame/io/write/spline_report.hpp"
#include "phrame/io/write/text.hpp"

namespace phrame::cli {
namespace {

struct AngleOptions {
  CurveOptions curve;
  Parameters parameters;
  std::string frame = "erf";
  std::string route = "auto";
  FormOptions form;
  std::string start_angle = "0";
  long digits = 17;
};

/// The options, read. What is wrong on the command line is said before the curve is read.
struct Choices {
  Reference reference;
  Route route;
  FormChoice form;
  Print<AngleReport> print;
  Angle start_angle;
};

Choices choices(const AngleOptions& options) {
  const Choices chosen{chosen_reference(options.frame),
                       choose<Route>("--route", options.route,
                                     {{"auto", Route::automatic},
                                      {"roots", Route::roots},
                                      {"quadrature", Route::quadrature},
                                      {"both", Route::both}}),
                       options.form.chosen_form(), chosen_print<AngleReport>(options.form.print),
                       parse_angle_option("--theta0", options.start_angle)};
  return chosen;
}

std::string curve_report(const Command& command, const AngleOptions& options, const Choices& chosen,
                         const NamedCurve& named) {
  if (options.parameters.values().empty())  // of a spline the total angle is shown, at least
    command.refuse({"--digits", "--route"}, "needs --at or --samples: no value is asked for");
  RmfAngle angle(named.curve, chosen.reference, chosen.form.form);
  angle.take(chosen.route);
  AngleReport report{named, chosen.reference, angle, chosen.start_angle, {}, options.digits};
  report.lists_all_poles = options.form.length.is_full;
  // The text of an angle says what the poles are; a script is to be continuous.
  if (chosen.form.style != FormChoice::Style::textbook || !chosen.print.text)
    set_style(report, chosen.form, angle.antiderivative());
  for (const Rational& t : options.parameters.values())
    report.values.push_back(rounded_angle(t, angle.value(t, chosen.start_angle), options.digits));
  return chosen.print.text ? chosen.print.text(report) : to_script(report, chosen.print.language);
}

std::string spline_report(const AngleOptions& options, const Choices& chosen,
                          const NamedSpline& named) {
  const auto require = [](bool is_possible, const std::string& option, const std::string& value) {
    if (!is_possible) fail_for_spline(option, value);
  };
  const std::string& print = options.form.print;
  require(chosen.reference == Reference::erf, "--frame", options.frame);
  require(chosen.form.style == FormChoice::Style::algebraic ||
              chosen.form.style == FormChoice::Style::textbook,
          "--form", options.form.form);
  require(print == "text" || print == "json", "--print", print);
  SplineAngle angle(named.spline, chosen.form.form);
  angle.take(chosen.route);
  const auto report =
      spline_angle_report(named.name, angle, chosen.start_angle,
                          options.parameters.values(named.spline.end()), options.digits);
  return print == "text" ? to_text(report) : to_json(report);
}

void run(const Command& command, const AngleOptions& options) {
  const Choices chosen = choices(options);
  const auto read = options.curve.read_curve_or_spline();
  const auto* curve = std::get_if<NamedCurve>(&read);
  options.form.length.write(options.curve.output,
                            curve ? curve_report(command, options, chosen, *curve)
                                  : spline_report(options, chosen, std::get<NamedSpline>(read)));
}

}  // namespace

void add_angle(Program& program) {
  Command& command = program.add("angle", "the exact angle of the rotation-minimizing frame");
  const auto options = std::make_shared<AngleOptions>();
  options->curve.add_to(command);
  options->parameters.add_to(command);
  add_reference(command, options->frame,
                "the frame the angle is measured from: erf (default) or frenet");
  add_digits(command, options->digits);
  options->form.add_to(command);
  command.add_choice(
      "--route", options->route, {"auto", "roots", "quadrature", "both"},
      "how values are computed: auto (default), roots, quadrature, or both, which must\n"
      "agree");
  add_start_angle(command, options->start_angle);
  command.not_with({"--at", "--samples", "--digits", "--route", "--theta0"},
                   FormOptions::scripts());
  command.set_notes(
      "A spline of n segments has t from 0 to n; its angle is that to the Euler-Rodrigues frame,\n"
      "made continuous through the joints, and of a closed spline the holonomy is given. Of a\n"
      "spline only --frame erf, --print text or json and no --form real or radicals; of a curve\n"
      "--digits and --route need --at or --samples.\n"
      "Examples:\n"
      "  phrame angle curve.json --at 0,1/2,1 --digits 50\n"
      "  phrame angle curve.json --frame frenet --samples 11 --print json\n"
      "  phrame angle - --form rothstein-trager < curve.json\n"
      "  phrame angle curve.json --form real --print maxima");
  command.does([&command, options] { run(command, *options); });
}

}  // namespace phrame::cli
