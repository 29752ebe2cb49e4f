#pragma once
#include <string_view>

#include "phrame/io/read/file_reading.hpp"
#include "phrame/io/read/point_curve.hpp"

namespace phrame::inline v0 {

/// Does the text begin as a program of G-code, or as one of APT with GOTO/?
bool is_gcode_file(std::string_view text);

/// The way of the tool in a program of G-code, where its numbers are as they are written, in their
/// unit: lines (G0, G1), arcs (G2, G3) in the planes G17, G18 and G19, with centers (I, J, K, from
/// the start of the arc or, by G90.1, as places) or radii (R), cubic curves (G5) and parabolas
/// (G5.1); in places or, by G91, in steps. It begins where the first moves have told each
/// coordinate that there is in the program. An arc whose ends are at the same distance from its
/// center is exact; of another one the ends are kept, and the note says how far it is from that
/// center. Where an arc moves across its plane, too, that is a linear function of the angle at 64
/// places of a turn and within 10⁻⁵ of the way of a turn between them, which a note says. What is
/// between rapid moves (G0) may be picked by its number. Other words of a block are left out; what
/// moves the tool elsewhere (canned cycles, home, macros, G68, G92) is refused with its line.
/// The points of GOTO/ and FROM/ in a program of APT are joined by lines, unless the reading says
/// what else they are.
PointCurve read_gcode(std::string_view text, const FileReading& reading);

}  // namespace phrame
