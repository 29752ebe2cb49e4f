#include "phrame/cli/command.hpp"
#include "phrame/io/frame_table.hpp"

namespace phrame::cli {
namespace {

struct FramesOptions {
  CurveOptions curve;
  Parameters parameters;
  std::vector<std::string> frames{"rmf"};
  std::string format = "csv";
};

void run(const FramesOptions& options) {
  std::vector<TabulatedFrame> frames;
  for (const std::string& name : split(options.frames))
    frames.push_back(choose<TabulatedFrame>("--frame", name,
                                            {{"rmf", TabulatedFrame::rmf},
                                             {"erf", TabulatedFrame::erf},
                                             {"frenet", TabulatedFrame::frenet}}));
  const auto format = choose<std::string (*)(const FrameTable&)>(
      "--format", options.format, {{"csv", to_csv}, {"json", to_json}, {"npy", to_npy}});
  const std::vector<Rational> at = options.parameters.values();
  if (at.empty()) throw InputError("frames", "--samples N or --at t,… is needed");
  const NamedCurve named = options.curve.read();
  write_output(options.curve.output, format(frame_table(named.curve, frames, at)));
}

}  // namespace

void add_frames(CLI::App& app) {
  auto* command = app.add_subcommand("frames", "a table of t, r, e1 and frame vectors");
  const auto options = std::make_shared<FramesOptions>();
  options->curve.add_to(*command);
  options->parameters.add_to(*command);
  command
      ->add_option("--frame", options->frames,
                   "any of rmf (default: f2, f3), erf (e2, e3) and frenet (n, b)")
      ->type_name("NAME,...")
      ->expected(1)
      ->take_all();
  command->add_option("--format", options->format, "csv (default), json or npy")->type_name("NAME");
  command->footer(
      "All numbers are correctly rounded doubles. e1 is A i A*/|A|^2, which is the unit tangent "
      "where\n"
      "the multiplier is positive and its opposite where it is negative.\n"
      "Examples:\n"
      "  phrame frames curve.json --samples 101 -o frames.csv\n"
      "  phrame frames curve.json --frame rmf,frenet --samples 1001 --format npy -o frames.npy");
  command->callback([options] { run(*options); });
}

}  // namespace phrame::cli
