#pragma once
#include <functional>
#include <memory>

#include "phrame/io/read/file_reading.hpp"
#include "phrame/io/read/number_table.hpp"
#include "phrame/ph/construct/given_points.hpp"

namespace phrame::inline v0 {

/// A table of points: what was read of it, a row a point.
struct PointTable {
  std::unique_ptr<NumberTable> table;
  GivenPoints given;
};

/// The points of a table (read_points), of which rows are left out where that is asked for.
/// Coordinates may have other names than x, y and z (position_column), all of one kind; where the
/// units of the three differ, they are refused. Without names, 8 columns are a time, a position and
/// a quaternion, 12 and 16 are matrices (matrix_columns).
PointTable read_point_rows(std::unique_ptr<NumberTable> table, const FileReading& reading);

/// Does one of the names say which column is x?
bool names_positions(const std::vector<std::string>& names);

/// What no format may have: tangents that are 0, parameters that do not increase, points that are
/// those before them. `place` is that of the k-th entry of a list, of "points", 3 of the fourth
/// point; `advice` is what helps against a point that is that before it. Throws InputError.
void require_meaning(const GivenPoints& given,
                     const std::function<std::string(std::string_view list, std::size_t k)>& place,
                     std::string_view advice = {});

/// Of a table that is read from bytes, whose header may be a comment that says which column is x.
PointTable read_points_of_table(std::string_view bytes, const FileReading& reading);

/// The numbers of the column with that name of such a table, a row for each point. Throws
/// InputError where there is none.
std::vector<Rational> read_column(std::string_view bytes, const std::string& name,
                                  const FileReading& reading);

}  // namespace phrame
