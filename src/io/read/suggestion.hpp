#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace phrame::inline v0 {

/// The name that `word` was probably meant to be, but for case, '-' and '_': the shortest that
/// begins with it; else the nearest by inserted, deleted, replaced and swapped letters, at most one
/// in three of them; else one that it is a part of, or that is a part of it. What is part of
/// another has three letters at least. No value where none is that near.
std::optional<std::string> suggestion(std::string_view word, const std::vector<std::string>& names);

}  // namespace phrame
