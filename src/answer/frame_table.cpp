#include "phrame/answer/frame_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/progress.hpp"
#include "phrame/answer/frame_rows.hpp"
#include "phrame/answer/orientation_columns.hpp"
#include "phrame/answer/rounded.hpp"
#include "phrame/answer/table_row.hpp"

namespace phrame::inline v0 {
constexpr std::array scalar_names{"s",
                                  "curvature",
                                  "torsion",
                                  "frenet_rate",
                                  "k1",
                                  "k2",
                                  "omega_x",
                                  "omega_y",
                                  "omega_z",
                                  "signed_curvature",
                                  "twist_rate",
                                  "twist_omega_x",
                                  "twist_omega_y",
                                  "twist_omega_z",
                                  "twist_alpha_x",
                                  "twist_alpha_y",
                                  "twist_alpha_z"};
static_assert(scalar_names.size() == static_cast<std::size_t>(TabulatedScalar::twist_alpha_z) + 1);

const char* name_of(TabulatedScalar kind) { return scalar_names[static_cast<std::size_t>(kind)]; }

bool has_frame(const TableColumns& columns, TabulatedFrame frame) {
  return std::find(columns.frames.begin(), columns.frames.end(), frame) != columns.frames.end();
}

std::vector<std::string> names_of(const TableColumns& columns) {
  std::vector<std::string> names{"t", "x", "y", "z", "e1x", "e1y", "e1z"};
  for (const TabulatedFrame frame : columns.frames) add_names(names, frame, columns);
  for (const TabulatedScalar kind : columns.scalars) names.emplace_back(name_of(kind));
  return names;
}

void TableRow::add(const Real& x) {
  values.push_back(round_to_double(x));
  if (digits > 0) decimals.push_back(rounded_or_zero(x, "a number", digits).value);
}

void TableRow::add(const Vector<Real>& v) {
  for (const Real& x : v) add(x);
}

void TableRow::add_empty(std::size_t count) {
  values.resize(values.size() + count, std::numeric_limits<double>::quiet_NaN());
  if (digits > 0) decimals.resize(values.size());
}

void TableRow::resize(std::size_t count) {
  values.resize(count);
  if (digits > 0) decimals.resize(count);
}

void require_finite(const std::vector<std::string>& columns, const std::vector<double>& row,
                    const std::function<std::string()>& place) {
  for (std::size_t k = 0; k < row.size(); ++k)
    if (std::isinf(row[k]))
      throw InputError(place(), columns[k] + " does not fit a double, of at most 1.8e308");
}

void add_row(FrameTable& table, std::vector<double> row,
             const std::function<std::string()>& place) {
  require_finite(table.columns, row, place);
  table.rows.push_back(std::move(row));
}

void add_column(FrameTable& table, const std::string& name, const std::vector<Real>& numbers,
                long digits) {
  if (std::find(table.columns.begin(), table.columns.end(), name) != table.columns.end()) return;
  table.columns.push_back(name);
  for (std::size_t k = 0; k < numbers.size(); ++k) {
    TableRow cell{.digits = digits};
    cell.add(numbers[k]);
    table.rows[k].push_back(cell.values.front());
    if (digits > 0) table.decimals[k].push_back(cell.decimals.front());
  }
}

FrameTable frame_table(FrameRows& rows) {
  FrameTable table = rows.empty_table();
  Stage stage("rows", rows.size());
  table.rows.resize(rows.size());
  std::size_t done = 0;
  for (std::size_t first = 0; first < rows.size(); first += FrameRows::block) {
    const std::size_t count = std::min(FrameRows::block, rows.size() - first);
    for (const std::size_t k : rows.near(first, std::span(table.rows).subspan(first, count))) {
      for (; done <= k; ++done) stage.advance();
      TableRow row = rows.exact(k);
      if (row.digits > 0) table.decimals.push_back(std::move(row.decimals));
      table.rows[k] = std::move(row.values);
      if (rows.reason().empty()) continue;
      if (++table.incomplete_rows == 1) table.first_reason = rows.reason();
    }
  }
  return table;
}

FrameTable frame_table(const PathAngle& angle, const TableColumns& columns,
                       const std::vector<Place>& at) {
  FrameRows rows(angle, columns, RowPlaces(at));
  return frame_table(rows);
}

FrameTable frame_table(const Curve& curve, const TableColumns& columns,
                       const std::vector<RealAlgebraic>& at) {
  std::vector<Place> points;
  for (const RealAlgebraic& t : at) points.emplace_back(0, t);
  return frame_table(PathAngle(Path(curve)), columns, points);
}

FrameTable frame_table(const Curve& curve, const std::vector<TabulatedFrame>& frames,
                       const std::vector<Rational>& at) {
  return frame_table(curve, TableColumns{frames}, std::vector<RealAlgebraic>(at.begin(), at.end()));
}

}  // namespace phrame
