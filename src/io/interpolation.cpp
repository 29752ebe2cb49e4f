#include "phrame/io/interpolation.hpp"

#include <fmt/format.h>

#include <cmath>

#include "phrame/algebra/error.hpp"
#include "phrame/ph/arc_length.hpp"

namespace phrame {

FrameTable interpolation_table(const Curve& curve, TravelTime& time, const Rational& period) {
  FrameTable table{{"k", "time", "t", "s", "x", "y", "z"}, {}, "interpolation/1"};
  const Vector<Polynomial> r = position(curve);
  const Polynomial s = ArcLength(curve).polynomial();
  const auto add_row = [&](const Integer& k, const Real& at, const TimedPoint& point) {
    std::vector<double> row{round_to_double(Rational(k)), round_to_double(at),
                            round_to_double(point.parameter), round_to_double(point.value(s))};
    for (const Polynomial& x : r) row.push_back(round_to_double(point.value(x)));
    for (std::size_t column = 0; column < row.size(); ++column)
      if (!std::isfinite(row[column]))
        throw InputError(fmt::format("point {}", k.str()),
                         table.columns[column] + " does not fit a double, of at most 1.8e308");
    table.rows.push_back(std::move(row));
  };
  const Integer ticks = time.ticks(period);
  for (Integer k = 0; k < ticks; ++k) {
    const Rational at = Rational(k) * period;
    add_row(k, at, time.at_time(at));
  }
  add_row(ticks, time.total(), {Rational(1), AlgebraicPoint(Rational(1))});
  return table;
}

}  // namespace phrame
