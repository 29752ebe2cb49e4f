#pragma once
#include "phrame/ph/frame_check.hpp"

namespace phrame {

/// What `phrame check` shows.
struct CheckReport {
  std::string curve;  ///< its name
  std::vector<GivenFrame> frames;
  FrameCheckOptions options;
  FrameVerdict verdict;
};

/// The verdict and its reason in a line.
std::string summary(const CheckReport& report);
std::string to_text(const CheckReport& report);
std::string to_json(const CheckReport& report);  ///< check/1

}  // namespace phrame
