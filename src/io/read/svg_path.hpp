#pragma once
#include <string_view>

#include "phrame/io/read/given_segment.hpp"
#include "phrame/ph/curve/ellipse_arc.hpp"

namespace phrame::inline v0 {

/// The map x·a + y·b + offset of the plane.
struct PlaneMap {
  PlaneVector a{1, 0};
  PlaneVector b{0, 1};
  PlaneVector offset{0, 0};
};

/// One subpath in the notation of SVG's path data [SVG 2, 9.3], M L H V C S Q T A Z and their
/// relative forms, in the plane z = 0, with x and y as they are, that is y down. It is the part
/// [begin, end) of the text, whose lines and columns are the places. Numbers are exact; arcs are as
/// ellipse_arc() says. What has no length is left out. Throws InputError where it is not such a
/// path, and where a second subpath begins.
std::vector<GivenSegment> read_path_data(std::string_view text, std::size_t begin, std::size_t end,
                                         const PlaneMap& map = {});
/// The same of all subpaths, each begun by a moveto elsewhere, or by what follows a closepath.
std::vector<std::vector<GivenSegment>> read_subpaths(std::string_view text, std::size_t begin,
                                                     std::size_t end, const PlaneMap& map = {});
/// Does the text begin as path data, with a moveto and a number?
bool is_path_data(std::string_view text);

}  // namespace phrame
