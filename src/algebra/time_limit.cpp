// A thread of its own counts ticks, so that to look for the time is to compare two numbers.
#include "phrame/algebra/time_limit.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <limits>
#include <thread>

namespace phrame {
namespace {

using Tick = std::int64_t;
constexpr Tick never = std::numeric_limits<Tick>::max() - 1;
constexpr std::chrono::milliseconds tick_length{10};

std::atomic<Tick> now = 0;
thread_local Tick last = never;

static_assert(std::atomic<Tick>::is_always_lock_free);

/// Of steady time, since a sleep may be longer than asked.
void count_ticks() {
  const auto start = std::chrono::steady_clock::now();
  for (;;) {
    std::this_thread::sleep_for(tick_length);
    Tick before = now;
    const Tick after = (std::chrono::steady_clock::now() - start) / tick_length;
    if (before > never || !now.compare_exchange_strong(before, after)) return;  // all is stopped
  }
}

}  // namespace

const char* Stopped::what() const noexcept { return "the time is over"; }

TimeLimit::TimeLimit(double seconds) {
  static const bool is_counting = (std::thread(count_ticks).detach(), true);
  static_cast<void>(is_counting);
  constexpr double most = 1e12;
  last = now + static_cast<Tick>(std::ceil(std::min(seconds, most) * 100));
}

TimeLimit::~TimeLimit() { last = never; }

void stop_all() noexcept { now = never + 1; }

void require_time() {
  constexpr Tick pause = 10;  // what catches it has some time
  const Tick at = now.load(std::memory_order_relaxed);
  if (at <= last || std::uncaught_exceptions() > 0) return;
  if (at <= never) last = at + pause;
  throw Stopped();
}

}  // namespace phrame
