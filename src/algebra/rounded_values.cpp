#include "phrame/algebra/rounded_values.hpp"

#include <algorithm>

#include "phrame/algebra/piece_groups.hpp"

namespace phrame::inline v0 {
namespace {

/// The values of a group.
struct GroupValues {
  const PieceGroup& group;
  const DoubleShape& shape;
  std::span<double> values;
  std::vector<std::size_t>& untold;

  /// So many T go side by side, as each waits for its own results most of the time.
  static constexpr std::size_t count = 4;

  template <class T>
  [[gnu::always_inline]] void run() const {
    constexpr std::size_t n = count * lanes<T>;
    for (std::size_t k = 0; k < group.t.size(); k += n) {
      std::array<T, count> y;
      group.load(k, y);
      const auto found = compensated_values<1>(group.piece.coefficients.data(), shape, y);
      double least[n];
      double most[n];
      auto are_told = y[0] == y[0];
      for (std::size_t i = 0; i < count; ++i) {
        const T error = group.piece.error + group.piece.error_per_y * (y[i] < 0.0 ? -y[i] : y[i]);
        const RoundedBounds<T> bounds = rounded_bounds(found[i], error);
        std::memcpy(least + i * lanes<T>, &bounds.least, sizeof(T));
        std::memcpy(most + i * lanes<T>, &bounds.most, sizeof(T));
        are_told &= bounds.least == bounds.most;
      }
      const std::size_t some = std::min(n, group.t.size() - k);
      if (is_true(are_told))
        for (std::size_t i = 0; i < some; ++i) values[group.at[k + i]] = least[i];
      else
        store_told(k, least, most, some);
    }
  }

  [[gnu::noinline]] void store_told(std::size_t k, const double* least, const double* most,
                                    std::size_t some) const {
    for (std::size_t i = 0; i < some; ++i)
      if (least[i] == most[i])
        values[group.at[k + i]] = least[i];
      else
        untold.push_back(group.at[k + i]);
  }
};

}  // namespace

std::vector<std::size_t> rounded_values(const PiecewisePolynomial& polynomials,
                                        std::span<const double> t, std::span<double> values,
                                        std::size_t at_once) {
  std::vector<std::size_t> untold;
  for_each_group(polynomials, t, [&](const PieceGroup& group) {
    run_wide(at_once, GroupValues{group, polynomials.shape(), values, untold});
  });
  std::sort(untold.begin(), untold.end());
  return untold;
}

}  // namespace phrame
