#include <fmt/format.h>

#include <algorithm>

#include "phrame/algebra/rounding.hpp"
#include "phrame/answer/camera_path.hpp"
#include "phrame/answer/table_row.hpp"
#include "phrame/cli/feed_options.hpp"
#include "phrame/cli/row_stream.hpp"
#include "phrame/cli/twist_options.hpp"
#include "phrame/io/write/camera.hpp"
#include "phrame/io/write/frame_table.hpp"
#include "phrame/io/write/names.hpp"
#include "phrame/ph/along/path_length.hpp"
#include "phrame/ph/along/travel_time.hpp"

namespace phrame::inline v0::cli {
namespace {

struct FramesOptions {
  CurveOptions curve;
  Parameters parameters;
  StartOptions start;
  RollOption roll;
  TwistOptions twist;
  std::vector<std::string> frames{"rmf"};
  std::vector<std::string> scalars;
  std::string side = "right";
  long digits = 0;  ///< 0 for doubles
  std::string format = "csv";
  UpOption up;
  bool skips_undefined = false;
  std::optional<std::string> duration;  ///< of a camera path, in seconds
  std::string fps = "24";               ///< frames a second, in Blender
  FeedOptions feed;                     ///< the motion, where rows are at times of one
};

const std::vector<std::string>& camera_formats() {
  static const std::vector<std::string> formats{"--format glb", "--format gltf",
                                                "--format blender"};
  return formats;
}

/// Which frames a row at a corner has: those of the segment before it, behind it, or both rows.
enum class Side { left, right, both };

/// The rows of a table.
struct AskedRows {
  RowPlaces places;
  /// The values of the parameter that they were asked for by; empty for t and the arc length, which
  /// have a column anyway.
  std::vector<Real> values = {};
};

/// The rows with those at corners replaced, or doubled, as `side` asks for.
AskedRows with_sides(const AskedRows& of, const Path& path, Side side) {
  if (side == Side::right) return of;
  if (path.corners().empty()) throw InputError("--side", "the path has no corner at a joint");
  std::vector<Place> places;
  std::vector<Rational> numbers;
  std::vector<Real> values;
  for (std::size_t k = 0; k < of.places.size(); ++k) {
    const Place at = of.places.place(k);
    const bool is_corner = at.t.exact() == Rational(0) && path.has_corner(at.segment);
    if (is_corner) places.emplace_back(at.segment - 1, Rational(1));
    if (!is_corner || side == Side::both) places.push_back(at);
    numbers.resize(places.size(), of.places.numbers()[k]);
    if (!of.values.empty()) values.resize(places.size(), of.values[k]);
  }
  return {RowPlaces(std::move(places), std::move(numbers), of.places.arc_length(0).has_value()),
          std::move(values)};
}

/// x, or a fraction within 2^−192 of its size, which rounds to the same double unless x is as near
/// to a tie.
Rational approximated(const Real& x) { return x.exact() ? *x.exact() : x.enclose(192).midpoint(); }

const Names<TabulatedFrame>& frame_names() {
  static const Names<TabulatedFrame> names{{"rmf", TabulatedFrame::rmf},
                                           {"erf", TabulatedFrame::euler_rodrigues},
                                           {"frenet", TabulatedFrame::frenet},
                                           {"up", TabulatedFrame::up},
                                           {"mtf", TabulatedFrame::mtf},
                                           {"mtf-exact", TabulatedFrame::exact_mtf},
                                           {"frenet-signed", TabulatedFrame::signed_frenet}};
  return names;
}

/// The names of columns with the scalars they are; those without scalars are columns of frames.
const Names<std::vector<TabulatedScalar>>& column_names() {
  using enum TabulatedScalar;
  static const Names<std::vector<TabulatedScalar>> names{
      {"s", {arc_length}},
      {"curvature", {curvature}},
      {"torsion", {torsion}},
      {"frenet_rate", {frenet_rate}},
      {"bishop", {bend_f2, bend_f3}},
      {"omega", {omega_x, omega_y, omega_z}},
      {"signed_curvature", {signed_curvature}},
      {"twist_rate", {twist_rate}},
      {"twist_omega", {twist_omega_x, twist_omega_y, twist_omega_z}},
      {"twist_alpha", {twist_alpha_x, twist_alpha_y, twist_alpha_z}},
      {"quaternion", {}},
      {"matrix", {}}};
  return names;
}

TableColumns columns(const FramesOptions& options) {
  TableColumns columns;
  for (const std::string& name : split(options.frames))
    columns.frames.push_back(choose("--frame", name, frame_names()));
  for (const std::string& name : split(options.scalars)) {
    for (const TabulatedScalar scalar : choose("--columns", name, column_names()))
      columns.scalars.push_back(scalar);
    columns.have_quaternions = columns.have_quaternions || name == "quaternion";
    columns.have_matrices = columns.have_matrices || name == "matrix";
  }
  return columns;
}

bool has_twist_frames(const TableColumns& columns) {
  if (std::ranges::any_of(
          columns.scalars,
          [](TabulatedScalar scalar) { return scalar >= TabulatedScalar::twist_rate; }) &&
      !has_frame(columns, TabulatedFrame::exact_mtf))
    throw InputError("--columns", "\"twist_rate\" and the like are of --frame mtf-exact");
  return has_frame(columns, TabulatedFrame::mtf) || has_frame(columns, TabulatedFrame::exact_mtf);
}

/// Finds the frames of minimal twist that there are columns for: through the orientations that come
/// with the path, unless other ends are asked for. The rational one is the Euler–Rodrigues frame,
/// turned; so where it is asked for the angles at the ends are those to that frame.
void add_twist_frames(TableColumns& columns, const FramesOptions& asked, const NamedPath& named,
                      const PathAngle& angle) {
  const TwistOptions& options = asked.twist;
  const bool is_rational = has_frame(columns, TabulatedFrame::mtf);
  const PathAngle measured = is_rational ? PathAngle(angle.path()) : angle;
  if (named.frame && !options.has_ends()) {
    columns.exact_mtf.emplace(measured, *named.frame);
    columns.body = named.frame->axis;
  } else {
    const auto [from, to] = options.ends(angle.path());
    columns.exact_mtf = minimal_twist(measured, from, to, options.turns);
  }
  if (!is_rational) return;
  constexpr long digits = 17;
  columns.mtf = twist_frames(
      *columns.exact_mtf, options.rotation(digits),
      options.subdivision(
          named, asked.parameters.are_times() ? ParameterKind::t : asked.parameters.kind()));
}

/// What make() makes of the table.
template <class Make>
auto tabulated(const TableColumns& columns, Make make) {
  try {
    return make();
  } catch (const DomainError& error) {
    if (columns.may_be_empty) throw;
    throw DomainError(std::string(error.what()) + " (--skip-undefined leaves such cells empty)");
  }
}

void require_frames(const TableColumns& columns, const PathAngle& angle) {
  const auto& segments = angle.path().segments();
  if (has_frame(columns, TabulatedFrame::euler_rodrigues) &&
      std::none_of(segments.begin(), segments.end(), ph_curve))
    throw InputError("--frame", "\"erf\" " + needs_ph(angle.path()));
  if (has_frame(columns, TabulatedFrame::mtf) && !angle.path().is_ph())
    throw InputError("--frame", "\"mtf\" " + needs_ph(angle.path()));
}

/// The rows at the times of a motion.
AskedRows rows_at_times(const NamedPath& named, const FramesOptions& options) {
  if (!options.feed.feed) throw InputError("--by", "\"time\" needs --feed");
  if (options.twist.subdivide) throw InputError("--subdivide", "does not apply with --by time");
  TravelTime motion(named.path, options.feed.feedrate());
  std::vector<Rational> times = options.parameters.given();
  std::vector<Place> at;
  for (const Rational& time : times) at.push_back(motion.at_time(time).at);
  std::vector<Real> values(times.begin(), times.end());
  const long samples = options.parameters.samples;
  for (long k = 0; k < samples; ++k) {
    const bool is_end = k + 1 == samples;
    values.push_back(Rational(k, samples - 1) * motion.total());
    times.push_back(approximated(values.back()));
    at.push_back(is_end ? motion.end().at : motion.at_time(times.back()).at);
  }
  return {RowPlaces(std::move(at), std::move(times)), std::move(values)};
}

/// The rows in the parameter that is asked for. A frame of minimal twist ends with the curve, so
/// that there are no rows outside of it where `ends`.
AskedRows asked_rows(const NamedPath& named, bool ends, const FramesOptions& options) {
  if (options.parameters.are_times()) return rows_at_times(named, options);
  const Path& path = named.path;
  const Parametrization by = options.parameters.on(named);
  const std::vector<Rational> asked = options.parameters.given();
  const long samples = options.parameters.samples;
  std::vector<Rational> numbers;
  if (by.kind() == ParameterKind::t || by.kind() == ParameterKind::arc_length) {
    numbers = asked;
    numbers.reserve(asked.size() + static_cast<std::size_t>(samples));
    const Rational last = samples > 0 ? *by.sample_values(2).back().exact() : 0;
    const Rational step = samples > 1 ? last / (samples - 1) : 0;
    for (long k = 0; k < samples; ++k) numbers.push_back(k * step);
  }
  if (by.kind() == ParameterKind::arc_length) return {RowPlaces(std::move(numbers), by.length())};
  if (by.kind() == ParameterKind::t) {
    RowPlaces places(std::move(numbers), [path, ends](const Rational& t) {
      return Place(ends ? locate_inside(path.segments().size(), t) : locate(path, t));
    });
    for (std::size_t k = 0; k < asked.size(); ++k)
      if (const Rational& t = places.numbers()[k]; t < 0 || t > path.end())
        places.place(k);  // which throws where there is none
    return {std::move(places)};
  }
  std::vector<Place> at;
  std::vector<Real> values;
  for (const ParameterPoint& point : by.points(asked, samples)) {
    at.push_back(point.at);
    values.push_back(point.value);
    numbers.push_back(approximated(point.value));
  }
  return {RowPlaces(std::move(at), std::move(numbers)), std::move(values)};
}

/// What a table of a path is written with.
struct TableUse {
  const NamedPath& named;
  FrameRows& rows;
  const AskedRows& asked;
  std::string column;  ///< the name of the one with the parameter that rows were asked for by
};

/// Reads the path and gives its table to `use`.
template <class Use>
void tabulate(const FramesOptions& options, TableColumns& chosen, const Use& use) {
  const bool are_times = options.parameters.are_times();
  const ParameterKind by = are_times ? ParameterKind::t : options.parameters.kind();
  chosen.start = options.start.start();
  chosen.roll = options.roll.chosen(options.curve);
  if (options.roll.is_given() && std::ranges::any_of(chosen.scalars, [](TabulatedScalar scalar) {
        return scalar == TabulatedScalar::bend_f2 || scalar == TabulatedScalar::bend_f3 ||
               scalar >= TabulatedScalar::twist_rate;
      }))
    throw InputError("--roll", "is not in the columns bishop and twist_...");
  if (options.parameters.given().empty() && options.parameters.samples == 0)
    throw InputError("frames", "--samples N or --at t,… is needed");
  CurveOptions curve = options.curve;
  curve.reading.other_columns = {options.roll.column_name()};
  const NamedPath named = curve.read_any_path();
  const Path& path = named.path;
  options.roll.check(chosen.roll, path.segments().size());
  const bool is_to_up = has_frame(chosen, TabulatedFrame::up) || options.start.is_up();
  if (options.up.vector && !is_to_up && has_frame(chosen, TabulatedFrame::mtf))
    throw InputError("--up", "mtf and mtf-exact are at angles to the Euler-Rodrigues frame here");
  const PathAngle angle = angle_to(options.up.chosen(path, is_to_up), path);
  require_frames(chosen, angle);
  options.start.check(path, angle.reference());
  const bool has_twist = has_twist_frames(chosen);
  if (has_twist) add_twist_frames(chosen, options, named, angle);
  if (by == ParameterKind::arc_length &&
      std::ranges::find(chosen.scalars, TabulatedScalar::arc_length) == chosen.scalars.end())
    chosen.scalars.push_back(TabulatedScalar::arc_length);
  const AskedRows asked = with_sides(
      asked_rows(named, has_twist, options), path,
      choose<Side>("--side", options.side,
                   {{"right", Side::right}, {"left", Side::left}, {"both", Side::both}}));
  FrameRows rows(angle, chosen, asked.places);
  use(TableUse{named, rows, asked, are_times ? "time" : column_of(by)});
}

FrameTable table_of(const TableColumns& columns, const TableUse& use) {
  FrameTable table = tabulated(columns, [&] { return frame_table(use.rows); });
  table.near = use.named.near;
  if (!use.asked.values.empty()) add_column(table, use.column, use.asked.values, columns.digits);
  return table;
}

void run_camera(const FramesOptions& options) {
  TableColumns chosen = columns(options);
  if (chosen.frames.size() != 1)
    throw InputError("--frame", "a camera path has one frame, not several");
  chosen = camera_columns(chosen.frames.front());
  std::optional<Rational> duration;
  if (options.duration) duration = parse_positive_option("--duration", *options.duration);
  const double fps = round_to_double(parse_positive_option("--fps", options.fps));
  if (fps < 0.001 || fps > 30'000) throw InputError("--fps", "is not between 0.001 and 30000");
  tabulate(options, chosen, [&](const TableUse& use) {
    const FrameTable table = table_of(chosen, use);
    const CameraPath path = at_place(
        "frames", ": ", [&] { return camera_path(table, use.asked.places.numbers(), duration); });
    write_output(options.curve.output, options.format == "glb"    ? to_glb(path)
                                       : options.format == "gltf" ? to_gltf(path)
                                                                  : to_blender(path, fps));
  });
}

/// The table at once.
WrittenRows write_whole_table(const std::string& output, const FrameTable& table,
                              const std::string& text) {
  write_output(output, text);
  return {table.incomplete_rows, table.first_reason};
}

void run(const FramesOptions& options) {
  enum class Format { csv, json, npy, camera };
  const auto format = choose<Format>("--format", options.format,
                                     {{"csv", Format::csv},
                                      {"json", Format::json},
                                      {"npy", Format::npy},
                                      {"glb", Format::camera},
                                      {"gltf", Format::camera},
                                      {"blender", Format::camera}});
  if (format == Format::camera) return run_camera(options);
  TableColumns chosen = columns(options);
  chosen.may_be_empty = options.skips_undefined;
  chosen.digits = options.digits;
  tabulate(options, chosen, [&](const TableUse& use) {
    const std::string& output = options.curve.output;
    const auto in_rows = [&] {
      return tabulated(chosen, [&] {
        return write_rows(output, use.rows, format == Format::csv ? csv_rows() : npy_rows());
      });
    };
    const auto as_a_whole = [&] {
      const FrameTable table = table_of(chosen, use);
      return write_whole_table(output, table,
                               format == Format::json  ? to_json(table)
                               : format == Format::npy ? to_npy(table)
                                                       : to_csv(table));
    };
    const bool is_streamed =
        format != Format::json && chosen.digits == 0 && use.asked.values.empty();
    const WrittenRows written = is_streamed ? in_rows() : as_a_whole();
    if (written.incomplete > 0)
      note(fmt::format("{} of {} rows {} empty cells; the first: {}", written.incomplete,
                       use.rows.size(), written.incomplete == 1 ? "has" : "have",
                       written.first_reason));
  });
}

}  // namespace

void add_frames(Program& program) {
  Command& command = program.add("frames", "a table of t, r, e1 and frame vectors");
  const auto options = std::make_shared<FramesOptions>();
  options->curve.add_to(command);
  options->parameters.add_to(command, {"--subdivide"}, true);
  options->feed.add_to(command,
                       "the speed of the motion, as of phrame interpolate: 50, or '10 + 2*s'");
  command.only_with({"--feed"}, {"--by time"});
  command.only_with({"--max-normal-acceleration", "--max-tangential-acceleration"}, {"--feed"});
  command.add_choices(
      "--frame", options->frames, keys(frame_names()),
      "any of rmf (rotation-minimizing, default: f2, f3), erf (Euler-Rodrigues:\n"
      "e2, e3), frenet (n, b), up (of a fixed vector), mtf and mtf-exact (of minimal\n"
      "twist: rational, or at a constant rate), and frenet-signed (sn, sb: frenet,\n"
      "continued through inflections)");
  command.add_choices(
      "--columns", options->scalars, keys(column_names()),
      "any of s (arc length), curvature, torsion, frenet_rate, bishop (k1, k2 of the\n"
      "RMF), omega (its angular velocity per length) and signed_curvature (with the sign\n"
      "that it has with frenet-signed); of mtf-exact twist_rate,\n"
      "twist_omega and twist_alpha (its rate about e1, angular velocity and\n"
      "acceleration per length); and of each frame quaternion (x, y, z, w) and matrix\n"
      "(4 x 4, by rows)");
  command.add_number("--digits", options->digits, {1, 100'000},
                     "decimals with N digits, correctly rounded, instead of doubles");
  command.add_choice("--side", options->side, {"right", "left", "both"},
                     "right (default), left or both: the frame behind a corner, where the tangent\n"
                     "breaks at a joint, that before it, or a row for each");
  options->start.add_to(command, StartOptions::Rule::least_rotation);
  command.only_with(StartOptions::names(), {"--frame rmf"});
  options->roll.add_to(command);
  command.only_with(RollOption::names(),
                    {"--frame rmf", "--frame up", "--frame mtf", "--frame mtf-exact"});
  options->up.add_to(
      command,
      "frame up, v x e1/|v x e1| and e1 x (v x e1)/|v x e1|, that --start up starts\n"
      "with and angles of mtf-exact without mtf are counted from (default: one that is\n"
      "nowhere along the tangent)");
  command.only_with({"--up"}, {"--frame up", "--frame mtf-exact", "--start up"});
  options->twist.add_to(command);
  command.only_with(TwistOptions::of_ends(), {"--frame mtf", "--frame mtf-exact"});
  command.only_with(TwistOptions::of_rational_frame(), {"--frame mtf"});
  command.add_format("--format", options->format, {"csv", "json", "npy", "glb", "gltf", "blender"},
                     "csv (default), json or npy; a camera path as glb, gltf or a script for\n"
                     "blender, with keys of place and rotation");
  command.add_option("--duration", "SECONDS", options->duration,
                     "of the camera path (default: t, arc length or times are seconds)");
  command.only_with({"--duration"}, camera_formats());
  command.add_option("--fps", "N", options->fps, "frames a second in Blender (default 24)");
  command.only_with({"--fps"}, {"--format blender"});
  command.add_flag("--skip-undefined", options->skips_undefined,
                   "leave cells empty where the Frenet frame, a curvature or the torsion is\n"
                   "undefined (json: null, npy: NaN), and say so on stderr");
  command.only_with({"--skip-undefined"}, {"--frame frenet", "--frame erf", "--columns"});
  command.not_with({"--columns", "--skip-undefined", "--digits"}, camera_formats());
  command.not_with({"--digits"}, {"--format npy"});
  command.set_notes(
      "--at or --samples is needed: what the rows of the table are.\n"
      "All numbers are correctly rounded doubles, or decimals with --digits. e1 is A i A*/|A|^2, "
      "the unit tangent\n"
      "where the multiplier is positive and its opposite where it is negative, as is n then.\n"
      "--by arc-length evaluates at the exact t of each arc length; column t is that t, rounded,\n"
      "and --by time --feed V where a motion with the speed V is at each time.\n"
      "The RMF turns at the rate curvature, the Frenet frame at frenet_rate = sqrt(curvature^2 +\n"
      "torsion^2), per unit of arc length.\n"
      "A matrix has the columns e1, two vectors of the frame and x, y, z. A quaternion turns the\n"
      "axes into the frame; of the two that do, it is the one nearer to that of the row before.\n"
      "Of mtf-exact through the orientations of a file both are those of the body, as given.\n"
      "A camera looks along e1, with f2 (or the first vector of another frame) up.\n"
      "A curve of any kind, as a Bezier curve or a NURBS, has rmf, up, frenet and mtf-exact, and\n"
      "all columns; erf where a segment is Pythagorean-hodograph.\n"
      "A spline of n segments has t from 0 to n; at a joint, n, b and curvatures are\n"
      "those of the later segment.\n"
      "Examples:\n"
      "  phrame frames curve.json --samples 101 -o frames.csv\n"
      "  phrame frames curve.json --by arc-length --samples 101 --columns s,curvature\n"
      "  phrame frames curve.json --frame rmf,frenet --samples 1001 --format npy -o frames.npy\n"
      "  phrame frames curve.json --samples 101 --columns quaternion -o poses.csv\n"
      "  phrame frames curve.json --by arc-length --samples 241 --duration 10 -o camera.glb\n"
      "  phrame frames curve.json --frame mtf --from pi/8 --to -pi/2 --samples 101");
  command.does(options, run);
}

}  // namespace phrame::cli
