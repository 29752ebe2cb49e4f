#pragma once
#include <functional>

#include "phrame/algebra/ball_series.hpp"
#include "phrame/ph/curve/path.hpp"

namespace phrame {

/// A curve of one or several segments, each on [0, 1], by Taylor series of its position: all that
/// is asked of a curve to find its crossings.
struct CurveSeries {
  std::size_t segments = 0;  ///< at least one
  /// r of a segment around t, as balls: where t is one, of all series around its points.
  std::function<Vector<BallPolynomial>(std::size_t segment, const RealBall& t, long length,
                                       long bits)>
      position;
};

/// Of such a curve.
CurveSeries series_of(const Path& path);

}  // namespace phrame
