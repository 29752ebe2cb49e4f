#pragma once
#include <string>

#include "phrame/algebra/error.hpp"

namespace phrame::inline v0::test {

/// What is said by the exception that make() throws; "" where it throws none.
template <class Exception = InputError, class Make>
std::string refusal_of(const Make& make) {
  try {
    make();
  } catch (const Exception& error) {
    return error.what();
  }
  return "";
}

}  // namespace phrame::test
