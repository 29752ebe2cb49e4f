#pragma once
#include <oneapi/tbb/task_scheduler_observer.h>

#include "phrame/algebra/out_of_memory.hpp"

namespace phrame::inline v0::cli {

/// While it lives, each thread that takes up work of TBB's has beforehand what it needs to say that
/// memory is short.
class PreparedThreads : public oneapi::tbb::task_scheduler_observer {
 public:
  PreparedThreads() { observe(true); }
  PreparedThreads(const PreparedThreads&) = delete;
  PreparedThreads& operator=(const PreparedThreads&) = delete;
  ~PreparedThreads() override { observe(false); }
  void on_scheduler_entry(bool is_worker) override {
    if (is_worker) prepare_thread();
  }
};

}  // namespace phrame::cli
