#include "phrame/io/read/three_scene.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "phrame/algebra/error.hpp"
#include "phrame/io/read/three_file.hpp"

namespace phrame {
namespace {

using Kind = JsonNode::Kind;

std::string text_at(const JsonNode& node, const std::string& key) {
  const auto found = node.find(key);
  return found && found->is(Kind::string) ? found->string() : "";
}

/// A curve of the scene, not yet read.
struct Candidate {
  JsonNode curve;
  std::string uuid;
  std::string name;  ///< may be empty

  const std::string& shown() const { return name.empty() ? uuid : name; }
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
      Candidate found{*curve, text_at(item, "uuid"), text_at(item, "name")};
      const auto object = scene.find("object");
      if (found.name.empty() && object) found.name = name_of_owner(*object, found.uuid);
      if (found.shown().empty()) found.name = item.place();
      all.push_back(std::move(found));
    }
  }
  return all;
}

std::string names_of(const std::vector<Candidate>& list) {
  constexpr std::size_t most = 12;
  std::vector<std::string> names;
  for (const Candidate& candidate : list)
    if (names.size() < most) names.push_back(abbreviated(candidate.shown()));
  return fmt::format("{}{}", fmt::join(names, ", "),
                     list.size() > most ? fmt::format(" and {} more", list.size() - most) : "");
}

const Candidate& chosen(const JsonNode& scene, const std::vector<Candidate>& all,
                        const std::string& pick) {
  if (all.empty())
    scene.fail(
        "there is no curve in the scene: no TubeGeometry, no ExtrudeGeometry along a path, "
        "no shape");
  std::vector<const Candidate*> found;
  for (const Candidate& candidate : all)
    if (pick.empty() || pick == candidate.name || pick == candidate.uuid)
      found.push_back(&candidate);
  if (found.empty())
    scene.fail(
        fmt::format("there is no curve \"{}\"; there are {}", abbreviated(pick), names_of(all)));
  if (found.size() > 1 && pick.empty())
    scene.fail(
        fmt::format("there are {} curves, and --pick names one: {}", all.size(), names_of(all)));
  if (found.size() > 1)
    scene.fail(fmt::format("{} curves are called \"{}\": pick one by its uuid", found.size(),
                           abbreviated(pick)));
  return *found.front();
}

}  // namespace

bool is_three_scene(const JsonNode& node) {
  if (!node.is(Kind::object) || node.find("phrame")) return false;
  if (node.find("object") && (node.find("geometries") || node.find("shapes"))) return true;
  const auto metadata = node.find("metadata");
  return metadata && metadata->is(Kind::object) && text_at(*metadata, "type") == "Object";
}

ThreeCurve read_three_scene(const JsonNode& node, const CurveLimits& limits,
                            const FileReading& reading) {
  const std::vector<Candidate> all = candidates(node);
  const Candidate& found = chosen(node, all, reading.pick);
  return {found.name.starts_with('/') ? "" : found.shown(),
          read_three(found.curve, limits),
          {fmt::format("the curve is \"{}\", in the coordinates of its geometry",
                       abbreviated(found.shown()))}};
}

}  // namespace phrame
