#include "phrame/ph/offset/turning_place.hpp"

#include "phrame/algebra/eliminant.hpp"
#include "phrame/ph/curve/special_points.hpp"
#include "phrame/ph/curve/vector.hpp"
#include "phrame/ph/offset/coincidence.hpp"

namespace phrame::inline v0 {
namespace {

/// A polynomial in s that is 0 where a curve is on d·U about the point of the path at t; 0 where it
/// is that all along.
Polynomial gap_from(const RationalCurve& curve, const RationalCurve& path, const RealAlgebraic& t,
                    const Rational& d, const GaugeForm& form) {
  const QuotientRing field(t.polynomial());
  std::vector<Polynomial> weights;
  for (const Rational& c : curve.weight().coefficients()) weights.push_back(d * c * path.weight());
  const Bivariate gap = swapped(field.reduce(form(field.reduce(meeting_gap(path, curve, 0)),
                                                  field.reduce(meeting_gap(path, curve, 1)),
                                                  field.reduce(Bivariate(weights)))));
  if (gap.degree() <= 0) return gap.coefficient(0);
  return eliminant(gap, swapped(Bivariate({t.polynomial()})));
}

}  // namespace

std::vector<BoundaryEvent> events_at_turns(const std::vector<RationalCurve>& path,
                                           const Offset& offset, const GaugeForm& form) {
  std::vector<BoundaryEvent> events;
  for (const RationalCurve& of : path)
    for (const RealAlgebraic& t : sign_changes(of.multiplier()))
      for (std::size_t k = 0; k < offset.pieces.size(); ++k) {
        const RationalCurve& curve = offset.pieces[k].curve;
        const Polynomial gap = gap_from(curve, of, t, offset.distance, form);
        if (gap.is_zero()) continue;
        for (const RealRoot& root : real_roots(gap, closed_interval(0, 1)))
          events.push_back({k, root.at});
      }
  return events;
}

}  // namespace phrame
