#pragma once
#include <string>
#include <utility>
#include <vector>

namespace phrame::inline v0 {

enum class FrameWeight;
enum class OffsetJoin;
enum class ParameterKind;
enum class QuinticSelection;
enum class Reference;

// What choices are called, on the command line and in files.

/// Names with what they are names of.
template <class T>
using Names = std::vector<std::pair<std::string, T>>;

const Names<Reference>& reference_names();            ///< "erf", "frenet", "up"
const Names<QuinticSelection>& quintic_selections();  ///< "auto", "minimal", …
const Names<FrameWeight>& frame_weights();            ///< "one", "torsion-curvature", "speed"

const Names<OffsetJoin>& offset_joins();        ///< "round", "mitre", "open"
const Names<ParameterKind>& parameter_kinds();  ///< "t", "native", "unit", "arc-length", "fraction"

/// @{ Of each the name in its list.
const std::string& name_of(Reference reference);
const std::string& name_of(QuinticSelection selection);
const std::string& name_of(FrameWeight weight);
const std::string& name_of(OffsetJoin join);
const std::string& name_of(ParameterKind kind);
/// @}
/// The same as a column of tables and a key of JSON: that of arc lengths is "s".
std::string column_of(ParameterKind kind);

}  // namespace phrame
