#include "phrame/cli/watchdog.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <stop_token>
#include <thread>

#include "phrame/cli/progress_line.hpp"

namespace phrame::inline v0::cli {
namespace {

void end_after(double seconds, const std::stop_token& over) {
  std::mutex mutex;
  std::unique_lock lock(mutex);
  std::condition_variable_any pause;
  if (pause.wait_for(lock, over, std::chrono::duration<double>(seconds),
                     [&over] { return over.stop_requested(); }))
    return;
  print_above_progress(fmt::format("phrame: undecided within --time-limit {} s", seconds));
  _exit(4);
}

/// Stopped and joined where another takes its place.
std::jthread& watch() {
  static std::jthread only;
  return only;
}

}  // namespace

Watchdog::Watchdog(std::optional<double> seconds) {
  if (seconds)
    watch() =
        std::jthread([limit = *seconds](const std::stop_token& over) { end_after(limit, over); });
}

Watchdog::~Watchdog() { end_watch(); }

void end_watch() { watch() = {}; }

}  // namespace phrame::cli
