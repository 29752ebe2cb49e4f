#include "phrame/cli/progress_line.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <mutex>
#include <optional>
#include <stop_token>
#include <thread>

#include "phrame/algebra/progress.hpp"

namespace phrame::inline v0::cli {
namespace {

using Clock = std::chrono::steady_clock;

std::string text_of(const std::string& command, const std::optional<Progress>& progress,
                    long seconds) {
  if (!progress) return fmt::format("{}: {} s", command, seconds);
  return fmt::format("{}: {} of {} {}, {} s", command, progress->done, progress->all,
                     progress->what, seconds);
}

/// Writes the line from a thread of its own.
class Writer {
 public:
  explicit Writer(std::string command)
      : command_(std::move(command)),
        thread_([this](const std::stop_token& over) { write(over); }) {}

  void print_above(const std::string& line) {
    const std::lock_guard lock(mutex_);
    clear();
    std::fprintf(stderr, "%s\n", line.c_str());
  }

 private:
  void clear() {
    if (is_shown_) std::fputs("\r\033[K", stderr);
    is_shown_ = false;
  }
  void write(const std::stop_token& over) {
    constexpr auto first = std::chrono::seconds(1);
    constexpr auto later = std::chrono::milliseconds(250);
    std::condition_variable_any wake;
    std::unique_lock lock(mutex_);
    for (auto pause = std::chrono::milliseconds(first);
         !wake.wait_for(lock, over, pause, [&over] { return over.stop_requested(); });
         pause = later) {
      const auto seconds =
          std::chrono::duration_cast<std::chrono::seconds>(Clock::now() - start_).count();
      std::fprintf(stderr, "\r\033[K%s", text_of(command_, current_progress(), seconds).c_str());
      is_shown_ = true;
    }
    clear();
  }

  std::string command_;
  Clock::time_point start_ = Clock::now();
  std::mutex mutex_;
  bool is_shown_ = false;
  std::jthread thread_;  ///< the last member: it is stopped and joined before the others go
};

std::optional<Writer>& writer() {
  static std::optional<Writer> only;
  return only;
}

}  // namespace

ProgressLine::ProgressLine(std::string command) {
  if (isatty(STDERR_FILENO) != 0) writer().emplace(std::move(command));
}

ProgressLine::~ProgressLine() { end_progress(); }

void print_above_progress(const std::string& line) {
  if (writer())
    writer()->print_above(line);
  else
    std::fprintf(stderr, "%s\n", line.c_str());
}

void end_progress() { writer().reset(); }

}  // namespace phrame::cli
