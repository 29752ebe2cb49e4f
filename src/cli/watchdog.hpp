#pragma once
#include <optional>

namespace phrame::inline v0::cli {

/// While it lives, and until end_watch(), it ends the program after so many seconds, with a line on
/// stderr and status 4. There is one at a time.
class Watchdog {
 public:
  explicit Watchdog(std::optional<double> seconds);
  ~Watchdog();
  Watchdog(const Watchdog&) = delete;
  Watchdog& operator=(const Watchdog&) = delete;
};

/// Before anything is written: from now on the program ends by itself.
void end_watch();

}  // namespace phrame::cli
