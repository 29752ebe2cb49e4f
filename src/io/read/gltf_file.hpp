#pragma once
#include <string_view>

#include "phrame/io/read/file_reading.hpp"
#include "phrame/io/read/json_node.hpp"
#include "phrame/io/read/point_curve.hpp"

namespace phrame::inline v0 {

/// Does the file begin as a binary glTF does?
bool is_glb_file(std::string_view bytes);
/// Is it the JSON of a glTF?
bool is_gltf_file(const JsonNode& node);

/// The way of a node that an animation of a glTF 2.0 moves, as cameras are, or of the one that is
/// picked by its name: the places of its keys joined by lines (LINEAR) or by cubic curves
/// (CUBICSPLINE), by the times of the animation, in the coordinates of its parent, which a note
/// says. Rotations are left out. Buffers are within the file, as data in base64, or in a binary
/// one. Throws InputError, its place a JSON pointer, where there is no such animation or several,
/// and for one in steps.
PointCurve read_gltf(const JsonNode& node, const FileReading& reading,
                     std::string_view binary = {});
/// The same of a binary file; its place is "header" or within the JSON of that.
PointCurve read_glb(std::string_view bytes, const FileReading& reading);

}  // namespace phrame
