#pragma once
#include "phrame/io/better_reading.hpp"

namespace phrame {

/// What `phrame check` shows.
struct CheckReport {
  std::string curve;  ///< its name
  GivenTable table;
  FrameCheckOptions options;
  FrameVerdict verdict;
  std::optional<BetterReading> better = std::nullopt;
};

/// The verdict and its reason in a line.
std::string summary(const CheckReport& report);
std::string to_text(const CheckReport& report);
std::string to_json(const CheckReport& report);  ///< check/1

}  // namespace phrame
