#pragma once
#include "phrame/io/read/given_segment.hpp"
#include "phrame/io/read/json_node.hpp"

namespace phrame::inline v0 {

/// A curve/1 object with `expressions`, formulas x, y and perhaps z of one variable, `from` and
/// `to`, its constant ends, and perhaps `variable`, its name. Where these are rational functions
/// and fractions, it is a rational curve. Throws InputError; Undecided as ExpressionCurve.
GivenSegment read_expression_segment(const JsonNode& node, const JsonNode& expressions);

}  // namespace phrame
