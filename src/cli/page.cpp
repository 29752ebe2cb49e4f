#include "phrame/answer/page.hpp"

#include "phrame/cli/given_frames.hpp"
#include "phrame/io/write/names.hpp"
#include "phrame/io/write/page.hpp"

namespace phrame::inline v0::cli {
namespace {

struct PageOptions {
  CurveOptions curve;
  StartOptions start;
  UpOption up;
  long samples = 241;
  std::optional<std::string> end_normal;
  std::optional<std::string> frames;  ///< the name of a table
  std::string by = "t";
};

/// Frames that somebody else has. Throws InputError.
std::vector<GivenFrame> given_frames(const Command& command, const PageOptions& options,
                                     const NamedPath& named) {
  if (!options.frames) return {};
  std::optional<ParameterKind> by;
  if (command.is_given("--by")) by = choose("--by", options.by, parameter_kinds());
  FrameReading reading;
  return read_on_curve(named, read_file(*options.frames), name_of_file(*options.frames), by,
                       reading)
      .table.frames;
}

void run(const Command& command, const PageOptions& options) {
  if (!has_pages())
    throw InputError("page", "this phrame was built without npm, which bundles what a page needs");
  PageQuery query;
  query.samples = options.samples;
  query.start = options.start.given();
  if (options.curve.path == "-" && options.frames == "-")
    throw InputError("page", "the curve and the frames are both to be read from standard input");
  const NamedPath named = options.curve.read_any_path();
  query.given = given_frames(command, options, named);
  query.up = options.up.chosen(named.path, options.start.is_up());
  options.start.check(named.path, query.up);
  if (options.end_normal)
    query.end_normal =
        parse_normal_option("--end-normal", *options.end_normal, named.path, end_of(named.path));
  write_output(options.curve.output, to_page(answer(named, query)));
}

}  // namespace

void add_page(Program& program) {
  Command& command = program.add("page", "a page for a browser that shows a curve and its frames");
  const auto options = std::make_shared<PageOptions>();
  options->curve.add_to(command);
  command.writes("a page in HTML", {"html", "htm"});
  command.add_number("--samples", options->samples, {3, 100'000},
                     "at least so many places along the curve (default 241)", "N");
  command.add_option("--frames", "FILE", options->frames,
                     "a table of frames by another program, as phrame check reads it: they are\n"
                     "shown beside the exact ones, at their places, with their error");
  add_by(command, options->by,
         "what t is in that table (default: found out, if it is not ours): t");
  command.only_with({"--by"}, {"--frames"});
  options->start.add_to(command, StartOptions::Rule::least_rotation,
                        "default, or as the first of --frames");
  command.add_option("--end-normal", "X,Y,Z", options->end_normal,
                     "f2 of the frame of minimal twist at the end, projected to the normal plane:\n"
                     "of an open curve that frame is shown, too");
  options->up.add_to(command,
                     "frame e2 = v x e1/|v x e1| (default: one that is nowhere along the tangent)");
  command.not_with({"--samples"}, {"--frames"});
  command.set_notes(
      "The page is one HTML file, which needs no network: the curve with its frames as ribbons,\n"
      "plots over t, the formula of the angle, its poles, what is decided by algebra, and numbers\n"
      "to take along. They are correctly rounded doubles, as phrame frames has them.\n"
      "Examples:\n"
      "  phrame page curve.json -o curve.html\n"
      "  phrame page curve.json --frames mine.csv -o mine.html\n"
      "  phrame page spline.json --start-normal 0,0,1 -o spline.html");
  command.does(options, run);
}

}  // namespace phrame::cli
