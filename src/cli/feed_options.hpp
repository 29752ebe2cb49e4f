#pragma once
#include "phrame/cli/command.hpp"
#include "phrame/ph/along/feedrate.hpp"

namespace phrame::inline v0::cli {

/// --feed, and limits of the acceleration.
struct FeedOptions {
  std::optional<std::string> feed;
  std::optional<std::string> normal;
  std::optional<std::string> tangential;
  std::optional<std::string> start_speed;
  std::optional<std::string> end_speed;

  /// `help` is that of --feed.
  void add_to(Command& command, const std::string& help);
  /// Precondition: `feed` is given.
  Feedrate feedrate() const;
};

}  // namespace phrame::cli
