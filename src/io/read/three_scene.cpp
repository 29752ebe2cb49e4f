#include "phrame/io/read/three_scene.hpp"

#include <fmt/format.h>

#include "phrame/algebra/error.hpp"
#include "phrame/io/read/curve_choice.hpp"
#include "phrame/io/read/three_file.hpp"

namespace phrame::inline v0 {
namespace {

using Kind = JsonNode::Kind;

std::string text_at(const JsonNode& node, const std::string& key) {
  const auto found = node.find(key);
  return found && found->is(Kind::string) ? found->string() : "";
}

/// A curve of the scene, not yet read.
struct Candidate {
  JsonNode curve;
  CurveLabel label;  ///< its uuid is the id
};

/// The name of the first object below this one that has this geometry; empty where it has none.
std::string name_of_owner(const JsonNode& object, const std::string& uuid) {
  if (!object.is(Kind::object)) return "";
  if (text_at(object, "geometry") == uuid) return text_at(object, "name");
  const auto children = object.find("children");
  if (!children || !children->is(Kind::array)) return "";
  for (std::size_t k = 0; k < children->size(); ++k)
    if (std::string name = name_of_owner(children->item(k), uuid); !name.empty()) return name;
  return "";
}

/// What of a geometry is a curve.
std::optional<JsonNode> curve_of(const JsonNode& geometry) {
  if (is_three_file(geometry)) return geometry;
  const std::string type = text_at(geometry, "type");
  if (type != "ExtrudeGeometry" && type != "ExtrudeBufferGeometry") return std::nullopt;
  const auto options = geometry.find("options");
  if (!options || !options->is(Kind::object)) return std::nullopt;
  return options->find("extrudePath");
}

std::vector<Candidate> candidates(const JsonNode& scene) {
  std::vector<Candidate> all;
  for (const char* key : {"geometries", "shapes", "curves"}) {
    const auto list = scene.find(key);
    if (!list || !list->is(Kind::array)) continue;
    for (std::size_t k = 0; k < list->size(); ++k) {
      const JsonNode item = list->item(k);
      if (!item.is(Kind::object)) continue;
      const auto curve = curve_of(item);
      if (!curve) continue;
      CurveLabel label{text_at(item, "name"), text_at(item, "uuid")};
      const auto object = scene.find("object");
      if (label.name.empty() && object) label.name = name_of_owner(*object, label.id);
      if (label.shown().empty()) label.id = item.place();
      all.push_back({*curve, std::move(label)});
    }
  }
  return all;
}

}  // namespace

bool is_three_scene(const JsonNode& node) {
  if (!node.is(Kind::object) || node.find("phrame")) return false;
  if (node.find("object") && (node.find("geometries") || node.find("shapes"))) return true;
  const auto metadata = node.find("metadata");
  return metadata && metadata->is(Kind::object) && text_at(*metadata, "type") == "Object";
}

PointCurve read_three_scene(const JsonNode& node, const CurveLimits& limits,
                            const FileReading& reading) {
  const std::vector<Candidate> all = candidates(node);
  if (all.empty())
    node.fail(
        "there is no curve in the scene: no TubeGeometry, no ExtrudeGeometry along a path, "
        "no shape");
  std::vector<CurveLabel> labels;
  for (const Candidate& candidate : all) labels.push_back(candidate.label);
  const Candidate& found = all[chosen_curve(labels, reading.pick, node.place())];
  return {found.label.name,
          read_three(found.curve, limits),
          {fmt::format("the curve is \"{}\", in the coordinates of its geometry",
                       abbreviated(found.label.shown()))}};
}

}  // namespace phrame
