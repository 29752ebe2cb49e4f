#pragma once
#include "phrame/answer/offset_drawing.hpp"
#include "phrame/cli/command.hpp"
#include "phrame/io/write/answers.hpp"
#include "phrame/io/write/nurbs.hpp"
#include "phrame/io/write/offset_gcode.hpp"
#include "phrame/io/write/offset_page.hpp"
#include "phrame/io/write/svg.hpp"

namespace phrame::inline v0::cli {

/// What -o writes, and the endings of such files.
inline constexpr const char* boundary_formats =
    "a curve in JSON, DXF or SVG there, G-code, or a page";
inline std::vector<std::string> boundary_endings() {
  return {"json", "jsonl", "dxf", "svg", "html", "htm", "nc", "ngc", "gcode", "tap"};
}

inline bool is_gcode(const std::string& file) {
  const std::string end = ending(file);
  return end == "nc" || end == "ngc" || end == "gcode" || end == "tap";
}

/// Throws InputError where --tol is given and the file is no G-code.
inline std::optional<Rational> gcode_tolerance(const std::optional<std::string>& tolerance,
                                               const std::string& file) {
  if (!tolerance) return std::nullopt;
  if (!is_gcode(file)) throw InputError("--tol", "needs G-code, as of -o FILE.nc");
  return parse_positive_option("--tol", *tolerance);
}

/// --print and -o of offsets and of envelopes: a report, or the curves themselves.
template <class Answer>
class BoundaryPrinter {
 public:
  using Writer = std::string (*)(const Answer&);

  /// That of this name; `as_curves` writes curve files. Throws InputError for another name.
  BoundaryPrinter(const std::string& name, Writer as_curves)
      : print_(choose<Writer>("--print", name,
                              {{"text", to_text},
                               {"json", to_json},
                               {"latex", to_latex},
                               {"curve", as_curves},
                               {"nurbs", as_nurbs}})),
        as_curves_(as_curves) {}

  /// The curves go to that file, if there is one, by its ending or as they are printed, and a
  /// report, or curves without a file, to standard output. The tolerance is that of G-code.
  void write(const Answer& answer, const std::string& file, const TextLength& length,
             const std::optional<Rational>& tolerance) const {
    const bool is_curve = print_ == as_curves_ || print_ == as_nurbs;
    const std::string end = ending(file);
    if (end == "svg")
      write_output(file, write_svg(drawing(answer)));
    else if (end == "dxf")
      write_output(file, write_dxf(nurbs(answer)));
    else if (is_gcode(file))
      write_output(file, as_gcode(answer, tolerance));
    else if (end == "html" || end == "htm")
      write_output(file, to_page(answer));
    else if (!file.empty() || is_curve)
      write_curves(file.empty() ? "-" : file, is_curve ? print_(answer) : as_curves_(answer));
    if (!is_curve) length.write("-", print_(answer));
  }

 private:
  static std::string as_gcode(const Answer& answer, const std::optional<Rational>& tolerance) {
    try {
      return write_gcode(polylines(answer, tolerance));
    } catch (const InputError& error) {
      throw InputError(error.place() == "tolerance" ? "--tol" : error.place(), error.reason());
    }
  }
  static std::string as_nurbs(const Answer& answer) { return write_nurbs(nurbs(answer)); }

  Writer print_;
  Writer as_curves_;
};

}  // namespace phrame::cli
