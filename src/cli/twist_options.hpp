#pragma once
#include "phrame/cli/command.hpp"
#include "phrame/ph/twist/twist_frame.hpp"

namespace phrame::inline v0::cli {

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

  /// Are there any about θ_i and θ_f?
  bool has_ends() const {
    return from || to || from_vector || to_vector || is_closed || turns != 0;
  }
  /// As minimal_twist() has them. Throws InputError where one is given twice, or by a vector along
  /// the tangent, and DomainError for --closed of a path that is not.
  std::pair<FrameStart, std::optional<FrameStart>> ends(const Path& path) const;
  /// Throws InputError for a point that is not on the spline, too.
  Subdivision subdivision(const NamedPath& named, ParameterKind by) const;
  /// For results with so many digits.
  RationalTwistOptions rotation(long digits) const;
};

}  // namespace phrame::cli
