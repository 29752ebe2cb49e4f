#pragma once
#include <vector>

#include "phrame/algebra/near_numbers.hpp"
#include "phrame/ph/along/path_length.hpp"

namespace phrame::inline v0 {

/// The arc length s of a path and its inverse for millions of numbers. Any thread may ask.
class CompiledLength {
 public:
  /// By polynomials as those of compiled_angle, s′ = |r′| being N/(D√S). Throws Undecided where
  /// they are not found, as along a segment on which f or p changes its sign.
  explicit CompiledLength(const Path& path);

  /// s from the start to many t, whose high parts are inside, as in rounded_values().
  std::vector<std::size_t> rounded(const NearNumbers& t, std::span<double> s) const;
  /// The t where it is s: Newton's method in doubles, one step with the value of s in twice as many
  /// bits, and the proof that s(t) takes both signs about that of what is left. No value next to
  /// the ends of pieces, and where s′ is nearly 0.
  std::optional<NearNumber> parameter(const NearNumber& s) const;

 private:
  PiecewisePolynomial polynomials_;
  std::vector<double> at_ends_;  ///< about s at the ends of the pieces
};

}  // namespace phrame
