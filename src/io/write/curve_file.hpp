#pragma once
#include <string>

#include "phrame/ph/curve/named.hpp"

namespace phrame {

/// A curve/1 file that read_curve reads as the same curve, in the power basis.
std::string write_curve(const NamedCurve& named);
/// The same of a path: a spline/1 file where it is a spline. Only its first segment says where it
/// starts, the others start where the one before ends.
std::string write_path(const NamedPhPath& named);

}  // namespace phrame
