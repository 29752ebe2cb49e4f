#include "phrame/answer/envelope.hpp"

#include "phrame/cli/boundary_printer.hpp"
#include "phrame/io/read/axis_file.hpp"

namespace phrame::inline v0::cli {
namespace {

struct EnvelopeOptions {
  std::string axis;
  CurveLimits limits;
  bool trim = false;
  std::string print = "text";
  TextLength length;
  std::string output;
  std::optional<std::string> tolerance;
  long digits = 17;
};

void run(const EnvelopeOptions& options) {
  const BoundaryPrinter<EnvelopeAnswer> printer(options.print, write_envelope);
  const std::optional<Rational> tolerance = gcode_tolerance(options.tolerance, options.output);
  const std::string text = read_file(options.axis);
  const NamedAxis axis =
      at_place(name_of_file(options.axis), ":", [&] { return read_axis(text, options.limits); });
  printer.write(answer(axis, {options.trim, options.digits}), options.output, options.length,
                tolerance);
}

}  // namespace

void add_envelope(Program& program) {
  Command& command = program.add(
      "envelope", "exact envelopes of discs along Minkowski PH curves, and what bounds them");
  const auto options = std::make_shared<EnvelopeOptions>();
  command.add_argument("AXIS", options->axis,
                       "an mph/1 file (JSON): curves with radii; \"-\" for standard input");
  add_max_degree(command, options->limits);
  command.add_flag("--trim", options->trim,
                   "cut away what is inside of a disc, by exact tests: the boundary of the union\n"
                   "of the discs, of which AXIS is the medial axis");
  add_digits(command, options->digits);
  command.only_with({"--digits"}, {"--trim"});
  command.add_option(
      "-o,--output", "FILE", options->output,
      "write the envelope to this file, beside the report: a curve file, several\n"
      "paths a line each; as .dxf a spline for each; as .svg by cubics within\n"
      "1/1000000 of the greatest radius, proved; as .nc G-code, lines within --tol,\n"
      "proved; as .html a page for a browser");
  command.writes(boundary_formats, boundary_endings());
  command.add_option("--tol", "BOUND", options->tolerance,
                     "the distance that is allowed of G-code (default 1/1000 of the greatest\n"
                     "radius)");
  command.only_with({"--tol"}, {"--output"});
  command.add_format(
      "--print", options->print, {"text", "json", "latex", "curve", "nurbs"},
      "text (default), json, latex, or the curve file instead of a report: curve, or\n"
      "nurbs, each path as one NURBS");
  options->length.add_to(command);
  command.set_notes(
      "A curve with radii (x, y, r) of which x'^2 + y'^2 - r'^2 is the square of a polynomial, a\n"
      "Minkowski PH curve, has rational curves as the envelope of its discs, to the right and to\n"
      "the left of travel; where it ends there are arcs. Several curves are a medial axis, with\n"
      "branches where discs at their ends are the same.\n"
      "AXIS: {\"phrame\": \"mph/1\", \"control_points\": [[0, 0, 1], [5, 0, 4]]}, or \"segments\" "
      "of such;\n"
      "by power or Bernstein coefficients \"x\", \"y\", \"r\", or by a \"preimage\", too.\n"
      "Examples:\n"
      "  phrame envelope axis.json\n"
      "  phrame envelope axis.json --trim -o domain.svg\n"
      "  phrame envelope axis.json --trim --print curve | phrame totals -");
  command.does(options, run);
}

}  // namespace phrame::cli
