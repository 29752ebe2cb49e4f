#pragma once

namespace phrame::inline v0 {

/// The value that a function of FLINT or Arb writes to its first argument.
template <class T, class Function, class... Arguments>
T result_of(Function function, Arguments... others) {
  T result;
  function(result.raw(), others...);
  return result;
}

}  // namespace phrame
