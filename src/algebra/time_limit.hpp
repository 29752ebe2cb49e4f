#pragma once
#include <exception>

#include "phrame/export.hpp"

namespace phrame::inline v0 {

/// Thrown in a computation whose time is over, or when all are stopped. No Error, so that nobody
/// takes it for an answer and tries another way.
class PHRAME_API Stopped : public std::exception {
 public:
  const char* what() const noexcept override;
};

/// As long as it lives, what this thread computes may take so many seconds, > 0; then Stopped is
/// thrown, again and again. It is thrown where FLINT and Arb ask for memory, if
/// throw_when_out_of_memory() was called, with the same loss as there, and by require_time(). One
/// of these a thread.
class PHRAME_API TimeLimit {
 public:
  explicit TimeLimit(double seconds);
  ~TimeLimit();
  TimeLimit(const TimeLimit&) = delete;
  TimeLimit& operator=(const TimeLimit&) = delete;
};

/// Stops what all threads compute, for good; a handler of signals may call it.
PHRAME_API void stop_all() noexcept;

/// Throws Stopped where the time is over, unless an exception is on its way. Costs a nanosecond.
PHRAME_API void require_time();

}  // namespace phrame
