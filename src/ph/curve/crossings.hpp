#pragma once
#include <optional>
#include <vector>

#include "phrame/ph/curve/curve_series.hpp"

namespace phrame {

/// Two places of curves that a projection along v lays over each other.
struct Crossing {
  std::size_t first_segment;   ///< of the first curve
  RealBall first_t;            ///< the parameter there
  std::size_t second_segment;  ///< of the second curve, or of the same one
  RealBall second_t;           ///< the parameter there
  int sign;                    ///< that of det(r′(first), r′(second), r(first) − r(second))
};

/// All crossings, each once: that each of these is one, and that there are no others, is proved,
/// by Newton's method in intervals on pairs of arcs [Moore, Krawczyk]. Closed curves are meant,
/// which may have corners. No value where that is not decided within arcs of 2^−30 of a segment:
/// where the projection touches itself, has a cusp or has a crossing at an end of an arc, so that
/// another v is to be tried; or where the curve meets itself, or nearly so.
std::optional<std::vector<Crossing>> self_crossings(const CurveSeries& curve,
                                                    const Vector<Rational>& v);
/// The crossings of one curve with another, likewise.
std::optional<std::vector<Crossing>> mutual_crossings(const CurveSeries& first,
                                                      const CurveSeries& second,
                                                      const Vector<Rational>& v);

/// The sum of the signs: for a curve with itself the linking number of the curve with its copy
/// shifted along v, and for two curves twice their linking number.
long sum_of_signs(const std::vector<Crossing>& crossings);

}  // namespace phrame
