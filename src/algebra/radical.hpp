#pragma once
#include <optional>

#include "phrame/algebra/ball.hpp"
#include "phrame/export.hpp"

namespace phrame::inline v0 {

/// A number written with rational numbers, i, + − · /, √ and ∛, both principal:
///   √x = exp(log(x)/2),  ∛x = exp(log(x)/3),  −π < Im log ≤ π,  √0 = ∛0 = 0.
/// So ∛x is the real one for x > 0, and ∛(−8) = 1 + i√3.
///
/// It is kept as a list of steps, in which each uses only earlier ones and no two are equal: what
/// occurs several times is computed and enclosed once. All sums are linear combinations of steps
/// with rational coefficients, like terms collected. Beyond that and i² = −1, √x·√x = x nothing is
/// simplified: == compares the steps, and different radicals may be the same number.
class PHRAME_API Radical {
 public:
  /// What a step does.
  enum class Kind { imaginary_unit, product, quotient, square_root, cube_root };

  /// factor · step.
  struct Term {
    Rational factor;   ///< not 0
    std::size_t step;  ///< its number in steps()
    friend bool operator==(const Term&, const Term&) = default;
  };
  /// constant + Σ factor · step, by ascending steps.
  struct Sum {
    Rational constant;        ///< the rational part
    std::vector<Term> terms;  ///< each with another step
    friend bool operator==(const Sum&, const Sum&) = default;
  };
  /// One step: a number made from the numbers of earlier steps.
  struct Step {
    Kind kind = Kind::imaginary_unit;  ///< what is done with left and right
    Sum left = {};                     ///< the first factor, the dividend or the radicand
    Sum right = {};                    ///< the second factor or the divisor
    friend bool operator==(const Step&, const Step&) = default;
  };

  /// @{ A rational number.
  Radical(const Rational& r = 0) : value_{r, {}} {}  // NOLINT(google-explicit-constructor)
  Radical(long r) : Radical(Rational(r)) {}          // NOLINT(google-explicit-constructor)
  /// @}
  static Radical imaginary_unit();  ///< i

  /// The steps in the order in which they are computed.
  const std::vector<Step>& steps() const { return steps_; }
  const Sum& value() const { return value_; }  ///< the number, a sum of steps
  /// The number, where it is written without any step.
  std::optional<Rational> rational() const;

  /// The sum, like terms collected.
  friend PHRAME_API Radical operator+(const Radical& a, const Radical& b);
  /// The product, simplified by i² = −1 and √x·√x = x.
  friend PHRAME_API Radical operator*(const Radical& a, const Radical& b);
  /// Throws DomainError for b = 0, if it is written as 0.
  friend PHRAME_API Radical operator/(const Radical& a, const Radical& b);
  /// @{ As −1·a and a + −b.
  friend Radical operator-(const Radical& a) { return a * Rational(-1); }
  friend Radical operator-(const Radical& a, const Radical& b) { return a + -b; }
  /// @}
  /// @{ Powers are taken out of rational radicands as far as they are found (split_square):
  /// √12 = 2√3, √(−1/2) = i√2/2, ∛(16/27) = 2∛2/3.
  friend PHRAME_API Radical sqrt(const Radical& a);
  friend PHRAME_API Radical cbrt(const Radical& a);
  /// @}

  /// Are they written alike, whatever the order of the steps?
  friend PHRAME_API bool operator==(const Radical& a, const Radical& b);

 private:
  static Radical combination(const std::vector<Step>& steps, const Sum& value);
  static Radical of_step(std::vector<Step> steps, Step step);

  std::vector<Step> steps_;
  Sum value_;
};

/// p(x), by Horner's rule.
PHRAME_API Radical evaluate(const Polynomial& p, const Radical& x);

/// A ball around x with a radius ≤ 2^−bits · max(1, |x|) in both parts. Throws Undecided where
/// 64·bits + 65536 bits of precision are not enough: where a divisor is 0 without being written so,
/// or where a radicand that is not seen to be real lies on the cut of √ and ∛, the negative axis.
PHRAME_API ComplexBall enclose(const Radical& x, long bits);

}  // namespace phrame
