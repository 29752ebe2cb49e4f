#pragma once
#include "phrame/cli/command.hpp"
#include "phrame/io/read/frame_csv.hpp"

namespace phrame::inline v0::cli {

/// A table of frames of somebody else, on the curve.
struct FramesOnCurve {
  GivenTable table;
  std::string parameters;  ///< what its t is taken for; empty where that is ours, or was asked for
};

/// Reads it; `reading` gets the parameters of the frames where the table has others than ours:
/// those of `by` or, without that, what is found out. A note says what is taken.
FramesOnCurve read_on_curve(const NamedPath& named, const std::string& bytes,
                            const std::string& file, const std::optional<ParameterKind>& by,
                            FrameReading& reading);

}  // namespace phrame::cli
