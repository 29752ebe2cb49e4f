#include "phrame/answer/offset.hpp"

#include "phrame/cli/command.hpp"
#include "phrame/io/write/answers.hpp"
#include "phrame/io/write/names.hpp"
#include "phrame/io/write/nurbs.hpp"
#include "phrame/io/write/svg.hpp"

namespace phrame::inline v0::cli {
namespace {

struct OffsetOptions {
  CurveOptions curve;
  std::vector<std::string> distances;
  std::string join = "round";
  bool trim = false;
  bool pocket = false;
  std::string print = "text";
  TextLength length;
  std::string output;
  long digits = 17;
};

std::string write_offset_nurbs(const OffsetAnswer& answer) { return write_nurbs(nurbs(answer)); }

OffsetQuery query(const OffsetOptions& options) {
  OffsetQuery query{{},
                    choose("--join", options.join, offset_joins()),
                    options.digits,
                    options.trim,
                    options.pocket};
  for (const std::string& text : split(options.distances)) {
    query.distances.push_back(parse_option("--distance", text));
    if (query.distances.back() == 0) throw InputError("--distance", "0 is no distance");
  }
  if (query.pocket && query.distances.size() != 1)
    throw InputError("--pocket", "one distance is wanted, of which the others are multiples");
  return query;
}

void run(const OffsetOptions& options) {
  const auto print = choose<std::string (*)(const OffsetAnswer&)>("--print", options.print,
                                                                  {{"text", to_text},
                                                                   {"json", to_json},
                                                                   {"latex", to_latex},
                                                                   {"curve", write_offsets},
                                                                   {"nurbs", write_offset_nurbs}});
  const OffsetQuery asked = query(options);
  const OffsetAnswer found = answer(options.curve.read_path_with_preimages(), asked);
  const bool is_curve = print == write_offsets || print == write_offset_nurbs;
  if (!options.output.empty()) {
    const std::string end = ending(options.output);
    write_output(options.output, end == "svg"   ? write_svg(drawing(found))
                                 : end == "dxf" ? write_dxf(nurbs(found))
                                 : is_curve     ? print(found)
                                                : write_offsets(found));
  }
  if (options.output.empty() || !is_curve) options.length.write("-", print(found));
}

}  // namespace

void add_offset(Program& program) {
  Command& command =
      program.add("offset", "exact offsets of a plane PH curve or spline, with their cusps");
  const auto options = std::make_shared<OffsetOptions>();
  options->curve.add_input_to(command);
  command.add_list("--distance", "D,...", options->distances,
                   "distances, > 0 to the right of travel, < 0 to the left: 1/2,-1/3");
  command.require("--distance");
  command.add_choice("--join", options->join, keys(offset_joins()),
                     "what joins the offsets at a corner on its outer side: round (default),\n"
                     "exact arcs; mitre, the tangents; open, nothing");
  command.add_flag("--trim", options->trim,
                   "cut away what is nearer to the path than |d|, by exact tests");
  command.add_flag(
      "--pocket", options->pocket,
      "of a closed path, trimmed, the offsets at the one distance, inwards, and at its\n"
      "multiples until nothing is left, one room after the other");
  add_digits(command, options->digits);
  command.add_option(
      "-o,--output", "FILE", options->output,
      "write the offset to this file, beside the report: a curve file, several paths\n"
      "a line each; as .dxf a spline for each; as .svg by cubics within |d|/1000000,\n"
      "proved");
  command.writes("a curve in JSON, DXF or SVG there", {"json", "jsonl", "dxf", "svg"});
  command.add_format(
      "--print", options->print, {"text", "json", "latex", "curve", "nurbs"},
      "text (default), json, latex, or the curve file instead of a report: curve, or\n"
      "nurbs, each path as one NURBS");
  options->length.add_to(command);
  command.set_notes(
      "The offset r + d n of a PH curve of degree n in a plane z = const is a rational curve of\n"
      "degree 2n - 1, with exact control points and weights, which all commands read. Its cusps\n"
      "are all found, and so are the places where it meets itself, but for those that are said to\n"
      "be undecided. With --trim what is nearer to the path than |d| is cut away, and the report\n"
      "has the branches that are left, in place of cusps and meetings.\n"
      "Behind a cusp at which the path turns back it is on the other side of travel.\n"
      "Examples:\n"
      "  phrame offset curve.json --distance 1/2\n"
      "  phrame offset spline.json --distance 1/2,-1/3 --join mitre --print json\n"
      "  phrame offset spline.json --distance -1/2 --trim\n"
      "  phrame offset outline.json --distance -1/8 --pocket -o pocket.dxf\n"
      "  phrame offset curve.json --distance -0.1 -o off.json && phrame info off.json");
  command.does(options, run);
}

}  // namespace phrame::cli
