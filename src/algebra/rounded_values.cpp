#include "phrame/algebra/rounded_values.hpp"

#include <algorithm>

namespace phrame::inline v0 {
namespace {

/// The values of a group; of t it says what near_values() wants.
template <class Numbers>
struct GroupValues {
  const PieceGroup& group;
  const DoubleShape& shape;
  const Numbers& t;
  std::span<double> values;
  std::vector<std::size_t>& untold;

  /// So many T go side by side, as each waits for its own results most of the time.
  static constexpr std::size_t count = 4;

  template <class T>
  [[gnu::always_inline]] void run() const {
    constexpr std::size_t n = count * lanes<T>;
    for (std::size_t k = 0; k < group.t.size(); k += n) {
      const auto found = near_values<1, T, count>(group, shape, t, k);
      double least[n];
      double most[n];
      auto are_told = T{} == T{};
      for (std::size_t i = 0; i < count; ++i) {
        const RoundedBounds<T> bounds = rounded_bounds(found.values[i], found.errors[i]);
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

/// In groups by these doubles.
template <class Numbers>
std::vector<std::size_t> found_values(const PiecewisePolynomial& polynomials,
                                      std::span<const double> at, const Numbers& t,
                                      std::span<double> values, std::size_t at_once) {
  std::vector<std::size_t> untold;
  for_each_group(polynomials, at, [&](const PieceGroup& group) {
    run_wide(at_once, GroupValues<Numbers>{group, polynomials.shape(), t, values, untold});
  });
  std::sort(untold.begin(), untold.end());
  return untold;
}

}  // namespace

std::vector<std::size_t> rounded_values(const PiecewisePolynomial& polynomials,
                                        std::span<const double> t, std::span<double> values,
                                        std::size_t at_once) {
  return found_values(polynomials, t, OnlyDoubles(), values, at_once);
}

std::vector<std::size_t> rounded_values(const PiecewisePolynomial& polynomials,
                                        const NearNumbers& t, std::span<double> values,
                                        std::size_t at_once) {
  return found_values(polynomials, t.high, t, values, at_once);
}

}  // namespace phrame
