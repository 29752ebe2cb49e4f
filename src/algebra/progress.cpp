#include "phrame/algebra/progress.hpp"

#include <atomic>

#include "phrame/algebra/time_limit.hpp"

namespace phrame::inline v0 {
namespace {

/// Of the stage that is heard.
struct HeardStage {
  std::atomic<bool> exists = false;
  std::atomic<const char*> what = nullptr;
  std::atomic<long> done = 0;
  std::atomic<long> all = 0;
};

HeardStage heard_stage;

}  // namespace

Stage::Stage(const char* what, std::size_t all) : is_heard_(!heard_stage.exists.exchange(true)) {
  if (!is_heard_) return;
  heard_stage.done = 0;
  heard_stage.all = static_cast<long>(all);
  heard_stage.what = what;
}

Stage::~Stage() {
  if (!is_heard_) return;
  heard_stage.what = nullptr;
  heard_stage.exists = false;
}

void Stage::advance() {
  require_time();
  if (is_heard_) heard_stage.done.fetch_add(1, std::memory_order_relaxed);
}

std::optional<Progress> current_progress() {
  const char* what = heard_stage.what;
  if (what == nullptr) return std::nullopt;
  return Progress{what, heard_stage.done, heard_stage.all};
}

}  // namespace phrame
