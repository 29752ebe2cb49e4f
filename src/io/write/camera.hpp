#pragma once
#include <string>

#include "phrame/answer/camera_path.hpp"
#include "phrame/export.hpp"

namespace phrame::inline v0 {

// A camera path as files of other programs, with coordinates as they are: glTF takes y for up,
// Blender z.

/// glTF 2.0 in one binary file: a camera with an animation of its translation and its rotation,
/// whose keys are joined linearly. Numbers are the floats next to those of the path; far from 0
/// places are from a node near the path, which has its own in doubles.
PHRAME_API std::string to_glb(const CameraPath& path);
/// The same as text, with the numbers in base 64.
PHRAME_API std::string to_gltf(const CameraPath& path);
/// A script for Blender that makes a camera with keyframes of its location and its rotation, in
/// doubles; time 0 is frame 1, and a second has `fps` frames.
PHRAME_API std::string to_blender(const CameraPath& path, double fps);

}  // namespace phrame
