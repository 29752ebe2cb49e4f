#pragma once
#include <string>

#include "phrame/io/write/prose.hpp"
#include "phrame/ph/curve/path.hpp"

namespace phrame::inline v0 {

/// The first line of a report: "PH quintic, degree 5 (preimage of degree 2)".
std::string heading(const std::string& name, const Curve& curve);
/// "rational curve of degree 2", "curve by formulas".
std::string kind_of(const Segment& segment);
/// Of a path of any kind: the same of one PH curve, "PH spline of 4 segments, closed", "rational
/// curve of degree 2", "path of 4 curves, closed". Whether a rational curve is a "rational PH
/// curve" is only found out where that is asked for.
std::string heading(const NamedPath& named, bool finds_ph = true);

/// What frames and angles mean where the multiplier is negative on [0, 1], as prose() has it; empty
/// where it is not.
std::string note_on_sign(const Curve& curve);
/// The same of the segments of a spline, a line each and an empty one behind.
std::string notes_on_signs(const PhPath& path, Notation notation = Notation::unicode);

}  // namespace phrame
