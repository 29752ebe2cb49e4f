#include "phrame/answer/sweep.hpp"

#include <fmt/format.h>

#include "phrame/algebra/rounding.hpp"
#include "phrame/cli/command.hpp"
#include "phrame/io/read/expression.hpp"
#include "phrame/io/read/profile.hpp"
#include "phrame/io/write/mesh.hpp"

namespace phrame::cli {
namespace {

struct SweepOptions {
  CurveOptions curve;
  std::string profile;
  StartOptions start;
  std::optional<std::string> end_normal;
  std::optional<std::string> twist;
  std::string scale = "1";
  std::optional<std::string> tolerance;
  long sections = 0;
  std::string format = "obj";
};

RationalFunction scale_of(const SweepOptions& options) {
  return at_place("--scale", ", ", [&] { return parse_expression(options.scale, "t").value; });
}

Rational positive_option(const std::string& option, const std::string& text) {
  const Rational x = parse_option(option, text);
  if (x <= 0) throw InputError(option, "\"" + abbreviated(text) + "\" is not > 0");
  return x;
}

/// Four times as near as the whole is to be.
Profile profile_of(const SweepOptions& options, double scale) {
  std::optional<Rational> tolerance;
  if (options.tolerance)
    tolerance = positive_option("--tolerance", *options.tolerance) / (4 * exact_rational(scale));
  return at_place("--profile", ": ", [&] {
    if (auto given = parse_profile(options.profile, tolerance)) return *std::move(given);
    const std::string bytes = read_file(options.profile);
    return at_place(options.profile, ":", [&] { return read_profile(bytes, tolerance); });
  });
}

void check_start(const SweepOptions& options, const AnyPath& path) {
  if (const auto* smooth = std::get_if<NamedSmoothPath>(&path))
    options.start.check(SmoothAngle(smooth->path));
  else
    options.start.check(std::get<NamedPath>(path).path);
}

SweepQuery query_of(const SweepOptions& options, std::size_t segments) {
  const RationalFunction scale = scale_of(options);
  const double greatest = greatest_scale(scale, segments);
  const Profile profile = profile_of(options, greatest);
  SweepQuery query{profile, options.start.given().value_or(FrameStart())};
  query.scale = scale;
  if (options.end_normal)
    query.end_normal = parse_vector_option("--end-normal", *options.end_normal);
  if (options.twist) query.twist = parse_angle_option("--twist", *options.twist);
  if (options.sections > 0)
    query.tolerance_or_sections = options.sections;
  else if (options.tolerance)
    query.tolerance_or_sections = parse_option("--tolerance", *options.tolerance);
  else
    query.tolerance_or_sections = exact_rational(profile.reach() * greatest / 200);
  return query;
}

/// A line about the mesh, where standard output is free for it.
void tell(const SweepAnswer& answer, const std::string& output) {
  const SweptBody& body = answer.body;
  std::string text = fmt::format("{} points, {} triangles, {} sections", body.mesh.points.size(),
                                 body.mesh.triangles.size(), body.sections);
  if (body.error)
    text += ", within " + upper_bound_text(exact_rational(*body.error)) + " of the surface, proved";
  if (answer.is_closed) text += fmt::format("; closed by a turn of {:.6g}", answer.turn);
  if (output != "-") write_output("-", text + "\n");
  if (body.folds > 0)
    note(
        fmt::format("the body folds over itself at {} corners of sections: the profile reaches "
                    "beyond the center of curvature",
                    body.folds));
}

void run(const SweepOptions& options) {
  const auto format = choose<std::string (*)(const Mesh&)>(
      "--format", options.format,
      {{"obj", to_obj}, {"stl", to_stl}, {"ply", to_ply}, {"glb", to_glb}});
  const AnyPath path = options.curve.read_any_path();
  check_start(options, path);
  const std::size_t segments =
      std::visit([](const auto& named) { return named.path.segments().size(); }, path);
  const SweepQuery query = query_of(options, segments);
  const SweepAnswer made =
      std::visit([&](const auto& named) { return answer(named, query); }, path);
  write_output(options.curve.output, format(made.body.mesh));
  tell(made, options.curve.output);
}

}  // namespace

void add_sweep(Program& program) {
  Command& command = program.add("sweep", "a body: a profile swept along the curve, as a mesh");
  const auto options = std::make_shared<SweepOptions>();
  options->curve.add_to(command);
  command.add_option("--profile", "SECTION", options->profile,
                     "circle:R, polygon:N,R, rectangle:W,H, or a file: a table of corners x,y,\n"
                     "or an SVG file or path with one outline; x is along f2, y along f3");
  command.require("--profile");
  options->start.add_to(command, "e2", "default 0");
  command.add_option("--end-normal", "X,Y,Z", options->end_normal,
                     "f2 at the end, projected to the normal plane: the frame of minimal twist");
  command.add_option("--twist", "ANGLE", options->twist,
                     "by which the profile turns from start to end, evenly along the length");
  command.add_option("--scale", "EXPR", options->scale,
                     "how many times as large the profile is: a rational function of t");
  command.add_option("--tolerance", "DISTANCE", options->tolerance,
                     "between mesh and surface, at most, proved (default: 1/200 of the profile)");
  command.add_number("--sections", options->sections, {2, 1'000'000},
                     "so many sections at equal steps of t, instead of a tolerance");
  command.not_with({"--sections"}, {"--tolerance"});
  command.add_format("--format", options->format, {"obj", "stl", "ply", "glb"},
                     "obj (default), stl, ply or glb, the last three binary");
  command.set_notes(
      "The frame is the rotation-minimizing one. The mesh is watertight, with caps at the ends; a\n"
      "closed curve has none: the profile turns by the least angle that closes the body.\n"
      "With -o a line says how many points and triangles there are, and how near the mesh is.\n"
      "A spline of n segments has t from 0 to n.\n"
      "Examples:\n"
      "  phrame sweep curve.json --profile circle:1/10 -o pipe.glb\n"
      "  phrame sweep curve.json --profile rectangle:2,1/2 --start-normal 0,0,1 -o rail.stl\n"
      "  phrame sweep curve.json --profile outline.svg --tolerance 0.001 -o body.obj\n"
      "  phrame sweep curve.json --profile polygon:6,1 --scale 1-t/2 --twist 90deg -o horn.ply");
  command.does([options] { run(*options); });
}

}  // namespace phrame::cli
