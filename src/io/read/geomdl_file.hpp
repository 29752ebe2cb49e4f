#pragma once
#include "phrame/io/read/curve_file.hpp"
#include "phrame/io/read/given_segment.hpp"
#include "phrame/io/read/json_node.hpp"

namespace phrame::inline v0 {

/// Is it what geomdl (NURBS-Python) exports as JSON: an object with the key "shape"?
bool is_geomdl_file(const JsonNode& node);
/// The curves of such a file, one after the other, each of which is to begin where the one before
/// ends. Throws InputError for surfaces and volumes.
std::vector<GivenSegment> read_geomdl(const JsonNode& node, const CurveLimits& limits);

}  // namespace phrame
