#include "phrame/io/write/surface.hpp"

#include <fmt/format.h>

#include <iterator>

#include "phrame/algebra/rounding.hpp"
#include "phrame/io/write/json_text.hpp"

namespace phrame::inline v0 {
namespace {

JsonOutput json_of(const SurfacePatch& patch) {
  JsonOutput points = JsonOutput::array();
  JsonOutput weights = JsonOutput::array();
  for (std::size_t k = 0; k < patch.points.size(); ++k) {
    JsonOutput row = JsonOutput::array();
    JsonOutput of_row = JsonOutput::array();
    for (std::size_t l = 0; l < patch.points[k].size(); ++l) {
      row.push_back(phrame::json_of(patch.points[k][l]));
      of_row.push_back(patch.weights[k][l].str());
    }
    points.push_back(std::move(row));
    weights.push_back(std::move(of_row));
  }
  return {{"t", {patch.from.str(), patch.to.str()}}, {"side", patch.side},
          {"degree_t", patch.points.size() - 1},     {"degree_u", patch.points.front().size() - 1},
          {"weights", std::move(weights)},           {"points", std::move(points)}};
}

}  // namespace

std::string to_json(const RationalSweepAnswer& answer) {
  JsonOutput json = {{"phrame", "surface/1"}};
  if (!answer.name.empty()) json["name"] = answer.name;
  add_nearness(json, answer.near);
  json["frame"] = answer.twist_degree ? "minimal twist" : "rotation-minimizing";
  if (answer.twist_degree) json["twist_degree"] = *answer.twist_degree;
  json["closed"] = answer.surface.is_closed;
  json["sides"] = answer.surface.sides;
  json["rings"] = answer.surface.rings;
  json["patches"] = JsonOutput::array();
  for (const SurfacePatch& patch : answer.surface.patches)
    json["patches"].push_back(json_of(patch));
  return pretty(json);
}

std::string to_obj(const RationalSweepAnswer& answer) {
  std::string text = "cstype rat bezier\n";
  const auto out = std::back_inserter(text);
  std::size_t next = 1;
  for (const SurfacePatch& patch : answer.surface.patches) {
    std::size_t count = 0;
    for (std::size_t k = 0; k < patch.points.size(); ++k)
      for (std::size_t l = 0; l < patch.points[k].size(); ++l, ++count) {
        const auto& [x, y, z] = patch.points[k][l];
        fmt::format_to(out, "v {} {} {} {}\n", round_to_double(x), round_to_double(y),
                       round_to_double(z), round_to_double(patch.weights[k][l]));
      }
    fmt::format_to(out, "deg {} {}\nsurf 0 1 0 1", patch.points.front().size() - 1,
                   patch.points.size() - 1);
    for (std::size_t k = 0; k < count; ++k) fmt::format_to(out, " {}", next++);
    text += "\nparm u 0 1\nparm v 0 1\nend\n";
  }
  return text;
}

}  // namespace phrame
