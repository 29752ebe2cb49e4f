#pragma once
#include <memory>
#include <optional>

#include "phrame/algebra/ball_series.hpp"
#include "phrame/algebra/shared.hpp"
#include "phrame/ph/curve/vector.hpp"

namespace phrame::inline v0 {

/// A function of z that is analytic on |z| ≤ 8, by the first coefficients of its Taylor series and
/// a bound of it on that disc. Then what is left out of the series, Σ_{k≥n} |c_k| rᵏ, is at most
/// bound·(r/8)ⁿ/(1 − r/8) for r < 8, by Cauchy's estimate.
struct DiscFunction {
  BallPolynomial series;  ///< n = length coefficients
  RealBall bound;         ///< |f(z)| is at most its greatest number where |z| ≤ 8
  long length = 0;        ///< n
  long bits = 0;          ///< of what is computed
};

/// The radius of the disc of a DiscFunction.
inline constexpr long outer_radius = 8;
/// @{ The greatest and the least radius of a disc on which products with roots and inverses are
/// bounded.
inline constexpr long inner_radius = 4;
inline constexpr long least_radius = 2;
/// @}

/// @{ The sum, difference and product.
DiscFunction operator+(const DiscFunction& f, const DiscFunction& g);
DiscFunction operator-(const DiscFunction& f, const DiscFunction& g);
DiscFunction operator*(const DiscFunction& f, const DiscFunction& g);
/// @}
/// @{ c, with the length and the bits of `like`.
DiscFunction constant_like(const DiscFunction& like, const Rational& c);
DiscFunction constant_like(const DiscFunction& like, const RealBall& c);
/// @}

/// Between which bounds is |f| on |z| ≤ radius? The lower one is ≤ 0 where f is not seen to have
/// no zero there.
struct SizeBounds {
  RealBall lower;        ///< |f| is at least the least number of it, where that is > 0
  RealBall upper;        ///< |f| is at most the greatest number of it
  bool may_gain = true;  ///< can `lower` be > 0 with more coefficients?
};
SizeBounds size_bounds(const DiscFunction& f, long radius = inner_radius);

/// A function with which several products are made: its size, and the series that they need, are
/// found once, for all copies.
class DiscFactor {
 public:
  DiscFactor(DiscFunction base)  // NOLINT(google-explicit-constructor)
      : base_(std::make_shared<const DiscFunction>(std::move(base))) {}

  const DiscFunction& base() const { return *base_; }  ///< the function
  /// size_bounds(base(), radius)
  const SizeBounds& size(long radius = inner_radius) const;
  /// p·baseᵏᐟ², k ≠ 0; for an odd k, base > 0 in the middle.
  BallPolynomial times_power(const BallPolynomial& p, int k) const;

 private:
  const BallPolynomial& root() const;
  const BallPolynomial& inverse_root() const;
  const BallPolynomial& inverse() const;

  std::shared_ptr<const DiscFunction> base_;
  std::array<Lazy<SizeBounds>, inner_radius - least_radius + 1> size_;
  Lazy<BallPolynomial> root_;
  Lazy<BallPolynomial> inverse_root_;
  Lazy<BallPolynomial> inverse_;
};

/// numerator · Π factorᵏᐟ², of factors that are ≥ 0 on the real axis.
template <class Function, class FactorBase>
struct ProductOfRoots {
  /// One factor.
  struct Factor {
    FactorBase base;     ///< ≥ 0 for real z
    int half_exponents;  ///< k
  };
  Function numerator;
  std::vector<Factor> factors;
};

/// Such a product around a point of a curve.
using DiscProduct = ProductOfRoots<DiscFunction, DiscFactor>;

/// A bound of it on |z| ≤ radius, as the greatest number of the ball, where its factors are seen
/// to have no zero there, so that it is analytic; else no value.
std::optional<RealBall> bound_on_inner_disc(const DiscProduct& product, long radius = inner_radius);
/// Where there is no such bound on |z| ≤ 4: can there be one with more coefficients?
bool may_gain(const DiscProduct& product);
/// A bound of it on |z| ≤ 4, wherever it is defined: factors with k > 0 may have zeros there.
std::optional<RealBall> bound_with_zeros(const DiscProduct& product);
/// The first coefficients of its Taylor series, as many as the numerator has.
BallPolynomial series(const DiscProduct& product);

}  // namespace phrame
