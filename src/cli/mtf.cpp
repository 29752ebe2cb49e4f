#include <fmt/format.h>

#include <algorithm>

#include "phrame/answer/minimal_twist.hpp"
#include "phrame/answer/path_twist.hpp"
#include "phrame/answer/wronskian.hpp"
#include "phrame/cli/twist_options.hpp"
#include "phrame/io/write/answers.hpp"
#include "phrame/io/write/names.hpp"

namespace phrame::inline v0::cli {
namespace {

struct MtfOptions {
  CurveOptions curve;
  Parameters parameters;
  TwistOptions twist;
  UpOption up;
  bool is_exact_only = false;
  bool is_wronskian = false;
  std::string weight = "one";
  std::string print = "text";
  TextLength length;
  long digits = 17;
};

void run_wronskian(const MtfOptions& options) {
  const auto print = choose<std::string (*)(const WronskianAnswer&)>(
      "--print", options.print, {{"text", to_text}, {"json", to_json}, {"latex", to_latex}});
  const FrameWeight weight = choose<FrameWeight>("--weight", options.weight, frame_weights());
  const NamedPhPath named = options.curve.read_path();
  if (!named.path.is_curve())
    throw InputError("--wronskian", "this is for single curves; this is a spline");
  options.length.write(options.curve.output, print(answer(named, {weight, options.digits})));
}

/// Of a curve that is no PH curve, or by its frame of v, there is no rational frame, but where it
/// is not asked for that is but said.
MinimalTwistAnswer found(const Command& command, const MtfOptions& options,
                         const NamedPath& named) {
  const Path& path = named.path;
  const auto about = TwistOptions::of_rational_frame();
  const bool is_asked_for = std::any_of(about.begin(), about.end(), [&](const std::string& option) {
    return command.is_given(option);
  });
  const auto [from, to] = options.twist.ends(path);
  MinimalTwistQuery query{from,
                          to,
                          options.twist.turns,
                          options.parameters.given(),
                          options.digits,
                          options.up.chosen(path)};
  options.parameters.on(named);  // where it throws
  query.by = options.parameters.kind();
  query.samples = options.parameters.samples;
  if (path.is_ph() && !query.up) {
    if (!options.is_exact_only)
      query.rational = {options.twist.rotation(options.digits),
                        options.twist.subdivision(named, options.parameters.kind()), is_asked_for};
    return answer(named, query);
  }
  command.refuse(about, path.is_ph() ? "is of rational frames, whose angles are not those of --up"
                                     : "is of rational frames; such a one " + needs_ph(path));
  MinimalTwistAnswer found = answer(named, query);
  if (!options.is_exact_only)
    found.why_not_rational =
        path.is_ph()     ? "--up is of the exact frame"
        : path.has_erf() ? "it is of polynomial Pythagorean-hodograph curves, not of rational ones"
                         : "the curve is not Pythagorean-hodograph";
  return found;
}

/// Through the orientations that come with the path.
void run_through(const Command& command, const MtfOptions& options, const NamedPath& named) {
  const auto print = choose<std::string (*)(const PathTwistAnswer&)>(
      "--print", options.print, {{"text", to_text}, {"json", to_json}, {"latex", to_latex}});
  command.refuse(
      TwistOptions::of_rational_frame(),
      "is of rational frames between two ends; the file has orientations at joints, which "
      "the exact frame meets");
  options.parameters.on(named);  // where it throws
  const PathTwistQuery query{options.parameters.given(), options.digits,
                             options.up.chosen(named.path), options.parameters.kind(),
                             options.parameters.samples};
  options.length.write(options.curve.output, print(answer(named, query)));
}

void run(const Command& command, const MtfOptions& options) {
  if (options.is_wronskian) return run_wronskian(options);
  const auto print = choose<std::string (*)(const MinimalTwistAnswer&)>(
      "--print", options.print, {{"text", to_text}, {"json", to_json}, {"latex", to_latex}});
  const NamedPath named = options.curve.read_any_path();
  if (named.frame && !options.twist.has_ends()) return run_through(command, options, named);
  options.length.write(options.curve.output, print(found(command, options, named)));
}

}  // namespace

void add_mtf(Program& program) {
  Command& command = program.add("mtf", "the frame of minimal twist between two orientations");
  const auto options = std::make_shared<MtfOptions>();
  options->curve.add_to(command);
  options->twist.add_to(command);
  options->up.add_to(command,
                     "frame e2 = v x e1/|v x e1| (default: one that is nowhere along the tangent)");
  command.add_flag("--exact-only", options->is_exact_only, "no rational frame");
  command.add_flag("--wronskian", options->is_wronskian,
                   "instead the rational frame that is next to a rotation-minimizing one, of a\n"
                   "pair of polynomials with ab' - a'b = 2h sigma (preimages of degree 1 and 2)");
  options->parameters.add_to(command, {"--subdivide"});
  add_digits(command, options->digits);
  command.add_format("--print", options->print, {"text", "json", "latex"},
                     "text (default), json or latex");
  options->length.add_to(command);
  command.add_choice(
      "--weight", options->weight, keys(frame_weights()),
      "what the error of a^2 + b^2 is weighted by: one (default), torsion-curvature\n"
      "or speed");
  command.only_with({"--weight"}, {"--wronskian"});
  command.not_with(TwistOptions::of_rational_frame(), {"--exact-only", "--wronskian"});
  std::vector<std::string> others = TwistOptions::of_ends();
  others.insert(others.end(), {"--exact-only", "--at", "--samples", "--up"});
  command.not_with(others, {"--wronskian"});
  command.set_notes(
      "Angles are radians, multiples of pi or degrees: 0.3927, pi/8, -31pi/40, 45deg. e2 is that\n"
      "of the Euler-Rodrigues frame, which phrame frames --frame erf shows; of a curve that is "
      "not\n"
      "Pythagorean-hodograph, which has the exact frame only, that of v (--frame up).\n"
      "The exact frame turns about e1 at a constant rate; the rational one is the ERF turned by\n"
      "2 arg w(t) with a polynomial w whose rate deviates least from that (root mean square).\n"
      "Of a file with orientations, as phrame construct makes of poses, it is the frame through "
      "all\n"
      "of these, unless other ends are asked for.\n"
      "Examples:\n"
      "  phrame mtf curve.json --samples 11\n"
      "  phrame mtf curve.json --from pi/8 --to -pi/2 --samples 11\n"
      "  phrame mtf curve.json --from pi/8 --to -pi/2 --degree 3 --subdivide extrema\n"
      "  phrame mtf curve.json --from-vector 0,0,1 --to-vector 1,1,0 --digits 30 --print json\n"
      "  phrame mtf closed.json --from 0 --closed\n"
      "  phrame mtf curve.json --wronskian --weight torsion-curvature");
  command.does(options, run);
}

}  // namespace phrame::cli
