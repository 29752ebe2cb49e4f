#include <cmath>

#include "phrame/cli/command.hpp"
#include "phrame/io/write/c_header.hpp"
#include "phrame/io/write/names.hpp"

namespace phrame::inline v0::cli {
namespace {

struct CompileOptions {
  CurveOptions curve;
  std::optional<std::string> prefix;
  std::string frame;
  StartOptions start;
  UpOption up;
  std::string from = "0";
  std::string to = "1";
  std::string by = "t";
};

/// Rounded to a double.
double rounded(const std::string& option, const std::string& text, const Real& value) {
  const double x = round_to_double(value);
  if (!std::isfinite(x))
    throw InputError(option, "\"" + abbreviated(text) + "\" is too large for a double");
  return x;
}

/// From a t to another, within the limits of docs/compiled.md.
std::pair<double, double> interval(const Command& command, const CompileOptions& options,
                                   const NamedPath& named) {
  const auto kind = choose("--by", options.by, parameter_kinds());
  const auto end = [&](const std::string& option, const std::string& text) {
    const Rational x = parse_option(option, text);
    const bool is_t = kind == ParameterKind::t || !command.is_given(option);
    return rounded(option, text, is_t ? Real(x) : t_by(named, kind, x));
  };
  const double from = end("--from", options.from);
  const double to = end("--to", options.to);
  const auto refuse = [&options](const std::string& separator, const std::string& why) {
    throw InputError("--to", "\"" + abbreviated(options.to) + "\"" + separator + why);
  };
  if (!(from < to)) refuse(" ", "is not greater than --from");
  if (to - from > 0x1p900) refuse(": ", "the interval is longer than 2^900");
  if (to - from < 0x1p-900) refuse(": ", "the interval is shorter than 2^-900");
  return {from, to};
}

/// What does not go with this path.
void require_frame(const Command& command, const CompileOptions& options, const Path& path,
                   const CompiledQuery& query) {
  require_reference(query.reference, options.up, path);
  if (!path.is_ph() || query.up || path.segments().size() > 1)
    command.refuse({"--from", "--to"},
                   "is for single polynomial Pythagorean-hodograph curves by erf or frenet; others "
                   "are compiled as a whole");
}

void run(const Command& command, const CompileOptions& options) {
  CompiledQuery query;
  if (!options.frame.empty()) query.reference = chosen_reference(options.frame);
  query.start = options.start.start();
  if (const auto& angle = options.start.angle)
    rounded("--theta0", *angle, to_real(parse_angle_option("--theta0", *angle)));
  if (options.prefix && !is_prefix(*options.prefix))
    throw InputError("--prefix", "\"" + abbreviated(*options.prefix) +
                                     "\" is not a letter followed by letters, digits and single _");
  const NamedPath named = options.curve.read_any_path();
  query.up = options.up.chosen(
      named.path, query.reference == Reference::up || (options.start.is_up() && !query.reference));
  require_frame(command, options, named.path, query);
  std::tie(query.from, query.to) = interval(command, options, named);
  options.start.check(named.path, query.up, query.reference);
  write_output(options.curve.output,
               to_c_header(answer(named, query), options.prefix.value_or(prefix_from(named.name))));
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
      "the frame the angle is measured from: erf (default of polynomial PH curves), up\n"
      "(default of others), or frenet: only the angle");
  options->start.add_to(command, StartOptions::Rule::least_rotation);
  options->up.add_to(command,
                     "frame e2 = v x e1/|v x e1| (default: one that is nowhere along the tangent)");
  command.add_option("--from", "T", options->from, "the least t (default 0), rounded to a double");
  command.add_option("--to", "T", options->to, "the greatest t (default 1), rounded to a double");
  add_by(command, options->by, "what --from and --to are values of: t (default)");
  command.only_with({"--by"}, {"--from", "--to"});
  command.set_notes(
      "C99 without dependencies, in doubles; the header states the errors, proved with rounding\n"
      "included, usually below 2^-51 for the angle and 2^-50 for the frame.\n"
      "A spline of n segments has t from 0 to n, and one frame through all of them; --frame "
      "frenet,\n"
      "--from and --to are for single curves.\n"
      "Examples:\n"
      "  phrame compile curve.json -o angle.h\n"
      "  phrame compile curve.json --from -1 --to 2 --prefix arm -o arm.h");
  command.does(options, run);
}

}  // namespace phrame::cli
