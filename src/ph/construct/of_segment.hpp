#pragma once
#include <string>

#include "phrame/algebra/error.hpp"

namespace phrame::inline v0 {

/// What `make` makes of segment k; where it is Undecided, that names the segment.
template <class F>
auto of_segment(std::size_t k, const F& make) {
  try {
    return make();
  } catch (const Undecided& error) {
    throw Undecided("segment " + std::to_string(k + 1) + ": " + error.what());
  }
}

}  // namespace phrame
