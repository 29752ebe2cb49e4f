#include <fmt/format.h>

#include <algorithm>

#include "phrame/answer/angle.hpp"
#include "phrame/cli/form.hpp"
#include "phrame/io/write/answers.hpp"

namespace phrame::inline v0::cli {
namespace {

struct AngleOptions {
  CurveOptions curve;
  Parameters parameters;
  std::string frame;
  UpOption up;
  std::string route = "auto";
  FormOptions form;
  StartOptions start;
  long digits = 17;
  bool values_only = false;
};

/// What is wrong on the command line is said before the curve is read.
AngleQuery query(const AngleOptions& options) {
  AngleQuery query;
  if (!options.frame.empty()) query.reference = chosen_reference(options.frame);
  query.route = choose<Route>("--route", options.route,
                              {{"auto", Route::automatic},
                               {"roots", Route::roots},
                               {"quadrature", Route::quadrature},
                               {"both", Route::both}});
  const auto [form, style] = options.form.chosen_form();
  query.form = form;
  // The text of an angle says what the poles are; a script is to be continuous.
  const bool is_script = options.form.chosen_print().as == Print::As::script;
  query.style = style == Style::textbook && !is_script ? Style::logarithms : style;
  // Which a form from the poles does not need.
  if (query.style == Style::logarithms) query.most_poles = options.form.most_poles();
  query.start = options.start.start();
  query.digits = options.digits;
  query.wants_formula = !options.values_only;
  return query;
}

/// What the path does not have.
void require_closed_form(const Command& command, const AngleOptions& options, const Path& path) {
  const auto& segments = path.segments();
  if (std::any_of(segments.begin(), segments.end(), ph_curve)) return;
  constexpr auto why_not = "there is one of Pythagorean-hodograph curves only";
  command.refuse({"--form", "--route"}, std::string("is of closed forms: ") + why_not);
  if (options.form.chosen_print().as == Print::As::script)
    throw InputError("--print",
                     fmt::format("\"{}\" is the closed form: {}", options.form.print, why_not));
}

void run(const Command& command, const AngleOptions& options) {
  AngleQuery query = cli::query(options);
  const Print print = options.form.chosen_print();
  const NamedPath named = options.curve.read_any_path();
  const Path& path = named.path;
  require_reference(query.reference, options.up, path);
  require_closed_form(command, options, path);
  query.up = options.up.chosen(path);
  options.start.check(path, query.up, query.reference);
  options.parameters.on(named);  // where it throws
  query.at = options.parameters.given();
  query.samples = options.parameters.samples;
  query.by = options.parameters.kind();
  if (path.segments().size() > 1 && print.as == Print::As::script)
    fail_for_spline("--print", options.form.print);
  const bool is_up = reference_of(path, query.up, query.reference) == Reference::up;
  // Else the total angle is shown, at least. Who asks for JSON may ask in one way of all curves.
  if (print.as != Print::As::json && goes_on(path) && !is_up && query.at.empty() &&
      query.samples == 0)
    command.refuse({"--digits", "--route"}, "needs --at or --samples: no value is asked for");
  options.form.length.write(options.curve.output, printed(answer(named, query), print));
}

}  // namespace

void add_angle(Program& program) {
  Command& command = program.add("angle", "the exact angle of the rotation-minimizing frame");
  const auto options = std::make_shared<AngleOptions>();
  options->curve.add_to(command);
  options->parameters.add_to(command);
  command.add_choice(
      "--frame", options->frame, {"erf", "frenet", "up"},
      "the frame the angle is measured from: erf, which PH curves alone have (default\n"
      "of polynomial ones), up (default of others) or frenet");
  options->up.add_to(command,
                     "frame e2 = v x e1/|v x e1| (default: one that is nowhere along the tangent)");
  add_digits(command, options->digits);
  options->form.add_to(command);
  command.add_choice(
      "--route", options->route, {"auto", "roots", "quadrature", "both"},
      "how values are computed: auto (default), roots, quadrature, or both, which must\n"
      "agree");
  command.add_flag("--values-only", options->values_only,
                   "in JSON, no integrand and antiderivative");
  command.only_with({"--values-only"}, {"--print json"});
  options->start.add_to(command, StartOptions::Rule::reference);
  command.not_with(
      {"--at", "--samples", "--digits", "--route", "--start", "--theta0", "--start-normal"},
      FormOptions::scripts());
  command.set_notes(
      "A spline of n segments has t from 0 to n; its angle is that to the Euler-Rodrigues frame,\n"
      "made continuous through the joints, or to the Frenet frame where that is, too; of a closed\n"
      "spline the holonomy is given. Of a spline only --print text, json or latex; of a curve\n"
      "--digits and --route need --at or --samples. Curves that are not Pythagorean-hodograph\n"
      "have no closed form; their values are as certain.\n"
      "Examples:\n"
      "  phrame angle curve.json --at 0,1/2,1 --digits 50\n"
      "  phrame angle curve.json --frame frenet --samples 11 --print json\n"
      "  phrame angle - --form rothstein-trager < curve.json\n"
      "  phrame angle curve.json --form real --print maxima");
  command.does(options, run);
}

}  // namespace phrame::cli
