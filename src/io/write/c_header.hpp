#pragma once
#include <string>

#include "phrame/answer/compiled.hpp"
#include "phrame/export.hpp"

namespace phrame::inline v0 {

/// C99, self-contained: prefix_theta(t), and with a rotation prefix_frame(t, f1, f2, f3), with what
/// they are, for which t and how exactly. It compiles as C++17 too. All names in C begin with the
/// prefix.
PHRAME_API std::string to_c_header(const CompiledAnswer& compiled, const std::string& prefix);

/// A prefix made of the name of a curve: letters, digits and '_'; "curve" where nothing is left.
PHRAME_API std::string prefix_from(const std::string& name);
/// Is it a name in C that is not reserved, and no longer than 60? (C++ reserves each with "__".)
PHRAME_API bool is_prefix(const std::string& text);

}  // namespace phrame
