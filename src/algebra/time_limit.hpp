#pragma once
#include <exception>

#include "phrame/export.hpp"

namespace phrame::inline v0 {

/// Thrown in a computation whose time is over, or by stop_all(). It is not derived from Error, so
/// that nothing takes it for an answer and tries another way.
class PHRAME_API Stopped : public std::exception {
 public:
  const char* what() const noexcept override;  ///< "the time is over"
};

/// Limits what this thread computes while the object lives to so many seconds, > 0. After that
/// Stopped is thrown, again and again: by require_time(), and, if throw_when_out_of_memory() was
/// called, where FLINT and Arb ask for memory, with the same loss as there. A thread has at most
/// one of these.
class PHRAME_API TimeLimit {
 public:
  explicit TimeLimit(double seconds);  ///< which begin now
  ~TimeLimit();
  TimeLimit(const TimeLimit&) = delete;
  TimeLimit& operator=(const TimeLimit&) = delete;
};

/// Makes all threads throw Stopped from now on. A signal handler may call it.
PHRAME_API void stop_all() noexcept;

/// Throws Stopped where the time is over, unless an exception is on its way. Costs a nanosecond.
PHRAME_API void require_time();

}  // namespace phrame
