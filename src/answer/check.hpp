#pragma once
#include "phrame/export.hpp"
#include "phrame/ph/curve/path.hpp"
#include "phrame/ph/frame/frame_check.hpp"

namespace phrame::inline v0 {

/// Asks how far given frames are from the rotation-minimizing one.
struct CheckQuery {
  std::vector<GivenFrame> frames;  ///< at least one
  FrameCheckOptions options = {};  ///< what they are compared with, and the tolerance
};

/// The verdict on somebody's frames.
struct CheckAnswer {
  NamedPath path;                  ///< what the frames are of
  std::vector<GivenFrame> frames;  ///< as given
  FrameCheckOptions options;       ///< as asked
  FrameVerdict verdict;            ///< whether they pass, errors and findings
  /// v, given or chosen, where angles are to its frame.
  std::optional<Vector<Rational>> up = std::nullopt;
};

/// Throws as check_frames().
PHRAME_API CheckAnswer answer(const NamedPath& path, const CheckQuery& query);

}  // namespace phrame
