#include "phrame/io/write/gcode.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <iterator>
#include <optional>
#include <string_view>
#include <utility>

#include "phrame/algebra/fixed_point.hpp"
#include "phrame/io/write/frame_start.hpp"
#include "phrame/io/write/offset_gcode.hpp"
#include "phrame/io/write/text.hpp"

namespace phrame::inline v0 {

namespace {

/// Numbered blocks, one a line.
class Blocks {
 public:
  explicit Blocks(std::string comments) : text_("%\n" + std::move(comments)) {}

  /// Begins the next one: "G0".
  void begin(std::string_view code) {
    fmt::format_to(std::back_inserter(text_), "N{} {}", ++number_, code);
  }
  void word(char letter, const Integer& n, long places) {
    fmt::format_to(std::back_inserter(text_), " {}{}", letter, fixed_point_text(n, places));
  }
  void end(std::string_view comment = "") {
    text_ += comment;
    text_ += '\n';
  }
  /// One without words.
  void add(std::string_view code) {
    begin(code);
    end();
  }
  std::string take() && { return std::move(text_) + "%\n"; }

 private:
  std::string text_;
  std::size_t number_ = 0;
};

}  // namespace

std::string to_gcode(const MachinePath& path) {
  const char* const tool = path.tool == ToolAxis::e1   ? "e1"
                           : path.tool == ToolAxis::f2 ? "f2"
                                                       : "f3";
  std::string text = fmt::format(
      "(phrame: a motion with the tool along {} of the rotation-minimizing frame)\n"
      "(X Y Z: tip of the tool on the workpiece; tool center point control must be on)\n"
      "(A C: degrees; from tip to spindle the tool is along sin C sin A, -cos C sin A, cos A)\n"
      "(F: 1/minutes that a move takes)\n",
      tool);
  if (path.tool != ToolAxis::e1) text += fmt::format("({})\n", start_comment(path.start, path.up));
  Blocks blocks(std::move(text));
  blocks.add("G90");
  for (std::size_t n = 0; n < path.moves.size(); ++n) {
    const MachineMove& move = path.moves[n];
    blocks.begin(n == 0 ? "G0" : n == 1 ? "G93 G1" : "G1");
    for (std::size_t k = 0; k < 3; ++k) blocks.word("XYZ"[k], move.tip[k], path.places);
    blocks.word('A', move.a, path.places);
    blocks.word('C', move.c, path.places);
    if (n > 0) blocks.word('F', move.feed, path.places);
    blocks.end(move.is_pole ? " (pole: C is kept)" : "");
  }
  blocks.add("G94");
  blocks.add("M30");
  return std::move(blocks).take();
}

std::string write_gcode(const OffsetPolylines& drawing) {
  Blocks blocks(
      fmt::format("(phrame: lines within {} of the {})\n"
                  "(X Y: as in the path; where G0 goes the tool is to be lifted)\n"
                  "(Z, F and S are to be set before)\n",
                  upper_bound_text(drawing.tolerance), drawing.question));
  blocks.add("G90");
  std::optional<OffsetPolylines::Point> here;
  for (const auto& points : drawing.paths)
    for (std::size_t n = 0; n < points.size(); ++n) {
      if (n == 0 && here == points[0]) continue;
      blocks.begin(n == 0 ? "G0" : "G1");
      for (std::size_t k = 0; k < 2; ++k) blocks.word("XY"[k], points[n][k], drawing.places);
      blocks.end();
      here = points[n];
    }
  blocks.add("M30");
  return std::move(blocks).take();
}

}  // namespace phrame
