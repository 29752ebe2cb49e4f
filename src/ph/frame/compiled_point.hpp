#pragma once
#include <vector>

#include "phrame/algebra/near_numbers.hpp"
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
  /// The same at many t, whose high parts are inside: x, y and z of all of them, and the numbers of
  /// those that have none.
  std::vector<std::size_t> rounded(const NearNumbers& t, Vector<std::vector<double>>& r) const;

 private:
  std::vector<PiecewisePolynomial> polynomials_;  ///< of x, y and z
};

}  // namespace phrame
