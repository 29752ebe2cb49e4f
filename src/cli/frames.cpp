#include "phrame/cli/command.hpp"
#include "phrame/io/frame_table.hpp"

namespace phrame::cli {
namespace {

enum class Format { csv, json, npy };

struct FramesOptions {
  CurveOptions curve;
  Parameters parameters;
  std::vector<TabulatedFrame> frames{TabulatedFrame::rmf};
  Format format = Format::csv;
};

void run(const FramesOptions& options) {
  const std::vector<Rational> at = options.parameters.values();
  if (at.empty()) throw InputError("frames", "--samples N or --at t,… says where to evaluate");
  const NamedCurve named = options.curve.read();
  const FrameTable table = frame_table(named.curve, options.frames, at);
  write_output(options.curve.output, options.format == Format::csv    ? to_csv(table)
                                     : options.format == Format::json ? to_json(table)
                                                                      : to_npy(table));
}

}  // namespace

void add_frames(CLI::App& app) {
  auto* command = app.add_subcommand("frames", "a table of t, r, e1 and frame vectors");
  const auto options = std::make_shared<FramesOptions>();
  options->curve.add_to(*command);
  options->parameters.add_to(*command);
  const std::map<std::string, TabulatedFrame> frames{{"rmf", TabulatedFrame::rmf},
                                                     {"erf", TabulatedFrame::erf},
                                                     {"frenet", TabulatedFrame::frenet}};
  const std::map<std::string, Format> formats{
      {"csv", Format::csv}, {"json", Format::json}, {"npy", Format::npy}};
  command
      ->add_option("--frame", options->frames,
                   "any of rmf (default: f2, f3), erf (e2, e3) and frenet (n, b)")
      ->transform(choice(frames))
      ->delimiter(',');
  command->add_option("--format", options->format, "csv (default), json or npy")
      ->transform(choice(formats));
  command->footer(
      "All numbers are correctly rounded doubles.\n"
      "Examples:\n"
      "  phrame frames curve.json --samples 101 -o frames.csv\n"
      "  phrame frames curve.json --frame rmf,frenet --samples 1001 --format npy -o frames.npy");
  command->callback([options] { run(*options); });
}

}  // namespace phrame::cli
