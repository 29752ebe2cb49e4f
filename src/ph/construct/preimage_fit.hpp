#pragma once
#include <optional>
#include <vector>

#include "phrame/algebra/least_squares.hpp"
#include "phrame/ph/curve/quaternion.hpp"

namespace phrame::inline v0 {

// Guesses in doubles: the preimage whose curve comes closest to given points of a Bézier curve.
// Nothing is proved here; what is made of a guess is measured exactly.

/// Bernstein coefficients on [0, 1]: of A, m + 1 ≥ 1, and of f, at least one.
struct PreimageFit {
  std::vector<Quaternion<double>> preimage;
  std::vector<double> multiplier;
};

/// The curve from 0 that is found nearest to one with these control points after the first, which
/// is 0, and the Bernstein coefficients of whose r′ are given, too. They are to be of about the
/// size 1. f = 1, or f > 0 after t = 0 with max |f| in [1, 4). Of all A·e^{iφ}, which have the same
/// curve, it is the one where the greatest |α_k| or |β_k| is that of a positive real number; so the
/// A of a curve in the plane of x and y, or of x and z, is real or imaginary in its parts.
PreimageFit best_fit(const std::vector<Vector<double>>& hodograph,
                     const std::vector<Vector<double>>& points);

/// Which coefficients of A may be changed.
enum class FreePart {
  all,
  inner  ///< without the first and the last
};

/// The least change of these coefficients and of f, unless that is a constant, which moves the
/// control points after the first, to first order, by as much as is wanted, as nearly as can be
/// (least squares).
class FitStep {
 public:
  FitStep(const PreimageFit& fit, FreePart part);

  PreimageFit operator()(const std::vector<Vector<double>>& wanted) const;

 private:
  std::size_t preimage_size_;
  std::size_t multiplier_size_;
  std::size_t first_ = 0;  ///< of the free coefficients of A
  std::size_t count_ = 0;  ///< of them
  std::optional<LeastSquares> inverse_;
};

}  // namespace phrame
