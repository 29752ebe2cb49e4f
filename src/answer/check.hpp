#pragma once
#include "phrame/ph/curve/named.hpp"
#include "phrame/ph/frame/frame_check.hpp"

namespace phrame {

/// How far are somebody's frames from the rotation-minimizing one?
struct CheckQuery {
  std::vector<GivenFrame> frames;  ///< at least one
  FrameCheckOptions options = {};
};

struct CheckAnswer {
  std::string name;  ///< of the path
  std::vector<GivenFrame> frames;
  FrameCheckOptions options;
  FrameVerdict verdict;
};

/// Throws as check_frames().
CheckAnswer answer(const NamedPath& path, const CheckQuery& query);

}  // namespace phrame
