#pragma once
#include <string>

#include "phrame/answer/machine_path.hpp"
#include "phrame/export.hpp"

namespace phrame::inline v0 {

/// A program for machines with the axes X, Y, Z, A, C: G1 in inverse time (G93), comments in
/// parentheses, which say how it is to be read and where C is kept.
PHRAME_API std::string to_gcode(const MachinePath& path);

}  // namespace phrame
