#pragma once
#include <memory>
#include <mutex>

namespace phrame::inline v0 {

/// A value that is known to some number of bits, and is refined when more are asked for. All copies
/// share it, in all threads. Moving one copies it.
template <class T>
class Refined {
 public:
  Refined() = default;
  Refined(const Refined&) = default;
  Refined& operator=(const Refined&) = default;
  ~Refined() = default;

  /// The value to at least that many bits. Where it is known to fewer, refine(known) → T is called,
  /// with a pointer to what is known, or null; if it throws, nothing changes.
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

  /// What is known so far; null before the first get().
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

/// A value that is made when it is first asked for, once for all copies in all threads. Moving
/// copies.
template <class T>
class Lazy {
 public:
  /// The value. If there is none yet, make() → T is called; if that throws, there is still none.
  template <class Make>
  const T& get(const Make& make) const {
    return *value_.get(0, [&](const T*) { return make(); });
  }

 private:
  Refined<T> value_;
};

}  // namespace phrame
