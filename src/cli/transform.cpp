#include "phrame/answer/transform.hpp"

#include <algorithm>
#include <functional>

#include "phrame/algebra/as_written.hpp"
#include "phrame/cli/command.hpp"
#include "phrame/io/write/curve_file.hpp"
#include "phrame/io/write/names.hpp"
#include "phrame/ph/curve/vector.hpp"

namespace phrame::inline v0::cli {
namespace {

struct TransformOptions {
  CurveOptions curve;
  bool is_whole_line = false;
  std::vector<std::string> split;
  std::optional<std::string> part;
  std::string by = "t";
  bool is_reversed = false;
  std::optional<std::string> scale;
  std::optional<std::string> rotate;
  std::optional<std::string> matrix;
  std::optional<std::string> move;
};

/// "z,90deg" or "1,2,2,pi/3".
AffineMap rotation(const std::string& text) {
  std::vector<std::string> parts = split({text});
  const std::string angle = parts.back();
  parts.pop_back();
  Vector<Rational> axis;
  if (parts.size() == 1 && (parts[0] == "x" || parts[0] == "y" || parts[0] == "z"))
    axis[static_cast<std::size_t>(parts[0][0] - 'x')] = 1;
  else if (parts.size() == 3)
    for (std::size_t k = 0; k < 3; ++k) axis[k] = parse_option("--rotate", parts[k]);
  else
    throw InputError("--rotate", "\"" + abbreviated(text) +
                                     "\" is no axis with an angle, \"z,90deg\" or \"1,2,2,pi/3\"");
  return {
      rotation_columns(at_option(
          "--rotate", [&] { return rotation_about(axis, parse_angle_option("--rotate", angle)); })),
      {}};
}

AffineMap asked_map(const TransformOptions& options) {
  AffineMap map;
  if (options.scale) {
    const Rational factor = parse_option("--scale", *options.scale);
    if (factor == 0) throw InputError("--scale", "0 leaves a point");
    for (std::size_t k = 0; k < 3; ++k) map.columns[k][k] = factor;
  }
  if (options.rotate) map = composed(map, rotation(*options.rotate));
  if (options.matrix)
    map = composed(map, at_option("--matrix", [&] {
                     return affine_map(parse_list_option("--matrix", {*options.matrix}));
                   }));
  if (options.move) map.shift = map.shift + parse_vector_option("--move", *options.move);
  return map;
}

TransformQuery query(const TransformOptions& options) {
  TransformQuery query;
  query.is_whole_line = options.is_whole_line;
  query.by = choose("--by", options.by, parameter_kinds());
  query.split = parse_list_option("--split", options.split);
  if (const auto back = std::ranges::adjacent_find(query.split, std::greater_equal());
      back != query.split.end())
    throw InputError("--split", as_written(*(back + 1)) + " is not behind the one before it");
  if (options.part) {
    const auto ends = parse_list_option("--part", {*options.part});
    if (ends.size() != 2)
      throw InputError("--part", "\"" + abbreviated(*options.part) + "\" is not FROM,TO");
    query.part = {ends[0], ends[1]};
  }
  query.is_reversed = options.is_reversed;
  query.map = asked_map(options);
  return query;
}

void run(const TransformOptions& options) {
  const TransformQuery asked = query(options);
  const NamedPath named = options.curve.read_any_path();
  if (!asked.split.empty() || asked.part) require_parameter(named.path, asked.by);
  const std::vector<NamedPath> parts = answer(named, asked);
  for (const std::string& text : parts.front().notes)
    note(name_of_file(options.curve.path) + ": " + text);
  write_curves(options.curve.output, write_paths(parts));
}

}  // namespace

void add_transform(Program& program) {
  Command& command =
      program.add("transform", "parts of a curve, or the curve moved, turned, stretched, exactly");
  const auto options = std::make_shared<TransformOptions>();
  options->curve.is_for_frames = false;
  options->curve.add_to(command);
  command.writes("a curve in JSON", {"json", "jsonl"});
  command.add_flag(
      "--whole-line", options->is_whole_line,
      "all of a rational curve, closed through t = infinity: from -1 to 1 and on to -1, or\n"
      "from -c to c, where it has a cusp at 1 or -1");
  command.add_option("--part", "FROM,TO", options->part,
                     "from there to there; backwards where FROM is behind TO");
  command.add_list("--split", "T,...", options->split,
                   "the parts from one of these places to the next, a line each");
  add_by(command, options->by, "what --part and --split are values of: t (default)");
  command.add_flag("--reverse", options->is_reversed, "from its end to its start");
  command.add_option("--scale", "C", options->scale, "C times as large, about the origin");
  command.add_option("--rotate", "AXIS,ANGLE", options->rotate,
                     "turned about an axis through the origin: z,90deg or 1,2,2,pi/3");
  command.add_option("--matrix", "M,...", options->matrix,
                     "under a matrix, by rows: 9 numbers, 12 with a column that is added, or 16");
  command.add_option("--move", "X,Y,Z", options->move, "moved by this");
  command.not_with({"--part"}, {"--split"});
  command.not_with({"--whole-line"}, {"--part", "--split"});
  command.only_with({"--by"}, {"--part", "--split"});
  command.set_notes(
      "It is done in this order: --whole-line, --part or --split, --reverse, --scale, --rotate,\n"
      "--matrix, --move; the command may read what it wrote. Every kind of segment is exact, and\n"
      "what is Pythagorean-hodograph stays so under rotations, scalings and reflections. Without\n"
      "options it writes a curve of any format as phrame has it.\n"
      "Examples:\n"
      "  phrame transform curve.json --part 1/4,3/4 -o middle.json\n"
      "  phrame transform spline.json --split 1/3,2/3 --by fraction -o thirds.jsonl\n"
      "  phrame transform arc.json --whole-line -o circle.json\n"
      "  phrame transform drawing.svg --scale 1/100 --matrix 1,0,0,0,-1,0,0,0,1 -o upright.json\n"
      "  phrame transform curve.json --rotate z,90deg --move 1,0,0");
  command.does(options, run);
}

}  // namespace phrame::cli
