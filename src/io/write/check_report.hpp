#pragma once
#include <string>

#include "phrame/ph/frame/frame_check.hpp"

namespace phrame {

/// What `phrame check` shows.
struct CheckReport {
  /// How the table would better have been read.
  struct OtherReading {
    std::string options;
    bool passes;  ///< the frames pass by it; else their tangents are right, at least
  };
  std::string curve;  ///< its name
  std::vector<GivenFrame> frames;
  FrameCheckOptions options;
  FrameVerdict verdict;
  std::vector<std::string> columns = {};  ///< t, x, y, … where their number told what they are
  std::size_t skipped = 0;                ///< further columns there
  std::optional<OtherReading> better = std::nullopt;
};

/// The verdict and its reason in a line.
std::string summary(const CheckReport& report);
std::string to_text(const CheckReport& report);
std::string to_json(const CheckReport& report);  ///< check/1

}  // namespace phrame
