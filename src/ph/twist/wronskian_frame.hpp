#pragma once
#include "phrame/algebra/shared.hpp"
#include "phrame/ph/twist/best_in_plane.hpp"
#include "phrame/ph/twist/frame_weight.hpp"

namespace phrame::inline v0 {

/// The rational frame of [Peng, Pang, Pan 2023]: the Euler–Rodrigues frame of a curve turned by
/// 2·arg(b + ia), where a and b are polynomials of degree ≤ 2m for a preimage of degree m, with
///   ab′ − a′b = 2hσ (12), (24)  and  J = ∫₀¹ ρ(a² + b² − 2σ²)² dt (13) as small as possible:
/// it turns by −4hσ/(a² + b²), and a rotation-minimizing frame by −2h/σ. (In their (11), with
/// arctan(a/b), a has the other sign.) The best pair is found in each of the real planes of (24),
/// and these are compared, so that it is proved to be the best of all. Preimages count without
/// their real content. Copies share what was found; any thread may ask them.
class WronskianFrame {
 public:
  /// For preimages of degree 1 and 2. Throws DomainError for others, where h = 0, and where there
  /// is no such weight; Undecided where the best pair can't be told from another one.
  WronskianFrame(const Curve& curve, FrameWeight weight);

  const Curve& curve() const { return curve_; }              ///< with a primitive preimage
  const Polynomial& wronskian() const { return n_; }         ///< 2hσ
  const WronskianPlanes& planes() const { return planes_; }  ///< of (24)
  std::size_t best() const { return best_; }  ///< the index of the plane of the best pair
  /// Is the best pair of that plane as good as that of best(), as the curve is symmetric?
  bool is_tied(std::size_t plane) const { return tied_[plane]; }

  /// How many critical points J has in a plane, where they could be told apart.
  std::optional<long> critical_points(std::size_t plane) const;
  Real value(std::size_t plane) const;       ///< the least J in a plane
  Real multiplier(std::size_t plane) const;  ///< its λ
  /// x₁, x₂, x₃ with a² + b² = x₁a₀² + 2x₂a₀b₀ + x₃b₀², by the basis in normal form.
  std::array<Real, 3> form(std::size_t plane) const;

  /// @{ The coefficients of t⁰, t¹, … of the best pair: that of its bases which has w = b + ia real
  /// and positive at the origin of the planes.
  std::vector<Real> a() const;
  std::vector<Real> b() const;
  /// @}
  /// The same over ℚ: a parameter with so many bits behind the point, g and q of half as many, and
  /// more where that does not give half of them to all coefficients.
  RationalPair rounded(long bits) const;
  /// z where the best pair vanishes, a double zero of h. The frame is that of a/(t − z), b/(t − z),
  /// for 2·arg(b + ia) changes by 2π there; of the pair over ℚ, too, which vanishes there as well.
  std::optional<Rational> common_zero() const { return planes_.real[best_].zero; }

 private:
  std::shared_ptr<const std::vector<PlanePairs>> pairs(long bits) const;
  Real number(std::size_t plane, RealBall (*part)(const PlanePairs&)) const;
  std::vector<Real> coefficients(bool of_a) const;
  RationalPair rounded_by(long bits) const;
  void compare();

  Curve curve_;
  FrameWeight weight_;
  Polynomial n_;
  WronskianPlanes planes_;
  std::size_t best_ = 0;
  std::vector<bool> tied_;
  Refined<std::vector<PlanePairs>> pairs_;
};

}  // namespace phrame
