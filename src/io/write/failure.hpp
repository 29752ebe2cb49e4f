#pragma once
#include <string>

namespace phrame::inline v0 {

/// What the program says of an exception, and its exit status.
struct Failure {
  /// 2 bad input, 3 mathematically undefined, 4 undecided within the limits.
  int status;
  std::string message;
};

/// Of the exception that is being handled; any other than those of phrame is an "internal error",
/// 4. Precondition: called in a catch clause.
Failure current_failure();

}  // namespace phrame
