#pragma once
#include <string_view>
#include <vector>

namespace phrame::inline v0 {

/// An HTML page without its data, one piece after the other: where these belong stand
/// "<!--title-->" and "<!--data-->". Empty where phrame was built without npm.
const std::vector<std::string_view>& page_template();

}  // namespace phrame
