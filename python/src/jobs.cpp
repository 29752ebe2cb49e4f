#include "jobs.hpp"

#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

namespace phrame::inline v0::python {
namespace {

/// Threads that live as long as the process: what FLINT keeps for each of them is kept once. Of
/// those that are idle the one that worked last goes on, since it has that already.
class Pool {
 public:
  /// Of this process: a child after fork() has none of its parent's threads.
  static Pool& instance() {
    static std::mutex& lock = *new std::mutex();
    static Pool* pool = nullptr;  // never destroyed, since its threads do not end
    const std::lock_guard guard(lock);
    if (pool == nullptr || pool->process_ != getpid()) pool = new Pool();
    return *pool;
  }

  /// So many threads at once, from now on; those that are there stay.
  void limit_to(std::size_t threads) {
    const std::lock_guard guard(lock_);
    limit_ = threads;
  }

  /// So many threads are still busy with what nobody waits for: others take their places.
  void replace(std::size_t threads) {
    const std::lock_guard guard(lock_);
    left_ += threads;
  }

  /// What is urgent is not kept waiting by long jobs.
  void submit(std::function<void()> task, bool is_urgent = false) {
    const std::lock_guard guard(lock_);
    if (is_urgent)
      tasks_.push_front(std::move(task));
    else
      tasks_.push_back(std::move(task));
    if (idle_.size() + called_ < tasks_.size() && (threads_ < limit_ + left_ || is_urgent)) {
      std::thread([this] { serve(); }).detach();
      ++threads_;
    }
    if (idle_.empty()) return;
    Idle& last = *idle_.back();
    idle_.pop_back();
    ++called_;
    last.is_called = true;
    last.ready.notify_one();
  }

 private:
  /// A thread that waits for a task.
  struct Idle {
    std::condition_variable ready;
    bool is_called = false;
  };

  void serve() {
    prepare_thread();
    Idle self;
    std::unique_lock guard(lock_);
    while (true) {
      while (tasks_.empty()) {
        idle_.push_back(&self);
        self.ready.wait(guard, [&self] { return self.is_called; });
        self.is_called = false;
        --called_;
      }
      const auto task = std::move(tasks_.front());
      tasks_.pop_front();
      guard.unlock();
      task();
      guard.lock();
    }
  }

  const pid_t process_ = getpid();
  std::mutex lock_;
  std::size_t limit_ = 1;
  std::size_t left_ = 0;
  std::deque<std::function<void()>> tasks_;
  std::size_t threads_ = 0;
  std::vector<Idle*> idle_;
  std::size_t called_ = 0;  ///< that were idle, and have not yet looked for their task
};

/// That of phrame.set_time_limit().
std::optional<double> time_limit() {
  return nb::cast<std::optional<double>>(imported("phrame._threads", "time_limit")());
}

/// A TimeLimit where there is one.
class Timed {
 public:
  explicit Timed(const std::optional<double>& seconds) {
    if (seconds) limit_.emplace(*seconds);
  }

 private:
  std::optional<TimeLimit> limit_;
};

/// What the threads of one job share; the last of them that is left frees it.
struct State {
  Job job;
  std::atomic<std::size_t> next{0};
  std::atomic<std::size_t> done{0};
  std::atomic<bool> is_cancelled{false};
  std::mutex lock;
  std::condition_variable ended;
  std::size_t active;  ///< threads that have not ended
  std::exception_ptr failure;
  const std::optional<double> seconds = time_limit();

  State(Job what, std::size_t threads) : job(std::move(what)), active(threads) {}

  template <class F>
  void guarded(const F& f) {
    try {
      f();
    } catch (...) {
      const std::lock_guard guard(lock);
      if (!failure) failure = std::current_exception();
      is_cancelled = true;
    }
  }

  void work() {
    guarded([&] {
      const Timed timed(seconds);
      while (!is_cancelled) {
        const std::size_t from = next.fetch_add(job.grain);
        if (from >= job.n) return;
        const std::size_t to = std::min(job.n, from + job.grain);
        job.work(from, to);
        done += to - from;
      }
    });
    end();
  }

  void end() {
    const std::lock_guard guard(lock);
    if (--active == 0) ended.notify_all();
  }
};

/// Waits for the job, and looks for signals meanwhile.
void await(const std::shared_ptr<State>& state, nb::handle progress) {
  bool has_ended = false;
  while (!has_ended) {
    {
      const nb::gil_scoped_release released;
      std::unique_lock guard(state->lock);
      has_ended = state->ended.wait_for(guard, std::chrono::milliseconds(50),
                                        [&] { return state->active == 0; });
    }
    try {
      if (PyErr_CheckSignals() != 0) throw nb::python_error();
      if (!progress.is_none()) progress(state->done.load(), state->job.n);
    } catch (...) {
      state->is_cancelled = true;
      const std::lock_guard guard(state->lock);
      Pool::instance().replace(state->active);
      throw;
    }
  }
  if (state->failure) std::rethrow_exception(state->failure);
}

/// Signals come to no other.
bool is_main_thread() {
  const nb::object main = imported("threading", "main_thread")();
  return nb::cast<unsigned long>(main.attr("ident")) == PyThread_get_thread_ident();
}

}  // namespace

void run_apart(std::function<void()> work) {
  if (!is_main_thread()) {
    const std::optional<double> seconds = time_limit();
    const nb::gil_scoped_release released;
    const Timed timed(seconds);
    work();
    return;
  }
  const auto state = std::make_shared<State>(
      Job{.n = 1, .work = [work = std::move(work)](std::size_t, std::size_t) { work(); }}, 1);
  Pool::instance().submit([state] { state->work(); }, true);
  await(state, nb::none());
}

void run(Job job, nb::handle progress) {
  if (!progress.is_none() && PyCallable_Check(progress.ptr()) == 0)
    refuse_type("progress", "a callable", progress);
  const std::size_t parts = (job.n + job.grain - 1) / job.grain;
  const auto limit = nb::cast<std::size_t>(imported("phrame._threads", "limit")());
  Pool::instance().limit_to(limit);
  const std::size_t threads = std::max<std::size_t>(1, std::min(limit, parts));
  const auto state = std::make_shared<State>(std::move(job), threads);
  Pool::instance().submit([state, threads] {
    if (state->job.prepare) {
      const Timed timed(state->seconds);
      state->guarded(state->job.prepare);
    }
    for (std::size_t k = 1; k < threads; ++k) Pool::instance().submit([state] { state->work(); });
    state->work();
  });
  await(state, progress);
}

}  // namespace phrame::python
