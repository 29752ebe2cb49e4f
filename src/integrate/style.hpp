#pragma once

namespace phrame {

/// How an antiderivative is written.
enum class Style {
  logarithms,  ///< as it is: sums of logarithms over roots
  textbook,    ///< in real functions, as far as that is short
  real,
  radicals,
};

}  // namespace phrame
