#pragma once
#include "phrame/io/read/json_node.hpp"
#include "phrame/ph/curve/frame_through.hpp"

namespace phrame::inline v0 {

/// The orientations at "frame" of a spline/1 of so many segments: `through`, a list of `t`, the
/// number of a joint, and `f2`, perhaps with `turns`, from 0 to the end; `twist`, "even" or
/// "smooth"; and `tangent_axis`. No value where there are none. Throws InputError.
std::optional<FrameThrough> read_frame_through(const JsonNode& spline, std::size_t segments);

/// What one of the words at that key means, which may be missing. Throws InputError for another.
template <class T>
T word_at(const JsonNode& node, const std::string& key, T otherwise,
          const std::vector<std::pair<std::string, T>>& words) {
  const auto found = node.find(key);
  if (!found) return otherwise;
  std::string list;
  for (const auto& [word, meaning] : words) {
    if (found->string() == word) return meaning;
    list += (list.empty() ? "" : ", ") + word;
  }
  found->fail("\"" + abbreviated(found->string()) + "\" is none of " + list);
}

/// A number of turns. Throws InputError where it is not whole, or beyond a million.
long read_turns(const JsonNode& node);

}  // namespace phrame
