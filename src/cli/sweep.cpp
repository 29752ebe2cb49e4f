#include "phrame/answer/sweep.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "phrame/algebra/rounding.hpp"
#include "phrame/answer/rational_sweep.hpp"
#include "phrame/answer/sweep_stream.hpp"
#include "phrame/cli/command.hpp"
#include "phrame/cli/exchange.hpp"
#include "phrame/cli/step_file.hpp"
#include "phrame/io/read/expression.hpp"
#include "phrame/io/read/point_table.hpp"
#include "phrame/io/read/profile.hpp"
#include "phrame/io/read/profile_curve.hpp"
#include "phrame/io/write/mesh.hpp"
#include "phrame/io/write/mesh_writer.hpp"
#include "phrame/io/write/surface.hpp"
#include "phrame/ph/sweep/near_pipe.hpp"

namespace phrame::inline v0::cli {
namespace {

struct SweepOptions {
  CurveOptions curve;
  std::string profile;
  StartOptions start;
  RollOption roll;
  std::optional<std::string> end_normal;
  std::optional<std::string> twist;
  std::string scale = "1";
  std::optional<std::string> scale_column;
  std::optional<std::string> tolerance;
  std::optional<std::string> normal_tolerance;
  long sections = 0;
  std::optional<std::string> origin;
  std::string format = "obj";
  bool is_exact = false;
  long degree = 0;  ///< of a rational frame of minimal twist; 0: none is asked for
};

RationalFunction scale_of(const SweepOptions& options) {
  return at_place("--scale", ", ", [&] { return parse_expression(options.scale, "t").value; });
}

/// A rational function, or the values at joints in a list.
SweepScale sweep_scale_of(const SweepOptions& options) {
  if (options.scale_column)
    return SweepScale(options.curve.column("--scale-column", *options.scale_column));
  if (split({options.scale}).size() == 1) return scale_of(options);
  return SweepScale(parse_list_option("--scale", {options.scale}));
}

/// By `parse` where it is given in a word, by `read` from a file.
template <class Parse, class Read>
auto given_profile(const SweepOptions& options, Parse parse, Read read) {
  return at_place("--profile", ": ", [&] {
    if (auto given = parse(options.profile)) return *std::move(given);
    const std::string bytes = read_file(options.profile);
    return at_place(name_of_file(options.profile), ":", [&] { return read(bytes); });
  });
}

/// How near the normals are to be.
std::optional<Angle> normal_angle(const SweepOptions& options) {
  if (!options.normal_tolerance) return std::nullopt;
  const Angle angle = parse_angle_option("--normal-tolerance", *options.normal_tolerance);
  const double radians = round_to_double(to_real(FrameAngle(angle)));
  if (!(radians > 0 && radians <= 1.57))
    throw InputError("--normal-tolerance", "\"" + abbreviated(*options.normal_tolerance) +
                                               "\" is not between 0 and 90deg");
  return angle;
}

/// Four times as near as the whole is to be.
Profile profile_of(const SweepOptions& options, double scale,
                   const std::optional<Rational>& angle = std::nullopt) {
  ProfileTolerance tolerance{{}, angle};
  if (options.tolerance)
    tolerance.distance =
        parse_positive_option("--tolerance", *options.tolerance) / (4 * exact_rational(scale));
  return given_profile(
      options, [&](const std::string& text) { return parse_profile(text, tolerance); },
      [&](const std::string& bytes) { return read_profile(bytes, tolerance); });
}

/// Where coordinates are from; no value stands for a place near the body. In glTF a node has it, as
/// doubles, so that the body is where it is.
std::optional<Vector<Rational>> origin_of(const SweepOptions& options) {
  const bool has_node = options.format == "glb";
  if (options.origin == "auto" || (has_node && !options.origin)) return std::nullopt;
  if (!options.origin) return Vector<Rational>{};
  Vector<Rational> origin = parse_vector_option("--origin", *options.origin);
  if (has_node)
    for (Rational& x : origin) x = exact_rational(round_to_double(x));
  return origin;
}

SweepQuery query_of(const SweepOptions& options, const Path& path) {
  const SweepScale scale = sweep_scale_of(options);
  const std::size_t segments = path.segments().size();
  const double greatest = at_option(options.scale_column ? "--scale-column" : "--scale",
                                    [&] { return scale.greatest(segments); });
  const Profile profile = profile_of(options, greatest);
  SweepQuery query{profile, options.start.start()};
  query.scale = scale;
  query.roll = options.roll.chosen(options.curve);
  options.roll.check(query.roll, segments);
  if (options.end_normal)
    query.end_normal = parse_normal_option("--end-normal", *options.end_normal, path, end_of(path));
  if (options.twist) query.twist = parse_angle_option("--twist", *options.twist);
  query.normal_tolerance = normal_angle(options);
  query.profile_within = [&options, greatest](const Rational& angle) {
    return profile_of(options, greatest, angle);
  };
  query.origin = origin_of(options);
  if (options.format == "stl" || options.format == "glb") query.numbers = Coordinates::floats;
  if (options.sections > 0)
    query.tolerance_or_sections = options.sections;
  else if (options.tolerance)
    query.tolerance_or_sections = parse_option("--tolerance", *options.tolerance);
  else
    query.tolerance_or_sections = exact_rational(profile.reach() * greatest / 200);
  return query;
}

/// A line about the mesh, where standard output is free for it.
void tell(const SweepAnswer& answer, const MeshWriter& mesh, const std::string& output,
          bool is_in_place) {
  const SweptBody& body = answer.body;
  std::string text = fmt::format("{} points, {} triangles, {} sections", mesh.points(),
                                 mesh.triangles(), body.sections);
  if (body.error)
    text += ", within " + upper_bound_text(exact_rational(*body.error)) + " of the surface, " +
            (body.normal_error ? "its normals within " +
                                     upper_bound_text(exact_rational(*body.normal_error)) + " rad, "
                               : "") +
            "proved";
  if (answer.is_closed) text += fmt::format("; closed by a turn of {:.6g}", answer.turn);
  if (const auto& [x, y, z] = body.mesh.origin;
      !is_in_place && body.mesh.origin != Vector<Rational>{})
    text +=
        fmt::format("; coordinates are from {},{},{}", to_string(x), to_string(y), to_string(z));
  if (output != "-") write_output("-", text + "\n");
  if (body.folds > 0)
    note(
        fmt::format("the body folds over itself at {} corners of sections: the profile reaches "
                    "beyond the center of curvature, or around a corner",
                    body.folds));
}

/// Lines and arcs near the path that have exact surfaces, where it is of such.
std::optional<NearPipe> found_pipe(const Path& path) {
  try {
    return near_pipe(path);
  } catch (const Error&) {
    return std::nullopt;
  }
}

/// With --near lines and arcs are moved where that gives them exact surfaces; else the PH curve
/// near the control points is taken.
NamedPath read_exact_path(CurveOptions options) {
  const auto within = options.epsilon();
  if (!within) return options.read_any_path();
  if (Exchange::current() == nullptr) options.bytes = read_file(options.path);
  CurveOptions as_it_is = options;
  as_it_is.near.reset();
  std::optional<NearPipe> pipe;
  std::optional<NamedPath> named;
  try {
    named = as_it_is.read_any_path();
    if (named->path.is_ph()) return *std::move(named);
    pipe = found_pipe(named->path);
  } catch (const InputError&) {  // said again where it is read with --near
  }
  if (pipe && pipe->distance > *within && named->path.segments().size() > 1) {
    const std::vector<std::size_t>& corners = named->path.corners();
    throw InputError(
        "--near",
        "lines and arcs that are smooth at joints, with rational tangents, are up to " +
            upper_bound_text(pipe->distance) + " away" +
            (corners.empty() ? "" : fmt::format("; t = {} is a corner", corners.front())));
  }
  if (!pipe || pipe->distance > *within) return options.read_any_path();
  note("lines and arcs with rational tangents are taken, within " +
       upper_bound_text(pipe->distance) + " of the given ones, proved");
  named->path = pipe->path;
  return *std::move(named);
}

/// What helps where the rotation-minimizing frame is not rational.
RationalSweepAnswer exact_answer(const NamedPath& named, const RationalSweepQuery& query) {
  try {
    return answer(named, query);
  } catch (const DomainError& error) {
    const auto ph = named.path.ph();
    if (!ph) {
      const auto pipe = found_pipe(named.path);
      if (!pipe || pipe->distance > power_of_ten(-6)) throw;
      throw DomainError(std::string(error.what()) + "; --near " +
                        upper_bound_text(std::max(pipe->distance, power_of_ten(-30))) +
                        " takes lines and arcs so near that have exact surfaces");
    }
    const auto& segments = ph->segments();
    const bool is_rational = std::all_of(segments.begin(), segments.end(), [](const Curve& curve) {
      return std::holds_alternative<RationalFrame>(rational_frame(curve.preimage()));
    });
    if (query.twist_degree || is_rational) throw;
    throw DomainError(std::string(error.what()) + "; --" +
                      (ph->closing_turn() ? "degree 2" : "end-normal X,Y,Z") +
                      " takes a rational frame of minimal twist, and phrame construct --kind rmf "
                      "makes curves whose frame is rational");
  }
}

RationalSweepQuery exact_query(const SweepOptions& options, const Path& path) {
  RationalSweepQuery query{given_profile(options, parse_profile_curve, read_profile_curve),
                           options.start.start()};
  query.scale = scale_of(options);
  at_option("--scale", [&] { SweepScale(query.scale).require_along(path.segments().size()); });
  if (options.end_normal)
    query.end_normal = parse_normal_option("--end-normal", *options.end_normal, path, end_of(path));
  if (options.degree > 0)
    query.twist_degree = options.degree;
  else if (query.end_normal)
    query.twist_degree = 2;
  return query;
}

void run_exact(const Command& command, const SweepOptions& options) {
  const auto format = choose<std::string (*)(const RationalSweepAnswer&)>(
      "--format", options.format, {{"obj", to_obj}, {"json", to_json}, {"step", to_step}});
  command.refuse({"--twist"},
                 "a turn that is even per length has no rational sine and cosine; with --exact the "
                 "frame of minimal twist is that of --end-normal and --degree");
  const NamedPath path = read_exact_path(options.curve);
  options.start.check(path.path, std::nullopt);
  if (!path.path.is_ph() && (options.degree > 0 || options.end_normal))
    throw InputError(options.end_normal ? "--end-normal" : "--degree",
                     "the rational frame of minimal twist " + needs_ph(path.path));
  if (options.degree > 0 && !options.end_normal && !path.path.is_closed())
    throw InputError("--degree", "the frame of minimal twist of an open curve needs --end-normal");
  if (path.frame)
    note(
        "the orientations that come with the path are left aside: a mesh, without --exact, has "
        "them");
  const RationalSweepAnswer made = exact_answer(path, exact_query(options, path.path));
  write_output(options.curve.output, format(made));
  const auto& patches = made.surface.patches;
  if (options.curve.output != "-")
    write_output("-", fmt::format("{} rational Bezier patches, exact{}\n", patches.size(),
                                  made.surface.is_closed ? "; closed" : ""));
}

void run(const Command& command, const SweepOptions& options) {
  if (options.is_exact) return run_exact(command, options);
  const auto writer_of = choose<std::unique_ptr<MeshWriter> (*)(MeshWriter::NewSpool)>(
      "--format", options.format,
      {{"obj", obj_writer}, {"stl", stl_writer}, {"ply", ply_writer}, {"glb", glb_writer}});
  CurveOptions curve = options.curve;
  curve.reading.other_columns = {options.scale_column.value_or(""), options.roll.column_name()};
  const NamedPath named = curve.read_any_path();
  const auto up = UpOption().chosen(named.path, options.start.is_up());
  options.start.check(named.path, up);
  SweepQuery query = query_of(options, named.path);
  query.up = up;
  if (named.frame && !options.start.given() && !options.end_normal) query.through = named.frame;
  const auto writer = writer_of(Spool::with_file);
  const SweepAnswer made = answer(named, query, *writer);
  Output output(options.curve.output);
  writer->finish(made.body.mesh.origin, sweep_remark(query),
                 [&output](const std::string& bytes) { output.write(bytes); });
  output.finish();
  tell(made, *writer, options.curve.output, options.format == "glb");
}

}  // namespace

void add_sweep(Program& program) {
  Command& command = program.add("sweep", "a body: a profile swept along the curve, as a mesh");
  const auto options = std::make_shared<SweepOptions>();
  options->curve.add_to(command);
  command.add_option("--profile", "SECTION", options->profile,
                     "circle:R, polygon:N,R, rectangle:W,H, or a file: a table of corners x,y,\n"
                     "rings between empty lines, or an SVG file or path; what one outline goes\n"
                     "around are holes; x is along f2, y along f3");
  command.require("--profile");
  options->start.add_to(command, StartOptions::Rule::least_rotation);
  command.add_option("--end-normal", "X,Y,Z", options->end_normal,
                     "f2 at the end, projected to the normal plane: the frame of minimal twist");
  command.add_option("--twist", "ANGLE", options->twist,
                     "by which the profile turns from start to end, evenly along the length");
  command.add_option("--scale", "EXPR", options->scale,
                     "how many times as large the profile is: a rational function of t, or a list\n"
                     "of values at t = 0, 1, ..., between which it is linear");
  command.add_option("--scale-column", "NAME", options->scale_column,
                     "of a table of points: the column with these values, \"radius\"");
  command.not_with({"--scale-column"}, {"--scale", "--exact"});
  options->roll.add_to(command);
  command.not_with(RollOption::names(), {"--exact"});
  command.add_option("--tolerance", "DISTANCE", options->tolerance,
                     "between mesh and surface, at most, proved (default: 1/200 of the profile)");
  command.add_option(
      "--normal-tolerance", "ANGLE", options->normal_tolerance,
      "between the normals of triangles and of the surface, at most, proved; < 90deg");
  command.add_number("--sections", options->sections, {2, 1'000'000},
                     "so many sections at equal steps of t, instead of a tolerance; those of\n"
                     "corners are more, and lines from corner to corner have none between");
  command.not_with({"--sections"}, {"--tolerance", "--normal-tolerance"});
  command.add_option("--origin", "X,Y,Z", options->origin,
                     "from where coordinates are: a place, or auto for one near the body, for\n"
                     "files of floats (default: 0,0,0; in glb, whose node has it, auto)");
  command.add_words("--origin", {"auto"});
  command.add_flag(
      "--exact", options->is_exact,
      "not a mesh but the surface itself, as rational Bezier patches, of a curve\n"
      "whose rotation-minimizing frame is rational, as lines and arcs, or in a rational\n"
      "frame of minimal twist");
  command.add_number("--degree", options->degree, {1, 8},
                     "the rational frame of minimal twist with w of this degree (default 2 with\n"
                     "--end-normal); of a closed curve the one that closes");
  command.only_with({"--degree"}, {"--exact"});
  command.not_with({"--exact"}, {"--tolerance", "--normal-tolerance", "--sections", "--origin"});
  command.add_format("--format", options->format, {"obj", "stl", "ply", "glb", "json", "step"},
                     "obj (default), stl, ply or glb, the last three binary; with --exact obj\n"
                     "(free-form), json (exact fractions) or step (a solid, by Open CASCADE)");
  command.json_only_with("--exact");
  command.set_notes(
      "The frame is the rotation-minimizing one. The mesh is watertight, with caps at the ends; a\n"
      "closed curve has none: the profile turns by the least angle that closes the body.\n"
      "With -o a line says how many points and triangles there are, and how near the mesh is.\n"
      "A spline of n segments has t from 0 to n.\n"
      "Examples:\n"
      "  phrame sweep curve.json --profile circle:1/10 -o pipe.glb\n"
      "  phrame sweep curve.json --profile rectangle:2,1/2 --start-normal 0,0,1 -o rail.stl\n"
      "  phrame sweep curve.json --profile outline.svg --tolerance 0.001 -o body.obj\n"
      "  phrame sweep curve.json --profile circle:1/10 --exact -o pipe.json\n"
      "  phrame sweep curve.json --profile polygon:6,1 --scale 1-t/2 --twist 90deg -o horn.ply");
  command.does(options, run);
}

}  // namespace phrame::cli
