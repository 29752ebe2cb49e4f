#pragma once
#include <vector>

#include "phrame/ph/curve/curve_series.hpp"

namespace phrame::inline v0 {

/// s(t)/S, the share of the length of a path that lies before t, for many t: in doubles, by Taylor
/// polynomials of |r′| with a bound of what they are off.
class LengthShare {
 public:
  /// Throws Undecided where |r′| is not told from 0, as where the path turns back in a cusp.
  explicit LengthShare(const CurveSeries& path);

  /// At t ∈ [0, 1] of a segment.
  double operator()(std::size_t segment, double t) const;
  double length() const { return length_; }  ///< S, to within error()·S
  double error() const { return error_; }    ///< of a share

 private:
  static constexpr long terms = 12;
  /// [from, next from) of one segment.
  struct Piece {
    double from;
    double middle;
    double before;                     ///< the length up to its middle
    std::vector<double> coefficients;  ///< of the length from there, in powers of t − middle
  };
  void add(const CurveSeries& path, std::size_t segment, double from, double to);

  std::vector<std::vector<Piece>> segments_;
  double length_ = 0;
  double error_ = 0;
};

}  // namespace phrame
