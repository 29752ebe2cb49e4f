// A thread of its own counts ticks, so that to look for the time is to compare two numbers.
#include "phrame/algebra/time_limit.hpp"

#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <limits>
#include <thread>

namespace phrame::inline v0 {
namespace {

using Tick = std::int64_t;
constexpr Tick never = std::numeric_limits<Tick>::max() - 1;
constexpr std::chrono::milliseconds tick_length{10};

std::atomic<Tick> now = 0;
thread_local Tick last = never;

static_assert(std::atomic<Tick>::is_always_lock_free);

/// Of steady time, since a sleep may be longer than asked, and the same in a process that forked.
Tick current_tick() { return std::chrono::steady_clock::now().time_since_epoch() / tick_length; }

void count_ticks() {
  for (;;) {
    std::this_thread::sleep_for(tick_length);
    Tick before = now;
    if (before > never || !now.compare_exchange_strong(before, current_tick()))
      return;  // all is stopped
  }
}

}  // namespace

const char* Stopped::what() const noexcept { return "the time is over"; }

TimeLimit::TimeLimit(double seconds) {
  static std::atomic<pid_t> counting = 0;  // a process that forked has no such thread
  if (counting.exchange(getpid()) != getpid()) std::thread(count_ticks).detach();
  constexpr double most = 1e12;
  last = current_tick() + static_cast<Tick>(std::ceil(std::min(seconds, most) * 100));
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
