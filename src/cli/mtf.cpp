#include <algorithm>

#include "phrame/cli/twist_options.hpp"
#include "phrame/io/write/twist.hpp"
#include "phrame/io/write/wronskian.hpp"

namespace phrame::cli {
namespace {

struct MtfOptions {
  CurveOptions curve;
  Parameters parameters;
  TwistOptions twist;
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
  const NamedPath named = options.curve.read_path();
  if (!named.path.is_curve())
    throw InputError("--wronskian", "this is for single curves; this is a spline");
  options.length.write(options.curve.output, print(answer(named, {weight, options.digits})));
}

void run(const Command& command, const MtfOptions& options) {
  if (options.is_wronskian) return run_wronskian(options);
  const auto print = choose<std::string (*)(const MinimalTwistAnswer&)>(
      "--print", options.print, {{"text", to_text}, {"json", to_json}, {"latex", to_latex}});
  const NamedPath named = options.curve.read_path();
  const auto [from, to] = options.twist.ends(named.path);
  MinimalTwistQuery query{from, to, options.twist.turns,
                          options.parameters.values(named.path.end()), options.digits};
  const auto about = TwistOptions::of_rational_frame();
  const bool is_asked_for = std::any_of(about.begin(), about.end(), [&](const std::string& option) {
    return command.is_given(option);
  });
  if (!options.is_exact_only)
    query.rational = {options.twist.rotation(options.digits), options.twist.subdivision(named.path),
                      is_asked_for};
  options.length.write(options.curve.output, print(answer(named, query)));
}

}  // namespace

void add_mtf(Program& program) {
  Command& command = program.add("mtf", "the frame of minimal twist between two orientations");
  const auto options = std::make_shared<MtfOptions>();
  options->curve.add_to(command);
  options->twist.add_to(command);
  command.add_flag("--exact-only", options->is_exact_only, "no rational frame");
  command.add_flag("--wronskian", options->is_wronskian,
                   "instead the rational frame that is next to a rotation-minimizing one, of a\n"
                   "pair of polynomials with ab' - a'b = 2h sigma (preimages of degree 1 and 2)");
  options->parameters.add_to(command);
  add_digits(command, options->digits);
  command.add_format("--print", options->print, {"text", "json", "latex"},
                     "text (default), json or latex");
  options->length.add_to(command);
  std::vector<std::string> names;
  for (const auto& [name, weight] : frame_weights()) names.push_back(name);
  command.add_choice(
      "--weight", options->weight, names,
      "what the error of a^2 + b^2 is weighted by: one (default), torsion-curvature\n"
      "or speed");
  command.only_with({"--weight"}, {"--wronskian"});
  command.not_with(TwistOptions::of_rational_frame(), {"--exact-only", "--wronskian"});
  std::vector<std::string> others = TwistOptions::of_ends();
  others.insert(others.end(), {"--exact-only", "--at", "--samples"});
  command.not_with(others, {"--wronskian"});
  command.set_notes(
      "Angles are radians, multiples of pi or degrees: 0.3927, pi/8, -31pi/40, 45deg. e2 is that\n"
      "of the Euler-Rodrigues frame, which phrame frames --frame erf shows.\n"
      "The exact frame turns about e1 at a constant rate; the rational one is the ERF turned by\n"
      "2 arg w(t) with a polynomial w whose rate deviates least from that (root mean square).\n"
      "Examples:\n"
      "  phrame mtf curve.json --from pi/8 --to -pi/2 --samples 11\n"
      "  phrame mtf curve.json --from pi/8 --to -pi/2 --degree 3 --subdivide extrema\n"
      "  phrame mtf curve.json --from-vector 0,0,1 --to-vector 1,1,0 --digits 30 --print json\n"
      "  phrame mtf closed.json --from 0 --closed\n"
      "  phrame mtf curve.json --wronskian --weight torsion-curvature");
  command.does([&command, options] { run(command, *options); });
}

}  // namespace phrame::cli
