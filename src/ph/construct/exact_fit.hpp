#pragma once
#include "phrame/ph/construct/bezier_points.hpp"
#include "phrame/ph/construct/preimage_fit.hpp"
#include "phrame/ph/curve/scale.hpp"

namespace phrame::inline v0 {

// From a fit in doubles to an exact one, of which the distance is known exactly.

/// Bernstein coefficients on [0, 1]: of A, m + 1 ≥ 1, and of f, at least one.
struct ExactFit {
  std::vector<RationalQuaternion> preimage;
  std::vector<Rational> multiplier;
};

/// Is A or f zero, so that there is no curve?
bool is_point(const ExactFit& fit);
/// The curve f·A i A* from `start`. Throws DomainError for a point.
Curve curve_of(const ExactFit& fit, const Vector<Rational>& start);

/// e such that the points divided by 4ᵉ are about 1 from the first. They belong to an A divided by
/// 2ᵉ. Fits in doubles are of these, to keep off the ends of the doubles' range.
long scale_of(const BezierPoints& points);
std::vector<Vector<double>> scaled_down(const std::vector<Vector<Rational>>& vectors, long scale);
/// 2ᵉ·A, exactly.
ExactFit exact_fit(const PreimageFit& fit, long scale);

/// The greatest square of the distance of a control point of a curve, of degree ≥ its own, to that
/// of the curve of a fit from `start`.
Rational squared_distance(const ExactFit& fit, const Vector<Rational>& start,
                          const BezierPoints& points);

/// A fit of which the distance is known.
struct MeasuredFit {
  ExactFit fit;
  Rational squared_distance;
  long bits;  ///< free numbers of A are multiples of 2^(e − bits), those of f of 2^−bits
};

/// The fit with so many bits more that the distance to the points can get no less but by little:
/// Newton's steps with exact remainders and a derivative in doubles.
MeasuredFit refined(const ExactFit& from, const FitStep& step, FreePart part, long scale,
                    const Vector<Rational>& start, const BezierPoints& points);

/// Every free number to the nearest multiple.
ExactFit rounded(ExactFit fit, long scale, long bits, FreePart part);

}  // namespace phrame
