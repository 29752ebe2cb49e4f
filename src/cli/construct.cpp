#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "phrame/answer/axis_construction.hpp"
#include "phrame/answer/construction.hpp"
#include "phrame/cli/command.hpp"
#include "phrame/io/read/any_path.hpp"
#include "phrame/io/read/frame_node.hpp"
#include "phrame/io/read/point_file.hpp"
#include "phrame/io/read/pose_file.hpp"
#include "phrame/io/write/answers.hpp"
#include "phrame/io/write/curve_file.hpp"
#include "phrame/io/write/names.hpp"

namespace phrame::inline v0::cli {
namespace {

/// The kind that makes no path.
constexpr const char* minkowski = "minkowski";

struct ConstructOptions {
  std::string data;
  FileReading reading;
  std::string kind = "quintic";
  std::string select = "auto";
  std::vector<std::string> angles;
  long solution = 1;
  std::vector<std::string> lengths;
  std::string tolerance;
  bool is_closed = false;
  bool exact_points = false;
  std::string tangent_axis = "x";
  std::string quaternion;
  bool is_inverse = false;
  bool is_smooth = false;
  std::vector<std::string> turns;
  std::string print = "text";
  TextLength length;
  std::string output;
};

QuinticChoice chosen_quintic(const ConstructOptions& options) {
  if (options.angles.empty())
    return choose<QuinticSelection>("--select", options.select, quintic_selections());
  std::vector<Angle> angles;
  for (const std::string& text : split(options.angles))
    angles.push_back(parse_angle_option("--angles", text));
  const auto value = [&](std::size_t k) { return round_to_double(to_real(angles[k])); };
  if (angles.size() == 2) return FreeAngles{angles[0], angles[1]};
  if (angles.size() == 3) return SolutionAngles{value(0), value(1), value(2)};
  throw InputError("--angles", "two angles are wanted, Delta and phi, or three, phi0, phi1, phi2");
}

ConstructQuery query(const ConstructOptions& options) {
  ConstructQuery query;
  std::vector<std::pair<std::string, CurveKind>> kinds;
  for (const NamedKind& named : curve_kinds()) kinds.emplace_back(named.name, named.kind);
  kinds.emplace_back(minkowski, CurveKind());  // which has its own query
  query.kind = choose("--kind", options.kind, kinds);
  query.choice = chosen_quintic(options);
  query.solution = options.solution;
  for (const std::string& text : split(options.lengths)) {
    query.lengths.push_back(parse_option("--lengths", text));
    if (query.lengths.back() <= 0)
      throw InputError("--lengths", abbreviated(text) + " is not positive");
  }
  if (!options.tolerance.empty()) {
    query.tolerance = parse_option("--tolerance", options.tolerance);
    if (query.tolerance <= 0 || query.tolerance >= 1)
      throw InputError("--tolerance", abbreviated(options.tolerance) + " is not between 0 and 1");
  }
  query.is_closed = options.is_closed;
  if (options.exact_points) query.points = PointRule::exact;
  query.is_measured = options.print != "curve";
  return query;
}

/// "--kind cubic" for each such kind.
std::vector<std::string> kinds_where(const std::function<bool(const NamedKind&)>& is_such) {
  std::vector<std::string> list;
  for (const NamedKind& named : curve_kinds())
    if (is_such(named)) list.push_back(fmt::format("--kind {}", named.name));
  return list;
}

std::string curve_of(const ConstructionAnswer& answer) { return write_path(answer.path); }

/// What is asked of poses.
const std::vector<std::string>& pose_options() {
  static const std::vector<std::string> names{"--tangent-axis", "--quaternion", "--inverse",
                                              "--smooth-twist", "--turns"};
  return names;
}

PoseReading pose_reading(const Command& command, const ConstructOptions& options) {
  PoseReading reading{{}, {}, options.is_inverse, {}, options.is_smooth};
  if (command.is_given("--tangent-axis"))
    reading.tangent = choose("--tangent-axis", options.tangent_axis, tangent_axes());
  using Quaternion = FrameReading::Quaternion;
  if (!options.quaternion.empty())
    reading.quaternion =
        choose<Quaternion>("--quaternion", options.quaternion,
                           {{"wxyz", Quaternion::wxyz}, {"xyzw", Quaternion::xyzw}});
  for (const std::string& text : split(options.turns)) {
    const Rational turns = parse_option("--turns", text);
    if (denominator(turns) != 1 || abs(turns) > 1'000'000)
      throw InputError("--turns", abbreviated(text) + " is no whole number, at most a million");
    reading.turns.push_back(static_cast<long>(numerator(turns)));
  }
  return reading;
}

GivenPoints given_points(const Command& command, const ConstructOptions& options,
                         const std::string& bytes) {
  const bool are_poses = command.is_given("--tangent-axis") || is_pose_file(bytes);
  if (are_poses) {
    options.reading.refuse_picking("a list of poses");
    return read_poses(bytes, pose_reading(command, options), options.reading);
  }
  command.refuse(pose_options(), "is for poses: --tangent-axis says that a table has them");
  FileReading reading = options.reading;
  reading.has_radii = options.kind == minkowski;
  return read_waypoints(bytes, reading);
}

/// The curves with radii through points x, y, r.
void run_axis(const GivenPoints& given, const ConstructOptions& options,
              const Rational& tolerance) {
  const auto print = choose<std::string (*)(const AxisConstructionAnswer&)>(
      "--print", options.print,
      {{"text", to_text}, {"json", to_json}, {"latex", to_latex}, {"curve", write_axis}});
  const AxisConstructionAnswer found = at_place(name_of_file(options.data), ":", [&] {
    return answer(given, AxisConstructionQuery{tolerance});
  });
  if (!options.output.empty()) write_output(options.output, write_axis(found));
  if (options.output.empty() || print != write_axis) options.length.write("-", print(found));
}

/// What is wrong is in the file, or in --turns.
ConstructionAnswer made_of(const GivenPoints& given, const ConstructQuery& asked,
                           const ConstructOptions& options) {
  try {
    return answer(given, asked);
  } catch (const InputError& error) {
    if (error.place() == "/turns" && !options.turns.empty())
      throw InputError("--turns", error.reason());
    throw InputError(
        name_of_file(options.data) + (error.place().empty() ? "" : ":") + error.place(),
        error.reason());
  }
}

/// Where another axis is so much nearer to the chords that it may have been meant.
void note_on_axis(const ConstructionAnswer& answer, const std::string& file) {
  if (!answer.poses || !answer.poses->better) return;
  constexpr double degree = 0.017453292519943295;
  note(
      fmt::format("{}: the axis {} of the poses is {:.0f} degrees off the chords in the mean, the "
                  "axis {} {:.0f}: --tangent-axis{}{} takes that",
                  file, name_of(answer.path.frame->axis), answer.poses->angle / degree,
                  name_of(*answer.poses->better), answer.poses->better_angle / degree,
                  answer.poses->better->is_reversed ? "=" : " ", name_of(*answer.poses->better)));
}

void run(const Command& command, const ConstructOptions& options) {
  const auto print = choose<std::string (*)(const ConstructionAnswer&)>(
      "--print", options.print,
      {{"text", to_text}, {"json", to_json}, {"latex", to_latex}, {"curve", curve_of}});
  const ConstructQuery asked = query(options);
  const std::string bytes = read_file(options.data);
  const std::string file = name_of_file(options.data);
  GivenPoints given = at_place(file, ":", [&] { return given_points(command, options, bytes); });
  if (asked.is_closed && !given.parameter_column.empty() &&
      given.points.front() != given.points.back())
    leave_parameters_out(given, "without that of the end of the closed curve");
  for (const std::string& text : notes_on_columns(given)) note(fmt::format("{}: {}", file, text));
  if (options.kind == minkowski) return run_axis(given, options, asked.tolerance);
  const ConstructionAnswer found = made_of(given, asked, options);
  note_on_axis(found, file);
  if (!options.output.empty()) write_output(options.output, curve_of(found));
  if (options.output.empty() || print != curve_of) options.length.write("-", print(found));
}

}  // namespace

void add_construct(Program& program) {
  Command& command =
      program.add("construct", "an exact PH curve or spline through points, as near as asked");
  const auto options = std::make_shared<ConstructOptions>();
  command.add_argument("DATA", options->data,
                       "points: JSON, a table of text or of NumPy, or lines of a file that other\n"
                       "commands read; \"-\" for standard input");
  add_skip_invalid(command, options->reading);
  command.add_option("--pick", "NAME", options->reading.pick,
                     "of a file with several curves, the one of this name");
  std::vector<std::string> kinds;
  for (const NamedKind& named : curve_kinds()) kinds.emplace_back(named.name);
  kinds.emplace_back(minkowski);
  command.add_choice("--kind", options->kind, kinds,
                     "what to make: quintic (default); planar: in the plane z = 0; cubic: with\n"
                     "continuous tangents; helical: with a constant angle to an axis; rrmf: with\n"
                     "a rational rotation-minimizing frame; rmf: with one that is the\n"
                     "Euler-Rodrigues frame; c2: through points, with continuous second\n"
                     "derivatives; c2-hermite: with these given; length: of given lengths, with\n"
                     "continuous tangents; minkowski: curves with radii through points x, y, r,\n"
                     "whose envelopes are rational");
  command.add_choice("--select", options->select, keys(quintic_selections()),
                     "which of the quintics: auto (default), minimal, bv, cc, shortest,\n"
                     "longest or energy");
  command.add_list("--angles", "A,...", options->angles,
                   "which of the quintics: the angles Delta,phi or phi0,phi1,phi2");
  const long most = std::ranges::max(curve_kinds(), {}, &NamedKind::solutions).solutions;
  command.add_number("--solution", options->solution, {1, most},
                     "which of the curves there are, 1 being the best (default 1)");
  command.add_list("--lengths", "L,...", options->lengths,
                   "the length of each segment, or of the whole, shared in proportion to chords");
  command.only_with({"--lengths"}, {"--kind length"});
  command.only_with({"--select", "--angles"}, {"--kind quintic"});
  command.not_with({"--select"}, {"--angles"});
  command.only_with({"--solution"},
                    kinds_where([](const NamedKind& named) { return named.solutions > 1; }));
  command.add_option("--tolerance", "X", options->tolerance,
                     "how far the curve may be from the points, beside their extent\n"
                     "(default 1e-15)");
  command.add_flag("--closed", options->is_closed, "the curve ends where it starts");
  command.add_flag("--exact-points", options->exact_points,
                   "meet the points exactly, by several segments between any two of them, or\n"
                   "by a multiplier");
  command.add_choice("--tangent-axis", options->tangent_axis, keys(tangent_axes()),
                     "the orientations of the table are met, too, of poses/1 those of the file:\n"
                     "this axis of them is the tangent; =-x, =-y or =-z for the opposite");
  command.add_choice("--quaternion", options->quaternion, {"wxyz", "xyzw"},
                     "of poses: the order of the columns (default: as they are named, else xyzw)");
  command.add_flag("--inverse", options->is_inverse, "of poses: they turn the world to the body");
  command.add_flag("--smooth-twist", options->is_smooth,
                   "of poses: the frame turns about the tangent by a C2 cubic spline of the arc\n"
                   "length, of the least integral of its squared rate's derivative; else evenly\n"
                   "from pose to pose, which is the least twist");
  command.add_list("--turns", "K,...", options->turns,
                   "of poses: so many revolutions more from each to the next");
  command.not_with({"--closed"}, kinds_where(&NamedKind::is_open));
  command.not_with({"--closed", "--exact-points"}, {"--kind minkowski"});
  command.not_with({"--exact-points"}, {"--kind length"});
  command.add_option("-o,--output", "FILE", options->output,
                     "write the curve to this file, beside the report");
  command.writes("a curve in JSON there", {"json"});
  command.add_format("--print", options->print, {"text", "json", "latex", "curve"},
                     "text (default), json, latex, or curve: the curve file instead of a report");
  options->length.add_to(command);
  command.set_notes(
      "DATA: {\"phrame\": \"points/1\", \"points\": [[0, 0, 0], [1, 1, 1]]}, with derivatives,\n"
      "tangents and parameters if known; or lines of x, y, z. Derivatives not given are those of\n"
      "the C2 cubic spline. Joints are exact: position and derivative are equal as fractions,\n"
      "with --kind cubic, rrmf and length position and tangent, with c2 and c2-hermite the second\n"
      "derivative as well. The data are met within the tolerance, and the report says the proved\n"
      "bound.\n"
      "Examples:\n"
      "  phrame construct points.csv -o spline.json\n"
      "  phrame construct hermite.json --select energy --tolerance 1e-40 -o curve.json\n"
      "  phrame construct knot.csv --kind rmf --closed --print json\n"
      "  phrame construct poses.tum --tangent-axis x -o path.json\n"
      "  phrame construct points.csv --print curve | phrame frames - --samples 101");
  command.does(options, run);
}

}  // namespace phrame::cli
