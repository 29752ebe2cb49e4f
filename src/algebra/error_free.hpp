#pragma once
#include <cfenv>
#include <cfloat>
#include <cmath>
#include <optional>

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

/// The unevaluated sum of two doubles.
struct DoubleDouble {
  double high = 0;
  double low = 0;
};

// Error-free transformations, in rounding to nearest and without overflow. What uses them
// is compiled with -fno-fast-math and -ffp-contract=off (CMakeLists.txt): no sum may be simplified,
// no product and sum fused.

/// a + b = high + low exactly, high = fl(a + b) [Knuth, The Art of Computer Programming 2, §4.2.2].
inline DoubleDouble two_sum(double a, double b) {
  const double sum = a + b;
  const double of_b = sum - a;
  return {sum, (a - (sum - of_b)) + (b - of_b)};
}

/// A factor as the sum of two halves of at most 26 bits each.
struct SplitFactor {
  double value;
  double high;
  double low;
};

/// For |x| < 2^996 [Veltkamp, Dekker].
inline SplitFactor split_factor(double x) {
  const double shifted = 134217729.0 * x;  // 2^27 + 1
  const double high = shifted - (shifted - x);
  return {x, high, x - high};
}

/// a·b = high + low, high = fl(a·b), exactly but for an error < 2^−1070 where a product of halves
/// underflows [Dekker, A floating-point technique for extending the available precision, Numer.
/// Math. 18 (1971)].
inline DoubleDouble two_product(const SplitFactor& a, const SplitFactor& b) {
  const double product = a.value * b.value;
  const double error = ((a.high * b.high - product) + a.high * b.low) + a.low * b.high;
  return {product, error + a.low * b.low};
}

/// A number within `error` of the sum of two doubles.
struct NearNumber {
  DoubleDouble value;  ///< |low| is at most about an ulp of high
  double error = 0;    ///< ≥ 0
};

// Sums and products up to about 2^−102 of the sum of the absolute values of their terms.

inline DoubleDouble operator+(const DoubleDouble& a, const DoubleDouble& b) {
  const DoubleDouble sum = two_sum(a.high, b.high);
  return {sum.high, sum.low + (a.low + b.low)};
}

inline DoubleDouble operator-(const DoubleDouble& a, const DoubleDouble& b) {
  return a + DoubleDouble{-b.high, -b.low};
}

inline DoubleDouble operator*(const DoubleDouble& a, const DoubleDouble& b) {
  const DoubleDouble product = two_product(split_factor(a.high), split_factor(b.high));
  return {product.high, product.low + (a.high * b.low + a.low * b.high)};
}

/// The double to which all numbers within `error` of high + low round; no value where there is none
/// [Ziv 1991]. Precondition: |low| is at most about an ulp of high.
inline std::optional<double> common_double(const DoubleDouble& x, double error) {
  // The last term and the last factor cover the rounding of these sums and of those below.
  const double radius = (error + std::abs(x.low) * 0x1p-50) * (1 + 0x1p-50);
  const double least = x.high + (x.low - radius);
  if (least == x.high + (x.low + radius)) return least;
  return std::nullopt;
}

/// The same for a NearNumber.
inline std::optional<double> common_double(const NearNumber& x) {
  return common_double(x.value, x.error);
}

}  // namespace phrame
