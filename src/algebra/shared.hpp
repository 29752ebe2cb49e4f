#pragma once
#include <memory>
#include <mutex>

namespace phrame::inline v0 {

/// What is known to some number of bits, and to more when more are asked for: kept for all copies,
/// whichever thread asks. To move one is to copy it.
template <class T>
class Refined {
 public:
  Refined() = default;
  Refined(const Refined&) = default;
  Refined& operator=(const Refined&) = default;
  ~Refined() = default;

  /// What is known to at least so many bits. Is less known, then refine(known) → T is called first,
  /// where `known` points to that, or is null; where it throws, nothing changes.
  template <class Refine>
  std::shared_ptr<const T> get(long bits, const Refine& refine) const {
    const std::lock_guard lock(state_->mutex);
    if (!state_->known || state_->bits < bits) {
      const T* known = state_->known.get();
      state_->known = std::make_shared<const T>(refine(known));
      state_->bits = bits;
    }
    return state_->known;
  }

  /// What is known, null before anything was asked for.
  std::shared_ptr<const T> known() const {
    const std::lock_guard lock(state_->mutex);
    return state_->known;
  }

 private:
  struct State {
    std::mutex mutex;
    long bits = 0;
    std::shared_ptr<const T> known;
  };
  std::shared_ptr<State> state_ = std::make_shared<State>();
};

/// A value that is made when it is first asked for: once for all copies, whichever thread asks. To
/// move one is to copy it.
template <class T>
class Lazy {
 public:
  /// make() → T is called if there is no value yet; where it throws, there is none after it either.
  template <class Make>
  const T& get(const Make& make) const {
    return *value_.get(0, [&](const T*) { return make(); });
  }

 private:
  Refined<T> value_;
};

}  // namespace phrame
