#include "phrame/cli/progress_line.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <mutex>
#include <optional>
#include <thread>

#include "phrame/algebra/progress.hpp"

namespace phrame::cli {
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
      : command_(std::move(command)), thread_([this] { write(); }) {}
  ~Writer() {
    {
      const std::lock_guard lock(mutex_);
      is_over_ = true;
    }
    over_.notify_one();
    thread_.join();
  }

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
  void write() {
    constexpr auto first = std::chrono::seconds(1);
    constexpr auto later = std::chrono::milliseconds(250);
    std::unique_lock lock(mutex_);
    for (auto pause = std::chrono::milliseconds(first);
         !over_.wait_for(lock, pause, [this] { return is_over_; }); pause = later) {
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
  std::condition_variable over_;
  bool is_over_ = false;
  bool is_shown_ = false;
  std::thread thread_;
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
