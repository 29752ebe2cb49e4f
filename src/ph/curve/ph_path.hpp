#pragma once
#include <optional>

#include "phrame/algebra/gaussian_integer.hpp"
#include "phrame/export.hpp"
#include "phrame/ph/curve/curve.hpp"

namespace phrame::inline v0 {

/// A PH curve, or several joined to one, a spline. Segment k = 0, 1, …, each with its own [0, 1],
/// is the part [k, k + 1] of the parameter t; a curve by itself goes on for all t. At the joints
/// the position is continuous, exactly, and the unit tangent r′/|r′|, too, or there is a corner; at
/// a cusp there the tangent is its limit. At a corner frames are carried along the shorter great
/// circle between the tangents, by the least rotation that takes one to the other, which is what
/// the rotation-minimizing frame of every rounding of the corner tends to.
///
/// The segments are the curves given, but their preimages are chosen such that the Euler–Rodrigues
/// frame is continuous, too, or carried through corners like that, and that e₁ is r′/|r′| at the
/// start, just after a cusp there. A ↦ A·c with c ∈ ℚ(i), f ↦ f/|c|², leaves a curve alone and
/// turns that frame about the tangent by the constant 2·arg c; A ↦ A·j, f ↦ −f turns it over.
class PHRAME_API PhPath {
 public:
  /// One segment, to which others may be appended.
  PhPath(Curve first);  // NOLINT(google-explicit-constructor)

  /// The segments as they are, and those that begin with a corner. Precondition: f > 0 just after
  /// the start of the first, and each other is the continuation() of the one before.
  static PhPath of_continuous(std::vector<Curve> segments, std::vector<std::size_t> corners = {});

  /// Throws DomainError where the curve does not start where the spline ends, "it starts at
  /// (1, 0, 0), but the spline ends at (1, 2, 0)", and where its tangent there is the opposite one.
  /// Cost: the coefficients may get more digits from one segment to the next, by those of c.
  void append(const Curve& next);

  const std::vector<Curve>& segments() const { return segments_; }  ///< at least one
  /// The segments, ascending, at whose start the tangent breaks.
  const std::vector<std::size_t>& corners() const { return corners_; }
  /// Of the parameter.
  Rational end() const { return Rational(static_cast<long>(segments_.size())); }

  /// Is it a curve by itself?
  bool is_curve() const { return segments_.size() == 1; }

  /// Is its end its start?
  bool ends_meet() const;
  /// Where the spline is closed: z ∈ ℚ(i) such that the Euler–Rodrigues frame at the start is that
  /// at the end, carried through the corner where there is one, and turned by 2·arg z. No value for
  /// other splines, or where the tangent turns back there or e₁ comes back reversed (after an odd
  /// number of cusps at which the curve turns back).
  std::optional<GaussianRational> closing_turn() const;

  friend bool operator==(const PhPath&, const PhPath&) = default;

 private:
  PhPath() = default;

  std::vector<Curve> segments_;
  std::vector<std::size_t> corners_;
};

/// A curve behind another one.
struct Continuation {
  Curve curve;     ///< with the preimage that goes on with the Euler–Rodrigues frame
  bool is_corner;  ///< does the tangent break?
};
/// The curve `next` behind `last`. Throws as PhPath::append.
PHRAME_API Continuation continuation(const Curve& last, const Curve& next);

/// PhPath::closing_turn() of a path with these at its ends.
PHRAME_API std::optional<GaussianRational> closing_turn(const Curve& first, const Curve& last);

/// The curves, at least one, one after the other. Throws as PhPath::append.
PHRAME_API PhPath joined(const std::vector<Curve>& curves);

/// The segment that t is in, the later one at a joint, and the parameter there: in [0, 1], unless
/// the path is a curve.
struct PathParameter {
  std::size_t segment;  ///< 0, 1, …
  Rational t;           ///< the parameter of that segment
};
/// Throws DomainError for t outside [0, end()] of a spline.
PHRAME_API PathParameter locate(const PhPath& path, const Rational& t);
/// The same, and of a curve, too.
PHRAME_API PathParameter locate_inside(const PhPath& path, const Rational& t);
/// The same on a path of `count` ≥ 1 segments of any kind.
PHRAME_API PathParameter locate_inside(std::size_t count, const Rational& t);

/// The parameter along the path, segment + t.
PHRAME_API Rational parameter(const PathParameter& at);

}  // namespace phrame
