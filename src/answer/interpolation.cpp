#include "phrame/answer/interpolation.hpp"

#include <fmt/format.h>

#include "phrame/algebra/as_written.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/algebra/progress.hpp"
#include "phrame/answer/table_row.hpp"
#include "phrame/ph/along/travel_time.hpp"

namespace phrame {

void require_few_rows(const InterpolationQuery& query, const Integer& ticks) {
  if (const Integer rows = ticks + 1; rows > query.most_rows)
    throw InputError(fmt::format("{} asks for {} rows, the limit is {}", as_written(query.period),
                                 abbreviated(rows.str()), query.most_rows));
}

FrameTable answer(const NamedPath& named, const InterpolationQuery& query) {
  const Path& path = named.path;
  TravelTime time(path, query.feedrate);
  const Integer ticks = time.ticks(query.period);
  require_few_rows(query, ticks);
  FrameTable table{
      {"k", "time", "t", "s", "x", "y", "z"}, {}, "interpolation/1", 0, {}, named.near};
  const auto append = [&](const Integer& k, const Real& at, const TravelTime::Point& point) {
    std::vector<double> row{round_to_double(Rational(k)), round_to_double(at),
                            round_to_double(parameter(point.at)),
                            round_to_double(point.arc_length)};
    for (const Real& x : position(path, point.at)) row.push_back(round_to_double(x));
    add_row(table, std::move(row), [&k] { return "point " + k.str(); });
  };
  Stage stage("rows", static_cast<std::size_t>(static_cast<long>(ticks)));
  for (Integer k = 0; k < ticks; ++k) {
    const Rational at = Rational(k) * query.period;
    append(k, at, time.at_time(at));
    stage.advance();
  }
  append(ticks, time.total(), time.end());
  return table;
}

}  // namespace phrame
