#pragma once
#include "phrame/io/read/curve_file.hpp"
#include "phrame/io/read/file_reading.hpp"
#include "phrame/io/read/json_node.hpp"
#include "phrame/io/read/point_curve.hpp"

namespace phrame::inline v0 {

/// Is it what Object3D.toJSON() of three.js writes: an object with "metadata" of the type Object,
/// or with "object" and "geometries" or "shapes"?
bool is_three_scene(const JsonNode& node);
/// The curve of such a scene: the path of a TubeGeometry, the extrudePath of an ExtrudeGeometry, or
/// a shape (read_three). It is called by the name of its geometry, or of the object that has it, or
/// by its uuid. Of several, the one that is picked, by its name or uuid. It is in the coordinates
/// of the geometry, without the matrices of objects, which a note says. Throws InputError where
/// there is none, where several are there and none is picked, with their names, and as
/// read_three().
PointCurve read_three_scene(const JsonNode& node, const CurveLimits& limits,
                            const FileReading& reading);

}  // namespace phrame
