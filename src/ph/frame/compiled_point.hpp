#pragma once
#include <vector>

#include "phrame/algebra/piecewise_polynomial.hpp"
#include "phrame/ph/curve/path.hpp"

namespace phrame::inline v0 {

/// The position r for millions of parameters. Any thread may ask.
class CompiledPoints {
 public:
  /// Along a path, on [0, end]; each coordinate by polynomials as those of compiled_angle, r′ being
  /// N/D. Throws Undecided where these are not found.
  explicit CompiledPoints(const Path& path);
  /// Of a PH curve on [from, to].
  CompiledPoints(const Curve& curve, double from, double to);

  /// r(t), each coordinate correctly rounded, where the polynomials are enough for that.
  std::optional<Vector<double>> rounded(const NearNumber& t) const;

 private:
  std::vector<PiecewisePolynomial> polynomials_;  ///< of x, y and z
};

}  // namespace phrame
