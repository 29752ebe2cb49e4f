#pragma once
#include <cstddef>
#include <functional>

#include "numbers.hpp"

namespace phrame::inline v0::python {

/// Work on numbers 0 … n − 1, which several threads do, without Python. It owns what it reads and
/// writes: where it is interrupted, nobody waits for it.
struct Job {
  std::size_t n = 0;
  std::size_t grain = 1;               ///< so many at a time
  std::function<void()> prepare = {};  ///< first, once; may be empty
  std::function<void(std::size_t from, std::size_t to)> work = {};
};

/// Does it on as many threads as phrame._threads says. Called with the GIL, which is released
/// meanwhile. Signals are looked for 20 times a second, and `progress`, unless it is None, is
/// called as progress(done, n): what these raise ends the work, as do the exceptions of the work.
void run(Job job, nb::handle progress);

}  // namespace phrame::python
