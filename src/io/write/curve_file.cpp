#include "phrame/io/write/curve_file.hpp"

#include "phrame/io/write/json_text.hpp"

namespace phrame::inline v0 {

std::string write_curve(const NamedCurve& named) { return pretty(json_of(named)); }

std::string write_path(const NamedPath& named) { return pretty(json_of(named)); }

std::string write_paths(const std::vector<NamedPath>& paths) {
  if (paths.size() == 1) return write_path(paths.front());
  std::string lines;
  for (const NamedPath& path : paths) lines += json_of(path).dump() + "\n";
  return lines;
}

}  // namespace phrame
