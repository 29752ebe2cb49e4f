#include <cmath>

#include "phrame/cli/command.hpp"
#include "phrame/io/write/c_header.hpp"

namespace phrame::cli {
namespace {

struct CompileOptions {
  CurveOptions curve;
  std::optional<std::string> prefix;
  std::string frame = "erf";
  StartOptions start;
  UpOption up;
  std::string from = "0";
  std::string to = "1";
};

/// Rounded to a double.
double rounded(const std::string& option, const std::string& text, const Real& value) {
  const double x = round_to_double(value);
  if (!std::isfinite(x))
    throw InputError(option, "\"" + abbreviated(text) + "\" is too large for a double");
  return x;
}

/// From a t to another, within the limits of docs/compiled.md.
std::pair<double, double> interval(const CompileOptions& options) {
  const double from = rounded("--from", options.from, parse_option("--from", options.from));
  const double to = rounded("--to", options.to, parse_option("--to", options.to));
  const auto refuse = [&options](const std::string& separator, const std::string& why) {
    throw InputError("--to", "\"" + abbreviated(options.to) + "\"" + separator + why);
  };
  if (!(from < to)) refuse(" ", "is not greater than --from");
  if (to - from > 0x1p900) refuse(": ", "the interval is longer than 2^900");
  if (to - from < 0x1p-900) refuse(": ", "the interval is shorter than 2^-900");
  return {from, to};
}

/// Of a curve that is no PH curve.
CompiledAnswer compiled(const Command& command, const CompileOptions& options,
                        const NamedPath& named) {
  command.refuse({"--from", "--to"},
                 "is for single Pythagorean-hodograph curves by erf or frenet; others are compiled "
                 "as a whole");
  if (command.is_given("--frame") && options.frame == "erf")
    throw InputError("--frame", "\"erf\" " + needs_ph(named.path));
  const PathAngle angle = options.up.angle(named.path);
  options.start.check(angle);
  SmoothCompiledQuery query;
  if (options.frame == "frenet") query.reference = Reference::frenet;
  query.up = angle.up();
  query.start = options.start.start();
  return answer(named, query);
}

CompiledAnswer compiled(const Command& command, const CompileOptions& options,
                        const NamedPhPath& named) {
  const auto reference = chosen_reference(options.frame);
  const auto [from, to] = interval(options);
  options.start.check(named.path, reference);
  if (!named.path.is_curve()) {
    if (command.is_given("--from")) fail_for_spline("--from", options.from);
    if (command.is_given("--to")) fail_for_spline("--to", options.to);
  }
  return answer(named, CompiledQuery{reference, options.start.start(), from, to});
}

void run(const Command& command, const CompileOptions& options) {
  if (options.frame != "up") chosen_reference(options.frame);
  options.start.start();
  if (const auto& angle = options.start.angle)
    rounded("--theta0", *angle, to_real(parse_angle_option("--theta0", *angle)));
  interval(options);
  if (options.prefix && !is_prefix(*options.prefix))
    throw InputError("--prefix", "\"" + abbreviated(*options.prefix) +
                                     "\" is not a letter followed by letters, digits and single _");
  const AnyPath path = options.up.applied_to(options.curve.read_any_path(),
                                             options.frame == "up" || options.start.is_up());
  write_output(options.curve.output, std::visit(
                                         [&](const auto& named) {
                                           return to_c_header(
                                               compiled(command, options, named),
                                               options.prefix.value_or(prefix_from(named.name)));
                                         },
                                         path));
}

}  // namespace

void add_compile(Program& program) {
  Command& command = program.add("compile", "a C header that evaluates the angle and the frame");
  const auto options = std::make_shared<CompileOptions>();
  options->curve.add_to(command);
  command.writes("a C header", {"h", "hpp"});
  command.add_option("--prefix", "NAME", options->prefix,
                     "of the names in C (default: the curve's name)");
  command.add_choice(
      "--frame", options->frame, {"erf", "frenet", "up"},
      "the frame the angle is measured from: erf (default of PH curves), up (default of\n"
      "others), or frenet: only the angle");
  options->start.add_to(command, StartOptions::Rule::least_rotation);
  options->up.add_to(command,
                     "frame e2 = v x e1/|v x e1| (default: one that is nowhere along the tangent)");
  command.add_option("--from", "T", options->from, "the least t (default 0), rounded to a double");
  command.add_option("--to", "T", options->to, "the greatest t (default 1), rounded to a double");
  command.set_notes(
      "C99 without dependencies, in doubles; the header states the errors, proved with rounding\n"
      "included, usually below 2^-51 for the angle and 2^-50 for the frame.\n"
      "A spline of n segments has t from 0 to n, and one frame through all of them; --frame "
      "frenet,\n"
      "--from and --to are for single curves.\n"
      "Examples:\n"
      "  phrame compile curve.json -o angle.h\n"
      "  phrame compile curve.json --from -1 --to 2 --prefix arm -o arm.h");
  command.does([&command, options] { run(command, *options); });
}

}  // namespace phrame::cli
