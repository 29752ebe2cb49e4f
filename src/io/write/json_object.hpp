#pragma once
#include "phrame/io/write/json_text.hpp"

namespace phrame::inline v0 {

/// An empty object with room for so many members: beyond that it grows by copies of what is in it.
inline JsonOutput object_with_room(std::size_t members) {
  JsonOutput json = JsonOutput::object();
  json.get_ref<JsonOutput::object_t&>().reserve(members);
  return json;
}

}  // namespace phrame
