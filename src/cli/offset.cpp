#include "phrame/answer/offset_check.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/cli/boundary_printer.hpp"
#include "phrame/cli/exchange.hpp"
#include "phrame/io/write/names.hpp"
#include "phrame/io/write/text.hpp"
#include "phrame/ph/construct/near_plane_path.hpp"

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
  std::optional<std::string> gauge;
  std::optional<std::string> given;
  std::optional<std::string> tolerance;
};

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
  if (query.distances.empty()) throw InputError("--distance", "a distance is wanted");
  if (query.pocket && query.distances.size() != 1)
    throw InputError("--pocket", "one distance is wanted, of which the others are multiples");
  return query;
}

/// As it is, whatever --near says.
NamedPath read_as_it_is(CurveOptions options) {
  options.near.reset();
  options.is_for_frames = false;
  return options.read_any_path();
}

bool is_in_plane(const Segment& segment) {
  const RationalCurve* curve = rational_curve(segment);
  return curve != nullptr && curve->direction()[2].is_zero();
}

/// A PH path within --near. Control points may leave gaps, which one of the same degrees closes.
NamedPath read_near(const CurveOptions& options) {
  const std::string file = name_of_file(options.path);
  std::optional<NamedPath> named;
  try {
    named = read_as_it_is(options);
  } catch (const InputError&) {
    NamedPath closed = options.read_path_with_preimages();
    require_plane(closed.path, file);
    return closed;
  }
  require_plane(named->path, file);
  NamedPhPath near =
      at_option(file, [&] { return near_ph_path(*named, options.epsilon().value()); });
  if (near.near)
    note_at_end(fmt::format("{}: in its place a PH spline of {}, at most {} from it", file,
                            counted(near.path.segments().size(), "segment"),
                            upper_bound_text(near.near->distance)));
  return near;
}

/// A PH path, or, to offset all of it, a curve in a plane of which the offset may be rational for
/// both sides together, or over another field.
NamedPath read_curve(CurveOptions options, bool is_whole) {
  if (Exchange::current() == nullptr) options.bytes = read_file(options.path);
  if (options.near) return read_near(options);
  const NamedPath named = read_as_it_is(options);
  require_plane(named.path, name_of_file(options.path));
  if (auto ph = with_preimages(named)) return *std::move(ph);
  const auto& segments = named.path.segments();
  if (!std::ranges::all_of(segments, is_in_plane))
    return options.read_path_with_preimages();  // which says why it is not PH
  if (const auto why = why_no_offset(named.path, is_whole))
    throw InputError(name_of_file(options.path),
                     *why + "; with --near EPS that of a PH path at most EPS away is taken");
  return options.read_any_path();  // which says what PH curve is near
}

Gauge read_gauge(const std::string& file) {
  CurveOptions options;
  options.path = file;
  options.is_for_frames = false;
  const NamedPath named = options.read_any_path();
  return at_option(name_of_file(file), [&] { return Gauge(named.path); });
}

/// A path of rational curves, each in a plane z = const.
NamedPath read_plane_path(CurveOptions options) {
  options.is_for_frames = false;
  NamedPath named = options.read_any_path();
  if (!std::ranges::all_of(named.path.segments(), is_in_plane))
    throw InputError(name_of_file(options.path),
                     "under a gauge the path is of rational curves in a plane z = const");
  return named;
}

/// A list of points or lines is a polyline; all else is a curve, or several, a line each.
void add_foreign(ForeignOffset& given, const std::string& file, const OffsetOptions& options) {
  const FileReading& reading = options.curve.reading;
  const auto* node = Exchange::content<JsonNode>(file);
  if (node != nullptr) {
    given.paths.push_back(read_any_path(*node).path);
    return;
  }
  const std::string text = read_file(file);
  try {
    given.polylines.push_back(read_waypoints(text, reading).points);
    return;
  } catch (const Error&) {  // what it is not is told by whoever reads curves
  }
  at_place(name_of_file(file), ":", [&] {
    std::size_t first = 0;
    for (std::size_t end = text.find("\n{"); end != std::string::npos;
         end = text.find("\n{", first)) {
      given.paths.push_back(read_any_path(std::string_view(text).substr(first, end - first)).path);
      first = end + 1;
    }
    given.paths.push_back(read_any_path(std::string_view(text).substr(first), {}, reading).path);
    return 0;
  });
}

void run_check(const OffsetOptions& options) {
  const auto print = choose<std::string (*)(const OffsetCheckAnswer&)>(
      "--print", options.print, {{"text", to_text}, {"json", to_json}});
  const OffsetQuery asked = query(options);
  if (asked.distances.size() != 1)
    throw InputError("--check", "one distance is wanted, not a list of them");
  OffsetCheckQuery check{asked.distances.front(),
                         asked.join,
                         asked.trim,
                         {},
                         parse_positive_option("--tol", options.tolerance.value_or("1e-6"))};
  add_foreign(check.given, *options.given, options);
  CurveOptions curve = options.curve;
  curve.reading.skips_where_possible = true;  // --skip-invalid is for what is checked, too
  const OffsetCheckAnswer found = answer(read_curve(curve, false), check);
  options.length.write(options.output.empty() ? "-" : options.output, print(found));
  if (!found.passes) throw AnswerNo{};
}

void run(const OffsetOptions& options) {
  if (options.given) return run_check(options);
  const BoundaryPrinter<OffsetAnswer> printer(options.print, write_offsets);
  const std::optional<Rational> tolerance = gcode_tolerance(options.tolerance, options.output);
  OffsetQuery asked = query(options);
  if (options.gauge) asked.gauge = read_gauge(*options.gauge);
  const OffsetAnswer found =
      answer(asked.gauge ? read_plane_path(options.curve)
                         : read_curve(options.curve, !asked.trim && !asked.pocket),
             asked);
  printer.write(found, options.output, options.length, tolerance);
  const auto is_none = [](const OffsetAnswer::Part& part) { return part.paths.empty(); };
  if (!found.without.empty() || std::ranges::any_of(found.offsets, is_none)) throw AnswerNo{};
}

}  // namespace

void add_offset(Program& program) {
  Command& command = program.add("offset", "exact offsets of plane paths, with their cusps");
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
  command.add_option("--gauge", "FILE", options->gauge,
                     "offsets r + d U(phi), with U' along r', of any rational path: a file with a\n"
                     "closed convex rational curve U that is symmetric about (0, 0)");
  command.add_option(
      "--check", "FILE", options->given,
      "how far that is from the exact offset, to both sides, proved: a table of points,\n"
      "a polyline, or curves, a line each");
  command.add_option("--tol", "BOUND", options->tolerance,
                     "the distance that is allowed, with --check 1e-6 by default, of G-code\n"
                     "|d|/1000");
  add_digits(command, options->digits);
  command.add_option(
      "-o,--output", "FILE", options->output,
      "write the offset to this file, beside the report: a curve file, several paths\n"
      "a line each; as .dxf a spline for each; as .svg by cubics within |d|/1000000,\n"
      "or 1/1000000000 of their size, proved; as .nc G-code, lines within --tol, proved;\n"
      "as .html a page for a browser: path, offsets, marks at cusps, meetings and cuts,\n"
      "lengths, the report");
  command.writes(boundary_formats, boundary_endings());
  command.add_format(
      "--print", options->print, {"text", "json", "latex", "curve", "nurbs"},
      "text (default), json, latex, or the curve file instead of a report: curve, or\n"
      "nurbs, each path as one NURBS");
  options->length.add_to(command);
  command.only_with({"--tol"}, {"--check", "--output"});
  command.not_with({"--pocket", "--digits"}, {"--check"});
  command.not_with({"--check"}, {"--gauge"});
  command.set_notes(
      "The offset r + d n of a PH curve of degree n in a plane z = const is a rational curve of\n"
      "degree 2n - 1, with exact control points and weights, which all commands read. Its cusps\n"
      "are all found, and so are the places where it meets itself, but for those that are said to\n"
      "be undecided. Of a curve that is not PH it is one curve for both sides, by a parameter m,\n"
      "where x'^2 + y'^2 has two simple roots and the conic of these a rational point. With --trim "
      "what is nearer to the path than |d| is cut away, and the report\n"
      "has the branches that are left, in place of cusps and meetings.\n"
      "With --near EPS other paths, as of drawings, are offset as well: a PH path takes their "
      "place\n"
      "that is at most EPS away, proved: lines and quintics, as many as are needed.\n"
      "Behind a cusp at which the path turns back it is on the other side of travel.\n"
      "With --gauge the unit circle is a curve U, whole for phi from -infinity to infinity: the\n"
      "offset is rational, and exact, where r' x U' has a factor of degree 1 in phi; segments "
      "that\n"
      "have none are left out, with the exit status 1, and told what they would need.\n"
      "With --check the exit status is 1 where what is given is not proved to be within --tol.\n"
      "Examples:\n"
      "  phrame offset curve.json --distance 1/2\n"
      "  phrame offset spline.json --distance 1/2,-1/3 --join mitre --print json\n"
      "  phrame offset spline.json --distance -1/2 --trim\n"
      "  phrame offset outline.json --distance -1/2 --trim --check theirs.csv --tol 1e-3\n"
      "  phrame offset outline.json --distance -1/8 --pocket -o pocket.dxf\n"
      "  phrame offset outline.json --distance -1/8 --pocket -o pocket.nc --tol 0.01\n"
      "  phrame offset drawing.svg --distance 2 --near 1e-4 --trim -o around.svg\n"
      "  phrame offset curve.json --distance 1/2 --gauge ellipse.json\n"
      "  phrame offset curve.json --distance -0.1 -o off.json && phrame info off.json");
  command.does(options, run);
}

}  // namespace phrame::cli
