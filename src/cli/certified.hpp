#pragma once
#include "phrame/ph/curve/path.hpp"

namespace phrame::inline v0::cli {

/// What phrame certify writes of angles along the path, without options but for t and digits.
std::string angle_certificate(const NamedPath& named, const std::vector<Rational>& at, long digits);

}  // namespace phrame::cli
