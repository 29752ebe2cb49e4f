#pragma once
#include <vector>

#include "phrame/ph/construct/preimage_grid.hpp"
#include "phrame/ph/construct/rmf_septic.hpp"

namespace phrame::inline v0 {

/// What the families with one A₀ share: all but a septic's end stays while its end is looked for.
struct RmfStart {
  explicit RmfStart(const RationalQuaternion& start);

  RationalQuaternion a0;
  Integer denominator = 1;                 ///< of A₀
  IntegerQuaternion whole;                 ///< A₀ times that
  std::vector<IntegerQuaternion> lattice;  ///< a basis of the integers X with ω(A₀, X) = 0
};

/// All cubic A with given ends A₀, A₃ and h ≡ 0 (for A₀ and A₃ with ω(A₀, A₃) = 0 those that are
/// limits of others), exactly. A₁ and A₂ are in the plane V of the X with ω(A₀, X) = ω(A₃, X) = 0;
/// of integers in it there is a basis E₁, E₂, and
///   A₁ = m₁₁E₁ + m₁₂E₂, A₂ = m₂₁E₁ + m₂₂E₂ with det m = δ,
/// where 3δ is an integer times a power of 2. So coefficients of A₀, A₃ that are integers over 2ᵖ
/// have A₁, A₂ that are integers over 3·2^q, and nothing in a spline of such curves becomes longer.
class RmfFamily {
 public:
  /// Throws DomainError where the directions A i A* at the ends are the same: then h ≡ 0 are plane
  /// curves only, and there are others.
  RmfFamily(const RmfStart& start, const RationalQuaternion& a3);
  RmfFamily(const RationalQuaternion& a0, const RationalQuaternion& a3)
      : RmfFamily(RmfStart(a0), a3) {}

  /// The member next to one with these inner coefficients, nearly; the free numbers in m are
  /// multiples of 2^−bits.
  CubicPreimage<Rational> member(const RationalQuaternion& a1, const RationalQuaternion& a2,
                                 long bits) const;

 private:
  RationalQuaternion a0_;
  RationalQuaternion a3_;
  std::array<RationalQuaternion, 2> basis_;  ///< E₁, E₂, brought to the size of A₀ or A₃
  Rational determinant_;                     ///< δ
};

}  // namespace phrame
