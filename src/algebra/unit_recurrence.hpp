#pragma once
#include <vector>

#include "phrame/algebra/unit_number.hpp"
#include "phrame/algebra/unit_quotient.hpp"

namespace phrame::inline v0 {

// The two recurrences of unit_series(), in fixed point: all is in units of 2^−Q, and every step
// counts what it leaves over in the equation that it is made from. Number is Integer, or TwoWords
// where all numbers are seen to fit: of coefficients with `most_bits` behind the point, between 64
// and 127, and of a series with some bits less, as unit_series() sees to it.

/// pₖ/divisor, as numbers that are multiplied with those of a series: with so many bits behind the
/// point as these need, rounded down; or pₖ themselves, where these are shorter: then products are
/// those of a long and a short number.
template <class Number>
class FixedCoefficients {
 public:
  FixedCoefficients(const IntegerPolynomial& p, const Integer& divisor, long most_bits);

  /// For products with numbers of `needed` bits. Of TwoWords nothing is gained by it, nor done.
  void choose(long needed);
  std::size_t size() const { return now_.size(); }
  const Number& operator[](std::size_t k) const { return now_[k]; }
  bool are_exact() const { return are_exact_; }
  long bits() const { return bits_; }  ///< behind the point, where they are rounded
  /// ⌊sum/n⌋ with the sum of products as it would be with pₖ/divisor.
  Number share(const ProductSum<Number>& sum, std::size_t n = 1) const;

 private:
  Integer quotient(Integer c, long bits) const;

  std::vector<Integer> exact_;  ///< pₖ, but for TwoWords
  std::vector<Number> now_;
  Integer divisor_;
  long most_bits_;
  long bits_ = 0;  ///< 0 before the first choice
  bool are_exact_ = false;
};

/// The coefficients of a series.
template <class Number>
struct FixedSeries {
  std::vector<Number> c{};  ///< in units of 2^−Q
  std::size_t window;       ///< so many of the last ones are looked at
  long most = 0;            ///< none of these has more bits
  double left_over = 0;     ///< by the steps, in ‖…‖

  explicit FixedSeries(std::size_t looked_at) : window(looked_at) {}
  void push(Number x);
  /// A step has multiplied `count` of these coefficients with numbers of so many bits.
  void count_errors(const FixedCoefficients<Number>& coefficients, std::size_t count,
                    long bits_of_numbers);
};

/// w ≈ 1/√σ, σ = S/S(0), by n·wₙ = −Σ (n − i/2)·σᵢ·wₙ₋ᵢ, i ≥ 1. A step counts what is left over in
/// σ·w′ + σ′·w/2, over n: Σ (1 − i/2n)·σᵢ·wₙ₋ᵢ, i ≥ 0.
template <class Number>
class RootRecurrence {
 public:
  RootRecurrence(const UnitQuotient& f, long Q, long most_bits);

  const FixedSeries<Number>& w() const { return w_; }  ///< w₀ = 1 from the start
  void step();                                         ///< one coefficient more

 private:
  FixedCoefficients<Number> sigma_;
  FixedSeries<Number> w_;
};

/// y ≈ ν·w/δ, δ = D/D(0), ν = N/2ᵉ, by yₙ = Σ νⱼ·wₙ₋ⱼ − Σ δᵢ·yₙ₋ᵢ, i ≥ 1. A step counts what is
/// left over in ν·w − δ·y.
template <class Number>
class QuotientRecurrence {
 public:
  QuotientRecurrence(const UnitQuotient& f, long most_bits);

  const FixedSeries<Number>& y() const { return y_; }  ///< empty at the start
  /// One coefficient more. Precondition: w has as many by now.
  void step(const FixedSeries<Number>& w);

 private:
  FixedCoefficients<Number> nu_;
  FixedCoefficients<Number> delta_;
  FixedSeries<Number> y_;
};

}  // namespace phrame
