#pragma once
#include "phrame/export.hpp"
#include "phrame/ph/curve/path.hpp"
#include "phrame/ph/curve/rotation.hpp"

namespace phrame::inline v0 {

// Exact transformations: of the parameter, and of space about the origin.

/// t ↦ r(a + (b − a)·t): the part from a to b as a curve on [0, 1]; for a > b it runs backwards.
/// A and f are reparametrised and f gets the factor b − a. Throws DomainError for a = b.
PHRAME_API Curve segment(const Curve& curve, const Rational& a, const Rational& b);
/// t ↦ r(1 − t). The new f is −f(1 − t): e₁ is that of the curve, not its opposite.
PHRAME_API Curve reversed(const Curve& curve);

/// r ↦ r + v.
PHRAME_API Curve translated(const Curve& curve, const Vector<Rational>& v);
/// r ↦ c·r, through f. Throws DomainError for c = 0.
PHRAME_API Curve scaled(const Curve& curve, const Rational& c);
/// r ↦ U r U*: the rotation that U means and a scaling by |U|² (scaled(…, 1/|U|²) undoes that).
/// A ↦ U·A: h, σ and g get the factor |U|². Throws DomainError for U = 0.
PHRAME_API Curve rotated(const Curve& curve, const RationalQuaternion& u);

/// @{ The same of every segment of a path, which goes on through its joints as before; what is PH
/// is PH. Of a segment(path, a, b) a and b are in [0, end], but where the path goes_on(), else
/// DomainError is thrown: of its segments the first and the last may be parts, each with a
/// parameter of its own in [0, 1].
PHRAME_API Path segment(const Path& path, const Rational& a, const Rational& b);
PHRAME_API Path reversed(const Path& path);
PHRAME_API Path translated(const Path& path, const Vector<Rational>& v);
PHRAME_API Path scaled(const Path& path, const Rational& c);
PHRAME_API Path rotated(const Path& path, const RationalQuaternion& u);
/// @}

/// All of a rational curve r = X/W, t ∈ ℝ ∪ {∞}, as a closed path of two segments:
///   t = 2s − 1, from −1 to 1, and t = 1/(1 − 2s), from 1 through ∞ back to −1,
/// s ∈ [0, 1]; where it has a cusp at one of these, r(ct) is taken for r(t), with the least whole c
/// of which it has none at ±c. Both have the derivative 2 where they meet, so that r′ is continuous
/// there. With
/// n = deg W and D = 1 − 2s the second is Dⁿ·X(1/D) over Dⁿ·W(1/D), and of a PH curve, deg A = m,
///   A ↦ Dᵐ·A(1/D), f ↦ 2·D²ⁿ⁻²⁻²ᵐ·f(1/D):
/// it is PH, and its Euler–Rodrigues frame goes on, also at the end, where (−1)ᵐ·A(−1) is for
/// A(−1). As 2n − 2 − 2m is even, f has an even number of changes of sign, and the path is closed;
/// others may have an odd number of cusps at which they turn back. Throws DomainError for several
/// segments, formulas and polynomial curves, and where a point is at infinity: W has a real zero,
/// or deg X > deg W. Cost: the real roots of W.
PHRAME_API Path whole_line(const Path& path);

/// r ↦ M·r + v.
struct PHRAME_API AffineMap {
  /// The columns of M.
  std::array<Vector<Rational>, 3> columns{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  Vector<Rational> shift{};  ///< v

  /// M·r + v.
  Vector<Rational> operator()(const Vector<Rational>& r) const;
  friend bool operator==(const AffineMap&, const AffineMap&) = default;
};
/// Of a matrix by rows: 9 numbers of M, 12 of M and v, or 16, the last row being 0, 0, 0, 1. Throws
/// DomainError for others.
PHRAME_API AffineMap affine_map(const std::vector<Rational>& rows);
/// First the one, then the other.
PHRAME_API AffineMap composed(const AffineMap& first, const AffineMap& second);

/// M as c·R with a rotation R over ℚ, c < 0 where it is a reflection, too.
struct Similarity {
  Rational factor;              ///< c
  RationalQuaternion rotation;  ///< P of R, of any length
};
/// No value where M is none.
PHRAME_API std::optional<Similarity> similarity(const AffineMap& map);

/// The path under the map. By a similarity what is PH stays PH, with its preimage, turned; by
/// others polynomial segments are PH where they are found to be. Throws DomainError where a segment
/// becomes a point, and as Path::append where tangents turn back or nothing tells.
PHRAME_API Path transformed(const Path& path, const AffineMap& map);

}  // namespace phrame
