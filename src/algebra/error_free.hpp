#pragma once
#include <cfenv>
#include <cfloat>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

namespace phrame::inline v0 {

static_assert(FLT_EVAL_METHOD >= 0 && FLT_EVAL_METHOD != 2 && FLT_EVAL_METHOD <= 64,
              "doubles are computed with more digits");

/// While it lives, doubles are rounded to nearest in this thread, whatever was set before.
class RoundingToNearest {
 public:
  RoundingToNearest() : before_(std::fegetround()) {
    if (before_ != FE_TONEAREST) std::fesetround(FE_TONEAREST);
  }
  ~RoundingToNearest() {
    if (before_ != FE_TONEAREST) std::fesetround(before_);
  }
  RoundingToNearest(const RoundingToNearest&) = delete;
  RoundingToNearest& operator=(const RoundingToNearest&) = delete;

 private:
  int before_;
};

/// compute(), by a call across which the compiler moves no arithmetic.
template <class Compute>
[[gnu::noinline]] auto computed_apart(const Compute& compute) {
  return compute();
}

/// compute() with doubles rounded to nearest. Costs a nanosecond or two where they are already.
template <class Compute>
auto rounding_to_nearest(const Compute& compute) {
  if (std::fegetround() == FE_TONEAREST) return compute();
  const RoundingToNearest mode;
  return computed_apart(compute);
}

/// The unevaluated sum of two numbers T.
template <class T>
struct SumOfTwo {
  T high{};
  T low{};
};
using DoubleDouble = SumOfTwo<double>;

// Error-free transformations, in rounding to nearest and without overflow. What uses them
// is compiled with -fno-fast-math and -ffp-contract=off (CMakeLists.txt): no sum may be simplified,
// no product and sum fused. T is double, or Wide<n>: n doubles at once (wide.hpp), for which all
// that is called has to be inlined, as only then it is compiled for processors that have these.

/// a + b = high + low exactly, high = fl(a + b) [Knuth, The Art of Computer Programming 2, §4.2.2].
template <class T>
[[gnu::always_inline]] inline SumOfTwo<T> two_sum(const T& a, const T& b) {
  const T sum = a + b;
  const T of_b = sum - a;
  return {sum, (a - (sum - of_b)) + (b - of_b)};
}

/// The same number, the low part at most half an ulp of the high one.
template <class T>
[[gnu::always_inline]] inline SumOfTwo<T> normalized(const SumOfTwo<T>& x) {
  return two_sum(x.high, x.low);
}

/// A factor as the sum of two halves of at most 26 bits each.
template <class T>
struct SplitFactor {
  T value;
  T high;
  T low;
};

/// For |x| < 2^996 [Veltkamp, Dekker].
template <class T>
[[gnu::always_inline]] inline SplitFactor<T> split_factor(const T& x) {
  const T shifted = 134217729.0 * x;  // 2^27 + 1
  const T high = shifted - (shifted - x);
  return {x, high, x - high};
}

/// a·b − product in each of n > 2 doubles at once: processors that have so many fuse these two.
template <class T, std::size_t... k>
[[gnu::always_inline]] inline SumOfTwo<T> fused_product(const T& a, const T& b,
                                                        std::index_sequence<k...>) {
  const T product = a * b;
  return {product, T{__builtin_fma(a[k], b[k], -product[k])...}};
}

/// a·b = high + low, high = fl(a·b), exactly but for an error < 2^−1070 where a product of halves
/// underflows [Dekker, A floating-point technique for extending the available precision, Numer.
/// Math. 18 (1971)].
template <class T>
[[gnu::always_inline]] inline SumOfTwo<T> two_product(const SplitFactor<T>& a,
                                                      const SplitFactor<T>& b) {
  constexpr std::size_t n = sizeof(T) / sizeof(double);
  if constexpr (n > 2) {
    return fused_product(a.value, b.value, std::make_index_sequence<n>());
  } else {
    const T product = a.value * b.value;
    const T error = ((a.high * b.high - product) + a.high * b.low) + a.low * b.high;
    return {product, error + a.low * b.low};
  }
}

/// A number within `error` of the sum of two doubles.
struct NearNumber {
  DoubleDouble value;  ///< |low| is at most about an ulp of high
  double error = 0;    ///< ≥ 0
};

// Sums and products up to about 2^−102 of the sum of the absolute values of their terms.

template <class T>
[[gnu::always_inline]] inline SumOfTwo<T> operator+(const SumOfTwo<T>& a, const SumOfTwo<T>& b) {
  const SumOfTwo<T> sum = two_sum(a.high, b.high);
  return {sum.high, sum.low + (a.low + b.low)};
}

template <class T>
[[gnu::always_inline]] inline SumOfTwo<T> operator-(const SumOfTwo<T>& a, const SumOfTwo<T>& b) {
  return a + SumOfTwo<T>{-b.high, -b.low};
}

template <class T>
[[gnu::always_inline]] inline SumOfTwo<T> operator*(const SumOfTwo<T>& a, const SumOfTwo<T>& b) {
  const SumOfTwo<T> product = two_product(split_factor(a.high), split_factor(b.high));
  return {product.high, product.low + (a.high * b.low + a.low * b.high)};
}

/// x + x, exactly.
template <class T>
[[gnu::always_inline]] inline SumOfTwo<T> twice(const SumOfTwo<T>& x) {
  return {x.high + x.high, x.low + x.low};
}

/// The doubles that high + low − error and high + low + error round to, or beyond them: where they
/// are one, all between them round to it [Ziv 1991]. Precondition: |low| is at most about an ulp of
/// high.
template <class T>
struct RoundedBounds {
  T least;
  T most;
};
template <class T>
[[gnu::always_inline]] inline RoundedBounds<T> rounded_bounds(const SumOfTwo<T>& x,
                                                              const T& error) {
  // The last term and the last factor cover the rounding of these sums and of those below.
  const T radius = (error + (x.low < 0.0 ? -x.low : x.low) * 0x1p-50) * (1 + 0x1p-50);
  return {x.high + (x.low - radius), x.high + (x.low + radius)};
}

/// The double to which all numbers within `error` of high + low round; no value where there is
/// none.
inline std::optional<double> common_double(const DoubleDouble& x, double error) {
  const auto [least, most] = rounded_bounds(x, error);
  if (least == most) return least;
  return std::nullopt;
}

/// The same for a NearNumber.
inline std::optional<double> common_double(const NearNumber& x) {
  return common_double(x.value, x.error);
}

}  // namespace phrame
