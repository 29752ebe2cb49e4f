#pragma once
#include "phrame/cli/command.hpp"
#include "phrame/ph/twist/twist_frame.hpp"

namespace phrame::cli {

/// What the frames of minimal twist of `mtf` and `frames` depend on.
struct TwistOptions {
  std::optional<std::string> from;
  std::optional<std::string> to;
  std::optional<std::string> from_vector;
  std::optional<std::string> to_vector;
  bool is_closed = false;
  long turns = 0;
  long degree = 2;
  bool has_free_ends = false;
  std::optional<std::string> subdivide;
  bool is_unproved = false;

  void add_to(Command& command);
  /// The options about θ_i and θ_f, and those about the rational frame.
  static std::vector<std::string> of_ends();
  static std::vector<std::string> of_rational_frame();

  /// θ_i and θ_f. Throws InputError where one is missing or given twice.
  std::pair<FrameAngle, FrameAngle> ends(const PhPath& path) const;
  /// The same to the frame of v, of a curve that is not PH.
  std::pair<FrameStart, FrameStart> ends(const PathAngle& angle) const;
  /// Throws InputError for a point that is not on the spline, too.
  Subdivision subdivision(const PhPath& path) const;
  /// For results with so many digits.
  RationalTwistOptions rotation(long digits) const;
};

}  // namespace phrame::cli
