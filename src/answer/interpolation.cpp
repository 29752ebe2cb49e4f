#include "phrame/answer/interpolation.hpp"

#include <fmt/format.h>

#include <cmath>

#include "phrame/algebra/as_written.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/algebra/progress.hpp"
#include "phrame/answer/near_rows.hpp"
#include "phrame/answer/table_row.hpp"
#include "phrame/ph/along/travel_time.hpp"

namespace phrame::inline v0 {

void require_few_rows(const InterpolationQuery& query, const Integer& ticks) {
  if (const Integer rows = ticks + 1; rows > query.most_rows)
    throw InputError(fmt::format("{} asks for {} rows, the limit is {}", as_written(query.period),
                                 abbreviated(rows.str()), query.most_rows));
}

namespace {

/// Rows of a motion with a constant speed by compiled polynomials, where the points are so many
/// that it pays.
class NearPoints {
 public:
  NearPoints(const Path& path, const InterpolationQuery& query, const Integer& ticks)
      : period_(query.period) {
    const RationalFunction& V = query.feedrate.speed;
    if (!query.feedrate.is_rational()) return;
    if (!V.numerator().is_constant() || !V.denominator().is_constant()) return;
    const auto rows = static_cast<std::size_t>(static_cast<long>(ticks));
    if (!are_many_rows(rows, path, true, [&] { return angle_to(std::nullopt, path); })) return;
    speed_ = V.numerator().coefficient(0) / V.denominator().coefficient(0);
    length_ = where_compiled([&] { return CompiledLength(path); });
    points_ = where_compiled([&] { return CompiledPoints(path); });
  }

  /// Row k, where doubles are enough for it.
  std::optional<std::vector<double>> row(const Integer& k) const {
    if (!length_ || !points_) return std::nullopt;
    return rounding_to_nearest([&]() -> std::optional<std::vector<double>> {
      const Rational time = Rational(k) * period_;
      const NearNumber s = near_number(time * speed_);
      const auto t = length_->parameter(s);
      const auto r = t ? points_->rounded(*t) : std::nullopt;
      if (!r) return std::nullopt;
      std::vector<double> row{round_to_double(Rational(k))};
      for (const NearNumber& x : {near_number(time), *t, s}) {
        const auto rounded = common_double(x);
        if (!rounded || !std::isfinite(*rounded)) return std::nullopt;
        row.push_back(*rounded);
      }
      row.insert(row.end(), r->begin(), r->end());
      return row;
    });
  }

 private:
  Rational period_;
  Rational speed_;
  std::optional<CompiledLength> length_;
  std::optional<CompiledPoints> points_;
};

}  // namespace

FrameTable answer(const NamedPath& named, const InterpolationQuery& query) {
  const Path& path = named.path;
  TravelTime time(path, query.feedrate);
  const Integer ticks = time.ticks(query.period);
  require_few_rows(query, ticks);
  FrameTable table{
      {"k", "time", "t", "s", "x", "y", "z"}, {}, "interpolation/1", 0, {}, named.near};
  if (!query.feedrate.is_rational()) table.columns.emplace_back("v");
  const auto append = [&](const Integer& k, const Real& at, const TravelTime::Point& point) {
    std::vector<double> row{round_to_double(Rational(k)), round_to_double(at),
                            round_to_double(parameter(point.at)),
                            round_to_double(point.arc_length)};
    for (const Real& x : position(path, point.at)) row.push_back(round_to_double(x));
    if (point.speed) row.push_back(round_to_double(*point.speed));
    add_row(table, std::move(row), [&k] { return "point " + k.str(); });
  };
  Stage stage("rows", static_cast<std::size_t>(static_cast<long>(ticks)));
  const NearPoints near(path, query, ticks);
  for (Integer k = 0; k < ticks; ++k) {
    stage.advance();
    if (auto row = near.row(k)) {
      table.rows.push_back(std::move(*row));
      continue;
    }
    const Rational at = Rational(k) * query.period;
    append(k, at, time.at_time(at));
  }
  append(ticks, time.total(), time.end());
  return table;
}

}  // namespace phrame
