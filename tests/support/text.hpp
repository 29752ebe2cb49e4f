#pragma once
#include <string_view>

namespace phrame::inline v0::test {

inline bool contains(std::string_view text, std::string_view part) {
  return text.find(part) != std::string_view::npos;
}

}  // namespace phrame::test
