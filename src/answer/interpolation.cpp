#include "phrame/answer/interpolation.hpp"

#include "phrame/ph/curve/arc_length.hpp"

namespace phrame {

FrameTable interpolation_table(const Curve& curve, TravelTime& time, const Rational& period) {
  FrameTable table{{"k", "time", "t", "s", "x", "y", "z"}, {}, "interpolation/1"};
  const Vector<Polynomial> r = position(curve);
  const Polynomial s = ArcLength(curve).polynomial();
  const auto append = [&](const Integer& k, const Real& at, const TimedPoint& point) {
    std::vector<double> row{round_to_double(Rational(k)), round_to_double(at),
                            round_to_double(point.parameter), round_to_double(point.value(s))};
    for (const Polynomial& x : r) row.push_back(round_to_double(point.value(x)));
    add_row(table, std::move(row), [&k] { return "point " + k.str(); });
  };
  const Integer ticks = time.ticks(period);
  for (Integer k = 0; k < ticks; ++k) {
    const Rational at = Rational(k) * period;
    append(k, at, time.at_time(at));
  }
  append(ticks, time.total(), {Rational(1), AlgebraicPoint(Rational(1))});
  return table;
}

}  // namespace phrame
