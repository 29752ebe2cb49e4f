#include "phrame/io/write/camera.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <iterator>

#include "phrame/algebra/nearest_float.hpp"
#include "phrame/io/write/bytes.hpp"
#include "phrame/io/write/frame_start.hpp"
#include "phrame/ph/curve/vector.hpp"

namespace phrame::inline v0 {
namespace {

/// The times, then all translations from the origin, then all rotations.
std::string camera_buffer(const CameraPath& path) {
  std::string buffer;
  for (const double time : path.times) append_float(buffer, as_float(time));
  for (const auto& place : path.places)
    for (const double x : place - path.origin) append_float(buffer, as_float(x));
  for (const auto& rotation : path.rotations)
    for (const double x : rotation) append_float(buffer, as_float(x));
  return buffer;
}

/// The camera's node and, where the origin is not 0, another around it, which has that.
std::string nodes_json(const Vector<double>& origin) {
  const std::string camera = R"({"name":"camera","camera":0})";
  if (origin == Vector<double>{}) return R"([{"nodes":[0]}],"nodes":[)" + camera + "]";
  return R"([{"nodes":[1]}],"nodes":[)" + camera + R"(,{"name":"origin","children":[0])" +
         translation_json(origin) + "}]";
}

/// What the JSON says of that buffer, which is at `uri`, or beside it where that is empty.
std::string camera_json(const CameraPath& path, const std::string& uri) {
  const std::size_t count = path.times.size();
  return fmt::format(
      R"({{"asset":{{"version":"2.0","generator":"phrame"{10}}},"scene":0,"scenes":{9},"cameras":[{{"type":"perspective",)"
      R"("perspective":{{"yfov":0.8,"znear":0.01}}}}],"animations":[{{"name":"path","samplers":[)"
      R"({{"input":0,"output":1,"interpolation":"LINEAR"}},)"
      R"({{"input":0,"output":2,"interpolation":"LINEAR"}}],"channels":[)"
      R"({{"sampler":0,"target":{{"node":0,"path":"translation"}}}},)"
      R"({{"sampler":1,"target":{{"node":0,"path":"rotation"}}}}]}}],)"
      R"("buffers":[{{"byteLength":{1}{2}}}],"bufferViews":[{{"buffer":0,"byteLength":{3}}},)"
      R"({{"buffer":0,"byteOffset":{3},"byteLength":{4}}},)"
      R"({{"buffer":0,"byteOffset":{5},"byteLength":{6}}}],"accessors":[)"
      R"({{"bufferView":0,"componentType":5126,"count":{0},"type":"SCALAR","min":[{7}],"max":[{8}]}},)"
      R"({{"bufferView":1,"componentType":5126,"count":{0},"type":"VEC3"}},)"
      R"({{"bufferView":2,"componentType":5126,"count":{0},"type":"VEC4"}}]}})",
      count, 32 * count, uri.empty() ? "" : ",\"uri\":\"" + uri + "\"", 4 * count, 12 * count,
      16 * count, 16 * count, as_float(path.times.front()), as_float(path.times.back()),
      nodes_json(path.origin),
      path.start ? R"(,"extras":{"start":")" + start_comment(*path.start, path.up) + "\"}" : "");
}

/// A script that makes a camera of the list `keys`.
constexpr const char* blender_script = R"(
scene = bpy.context.scene
scene.render.fps = max(1, round(FPS))
scene.render.fps_base = scene.render.fps / FPS
camera = bpy.data.objects.new("phrame", bpy.data.cameras.new("phrame"))
scene.collection.objects.link(camera)
camera.rotation_mode = "QUATERNION"
for second, location, rotation in keys:
    frame = 1 + second * FPS
    camera.location = location
    camera.rotation_quaternion = rotation
    camera.keyframe_insert("location", frame=frame)
    camera.keyframe_insert("rotation_quaternion", frame=frame)
action = camera.animation_data.action
if hasattr(action, "fcurves"):
    curves = list(action.fcurves)
else:  # Blender 5
    curves = [curve for layer in action.layers for strip in layer.strips
              for bag in strip.channelbags for curve in bag.fcurves]
for curve in curves:
    for point in curve.keyframe_points:
        point.interpolation = "LINEAR"
scene.frame_start = 1
scene.frame_end = math.ceil(1 + keys[-1][0] * FPS)
scene.camera = camera
)";

}  // namespace

std::string to_glb(const CameraPath& path) {
  const std::string buffer = camera_buffer(path);
  return glb_head(camera_json(path, ""), buffer.size()) + buffer;
}

std::string to_gltf(const CameraPath& path) {
  return camera_json(path, "data:application/octet-stream;base64," + base64(camera_buffer(path))) +
         "\n";
}

std::string to_blender(const CameraPath& path, double fps) {
  std::string text =
      "# A camera path, by phrame. In Blender: Scripting, Open, Run; or blender --python FILE.\n";
  if (path.start) text += fmt::format("# {}\n", start_comment(*path.start, path.up));
  text += "import math\n\nimport bpy\n\n";
  const auto out = std::back_inserter(text);
  fmt::format_to(out, "FPS = {}\n# seconds, location (x, y, z), rotation (w, x, y, z)\nkeys = [\n",
                 fps);
  for (std::size_t k = 0; k < path.times.size(); ++k) {
    const auto& [x, y, z] = path.places[k];
    const auto& [qx, qy, qz, qw] = path.rotations[k];
    fmt::format_to(out, "    ({}, ({}, {}, {}), ({}, {}, {}, {})),\n", path.times[k], x, y, z, qw,
                   qx, qy, qz);
  }
  return text + "]\n" + blender_script;
}

}  // namespace phrame
