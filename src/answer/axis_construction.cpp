#include "phrame/answer/axis_construction.hpp"

#include <fmt/format.h>

#include "phrame/algebra/as_written.hpp"
#include "phrame/algebra/error.hpp"

namespace phrame::inline v0 {

AxisConstructionAnswer answer(const GivenPoints& given, const AxisConstructionQuery& query) {
  if (given.poses) throw InputError("the kind minkowski takes no orientations");
  if (!given.accelerations.empty())
    throw InputError("/accelerations", "the kind minkowski takes points and derivatives only");
  if (given.is_planar) throw InputError("/points", "the kind minkowski wants points x, y, r");
  for (std::size_t k = 0; k < given.points.size(); ++k)
    if (given.points[k][2] < 0)
      throw InputError(
          fmt::format("the radius at point {} is {}", k + 1, as_written(given.points[k][2])));
  HermiteSpline data = hermite_spline(given, false);
  const Deviation tolerance{query.tolerance * size_of_points(data),
                            query.tolerance * size_of_derivatives(data)};
  MinkowskiSpline found = minkowski_spline(data, tolerance);
  AxisConstructionAnswer answer{{given.name, std::move(found.axis)},
                                {},
                                std::move(data),
                                derivative_source(given, false),
                                parameter_source(given),
                                tolerance,
                                found.deviation};
  for (const MinkowskiCurve& curve : answer.axis.segments) {
    answer.lightlike.emplace_back();
    for (const RealRoot& root :
         real_roots(curve.multiplier * spacelike_root(curve), closed_interval(0, 1)))
      answer.lightlike.back().push_back(root.at);
  }
  return answer;
}

}  // namespace phrame
