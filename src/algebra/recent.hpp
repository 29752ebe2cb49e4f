#pragma once
#include <deque>
#include <memory>
#include <mutex>
#include <unordered_map>

namespace phrame::inline v0 {

/// Values by number that are made when they are first asked for, of which the last so many are
/// kept. Any thread may ask; two that ask for the same one at a time may both make it.
template <class T>
class Recent {
 public:
  explicit Recent(std::size_t most) : most_(most) {}

  /// The value k; make() → T is called if it is not kept.
  template <class Make>
  std::shared_ptr<const T> get(std::size_t k, const Make& make) {
    {
      const std::lock_guard lock(mutex_);
      if (const auto found = kept_.find(k); found != kept_.end()) return found->second;
    }
    auto made = std::make_shared<const T>(make());
    const std::lock_guard lock(mutex_);
    const auto [place, is_new] = kept_.emplace(k, std::move(made));
    const std::shared_ptr<const T> value = place->second;
    if (is_new) order_.push_back(k);
    if (order_.size() > most_) {
      kept_.erase(order_.front());
      order_.pop_front();
    }
    return value;
  }

 private:
  std::size_t most_;
  std::mutex mutex_;
  std::unordered_map<std::size_t, std::shared_ptr<const T>> kept_;
  std::deque<std::size_t> order_;  ///< of the kept ones, as they were made
};

}  // namespace phrame
