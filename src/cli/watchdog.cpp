#include "phrame/cli/watchdog.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <thread>

#include "phrame/cli/progress_line.hpp"

namespace phrame::cli {
namespace {

/// Waits in a thread of its own.
class Watch {
 public:
  explicit Watch(double seconds) : seconds_(seconds), thread_([this] { wait(); }) {}
  ~Watch() {
    {
      const std::lock_guard lock(mutex_);
      is_over_ = true;
    }
    over_.notify_one();
    thread_.join();
  }

 private:
  void wait() {
    std::unique_lock lock(mutex_);
    if (over_.wait_for(lock, std::chrono::duration<double>(seconds_), [this] { return is_over_; }))
      return;
    print_above_progress(fmt::format("phrame: undecided within --time-limit {} s", seconds_));
    _exit(4);
  }

  double seconds_;
  std::mutex mutex_;
  std::condition_variable over_;
  bool is_over_ = false;
  std::thread thread_;
};

std::optional<Watch>& watch() {
  static std::optional<Watch> only;
  return only;
}

}  // namespace

Watchdog::Watchdog(std::optional<double> seconds) {
  if (seconds) watch().emplace(*seconds);
}

Watchdog::~Watchdog() { end_watch(); }

void end_watch() { watch().reset(); }

}  // namespace phrame::cli
