#pragma once
#include <vector>

#include "phrame/algebra/rational.hpp"

namespace phrame::inline v0 {

/// An enclosure of a function f of z: |f(z) − Σ terms[k]·zᵏ/2ᴮ| ≤ radius/2ᴮ for −1 ≤ z ≤ 1. What is
/// 0 exactly has no terms and the radius 0.
struct TaylorModel {
  std::vector<Integer> terms;  ///< the last not 0
  Integer radius = 0;
  bool is_zero() const { return terms.empty() && radius == 0; }
  Integer constant() const { return terms.empty() ? Integer(0) : terms.front(); }  ///< terms[0]
};

/// The cosine and the sine of one function.
struct CosSinModels {
  TaylorModel cos;
  TaylorModel sin;
};

/// Arithmetic of Taylor models with at most `order` terms on the grid of 2^−bits, by the laws of
/// docs/certificate.md, which say what the integers are: the same wherever it is done. Throws
/// Undecided where a function is not proved to be defined, and beyond 2¹⁰⁰⁰.
class TaylorModels {
 public:
  /// order ≥ 2, bits ≥ 0.
  TaylorModels(long order, long bits) : order_(order), bits_(bits) {}

  long bits() const { return bits_; }  ///< B

  TaylorModel number(const Rational& x) const;  ///< x
  TaylorModel pi() const;                       ///< π
  TaylorModel variable() const;                 ///< z

  /// @{ The sum, difference and product.
  TaylorModel add(const TaylorModel& a, const TaylorModel& b) const;
  TaylorModel subtract(const TaylorModel& a, const TaylorModel& b) const;
  TaylorModel multiply(const TaylorModel& a, const TaylorModel& b) const;
  TaylorModel multiply(const Rational& x, const TaylorModel& a) const;
  /// @}
  /// A lower bound of all values times 2ᴮ. Throws Undecided where it is not positive, and says what
  /// that would be.
  Integer least(const TaylorModel& a, const char* what) const;
  /// @{ These functions of it.
  TaylorModel inverse(const TaylorModel& a) const;
  TaylorModel sqrt(const TaylorModel& a) const;
  TaylorModel exp(const TaylorModel& a) const;
  CosSinModels cos_sin(const TaylorModel& a) const;
  TaylorModel log(const TaylorModel& a) const;
  TaylorModel atan(const TaylorModel& a) const;
  /// @}

 private:
  TaylorModel checked(std::vector<Integer> terms, Integer radius) const;
  template <class Next>
  std::vector<Integer> series(bool is_constant, Integer first, const Next& next) const;
  template <class Function>
  Integer floor_of(const Rational& x, const Function& f) const;
  struct BySlope {
    std::vector<Integer> terms;
    Integer rest;
  };
  BySlope by_slope(const std::vector<Integer>& p, const std::vector<Integer>& w, long shift,
                   Integer first) const;

  long order_;
  long bits_;
};

}  // namespace phrame
