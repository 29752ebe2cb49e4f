#include "phrame/io/write/gcode.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <iterator>

#include "phrame/algebra/fixed_point.hpp"
#include "phrame/io/write/frame_start.hpp"

namespace phrame::inline v0 {

std::string to_gcode(const MachinePath& path) {
  const char* const tool = path.tool == ToolAxis::e1   ? "e1"
                           : path.tool == ToolAxis::f2 ? "f2"
                                                       : "f3";
  std::string text = fmt::format(
      "%\n(phrame: a motion with the tool along {} of the rotation-minimizing frame)\n"
      "(X Y Z: tip of the tool on the workpiece; tool center point control must be on)\n"
      "(A C: degrees; from tip to spindle the tool is along sin C sin A, -cos C sin A, cos A)\n"
      "(F: 1/minutes that a move takes)\n",
      tool);
  if (path.tool != ToolAxis::e1) text += fmt::format("({})\n", start_comment(path.start, path.up));
  const auto out = std::back_inserter(text);
  const auto word = [&](char letter, const Integer& n) {
    fmt::format_to(out, " {}{}", letter, fixed_point_text(n, path.places));
  };
  fmt::format_to(out, "N1 G90\n");
  std::size_t line = 1;
  for (const MachineMove& move : path.moves) {
    ++line;
    fmt::format_to(out, "N{} {}", line, line == 2 ? "G0" : line == 3 ? "G93 G1" : "G1");
    for (std::size_t k = 0; k < 3; ++k) word("XYZ"[k], move.tip[k]);
    word('A', move.a);
    word('C', move.c);
    if (line > 2) word('F', move.feed);
    text += move.is_pole ? " (pole: C is kept)\n" : "\n";
  }
  fmt::format_to(out, "N{} G94\nN{} M30\n%\n", line + 1, line + 2);
  return text;
}

}  // namespace phrame
