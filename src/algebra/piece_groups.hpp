#pragma once
#include <algorithm>
#include <cstring>
#include <span>

#include "phrame/algebra/piecewise_polynomial.hpp"
#include "phrame/algebra/wide.hpp"

namespace phrame::inline v0 {

/// Some of many numbers t, all of them in one piece.
struct PieceGroup {
  const PolynomialPiece& piece;
  std::span<const double> t;
  std::span<const std::size_t> at;  ///< t[k] is number at[k] of all

  /// y of those from t[k] on, in T = Wide<n>. Behind the last t it is repeated.
  template <class T, std::size_t count>
  [[gnu::always_inline]] void load(std::size_t k, std::array<T, count>& y) const {
    constexpr std::size_t n = count * lanes<T>;
    if (k + n <= t.size()) {
      std::memcpy(y.data(), t.data() + k, sizeof(y));
    } else {
      double last[n];
      for (std::size_t i = 0; i < n; ++i) last[i] = t[std::min(k + i, t.size() - 1)];
      std::memcpy(y.data(), last, sizeof(y));
    }
    for (T& each : y) each = (each - piece.center) * piece.scale;
  }
  /// What belongs to the same t, of numbers that belong to all.
  template <class T, std::size_t count>
  [[gnu::always_inline]] void load_others(std::size_t k, const std::vector<double>& all,
                                          std::array<T, count>& of_these) const {
    constexpr std::size_t n = count * lanes<T>;
    double found[n];
    for (std::size_t i = 0; i < n; ++i) found[i] = all[at[std::min(k + i, at.size() - 1)]];
    std::memcpy(of_these.data(), found, sizeof(of_these));
  }
};

/// Calls visit with all of t, in groups of some thousands at most. Neighbours stay together, so
/// that ascending t are in runs; where t are in disorder they are sorted by pieces. Cost: 1 to 4 ns
/// for each t, and in disorder as much as that for each piece, once. Precondition: from() ≤ t ≤
/// to().
void for_each_group(const PiecewisePolynomial& polynomials, std::span<const double> t,
                    const std::function<void(const PieceGroup&)>& visit);

}  // namespace phrame
