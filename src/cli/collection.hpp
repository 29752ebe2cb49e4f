#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "phrame/io/read/json_value.hpp"
#include "phrame/ph/curve/path.hpp"

namespace phrame::inline v0::cli {

/// A curve of the reference collection (docs/reference.md).
struct CollectedCurve {
  std::string name;   ///< unique
  std::string group;  ///< the name of its file
  std::string line;   ///< of that file: the curve with what is expected of it
  JsonValue json;     ///< what the line says

  NamedPath path() const;
};

/// The curves of these groups, of all where none is named, in the order of their files. The
/// collection is beside the program, as it is installed and in a build. Throws InputError where it
/// is not there, and for a group that is none.
std::vector<CollectedCurve> reference_collection(const std::vector<std::string>& groups = {});

}  // namespace phrame::cli
