#pragma once
#include <cstddef>
#include <optional>
#include <string_view>

namespace phrame::inline v0 {

/// How far a loop is that may take long.
struct Progress {
  std::string_view what;  ///< "rows"
  long done;
  long all;
};

/// Says how far a loop is, for those who wait for it, as long as it lives. Of loops in loops, and
/// of several threads', the one that began first is heard. Costs a few nanoseconds a step.
class Stage {
 public:
  /// `what` is to live as long as the program: a literal.
  Stage(const char* what, std::size_t all);
  ~Stage();
  Stage(const Stage&) = delete;
  Stage& operator=(const Stage&) = delete;

  /// Throws Stopped where the time is over.
  void advance();

 private:
  bool is_heard_;
};

/// Of the loop that is heard, if there is one. May be asked by another thread.
std::optional<Progress> current_progress();

}  // namespace phrame
