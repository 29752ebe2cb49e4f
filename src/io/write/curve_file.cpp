#include "phrame/io/write/curve_file.hpp"

#include "phrame/io/write/json_text.hpp"

namespace phrame {

std::string write_curve(const NamedCurve& named) { return pretty(json_of(named)); }

std::string write_path(const NamedPhPath& named) {
  const auto& [name, path, near, notes] = named;
  if (path.is_curve()) return write_curve({name, path.segments().front(), near});
  JsonOutput segments = JsonOutput::array();
  for (const Curve& curve : path.segments()) {
    JsonOutput segment = json_of(NamedCurve{"", curve});
    segment.erase("phrame");
    if (!segments.empty()) segment.erase("start");
    segments.push_back(std::move(segment));
  }
  JsonOutput json = {{"phrame", "spline/1"}};
  if (!name.empty()) json["name"] = name;
  add_note(json, near);
  json["segments"] = std::move(segments);
  return pretty(json);
}

}  // namespace phrame
