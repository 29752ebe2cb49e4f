#include "phrame/answer/smooth_table.hpp"

#include <fmt/format.h>

#include <limits>

#include "phrame/algebra/error.hpp"
#include "phrame/algebra/progress.hpp"
#include "phrame/answer/orientation_columns.hpp"
#include "phrame/ph/along/path_length.hpp"
#include "phrame/ph/along/smooth_shape.hpp"
#include "phrame/ph/frame/path_frame.hpp"

namespace phrame {
namespace {

/// √(x² + y²).
Real size_of(const Real& x, const Real& y) {
  return Real([square = x * x + y * y](long bits) {
    return sqrt_of_nonnegative(square.enclose(bits), bits);
  });
}

void add_rounded(std::vector<double>& row, const Vector<Real>& v) {
  const Vector<double> values = round_to_double(v);
  row.insert(row.end(), values.begin(), values.end());
}

void require_columns(const TableColumns& columns, bool has_twist) {
  for (const TabulatedFrame frame : columns.frames)
    if (frame == TabulatedFrame::mtf || (frame == TabulatedFrame::exact_mtf && !has_twist))
      throw DomainError("frame mtf: only Pythagorean-hodograph curves have it");
}

class SmoothRows {
 public:
  SmoothRows(const PathAngle& angle, const TableColumns& columns,
             const std::optional<SmoothTwist>& twist)
      : columns_(columns),
        orientations_(columns),
        angle_(angle),
        twist_(twist),
        start_(start_angle(columns.start, angle_)) {}

  std::vector<double> at(const Place& at);
  const std::string& reason() const { return reason_; }

 private:
  template <class Add>
  void add_if_defined(std::vector<double>& row, std::size_t count, Add add);
  Frame<Real> frame(TabulatedFrame kind, const Place& at) const;
  Real scalar(TabulatedScalar kind, const Place& at);

  const TableColumns& columns_;
  OrientationColumns orientations_;
  PathAngle angle_;
  const std::optional<SmoothTwist>& twist_;
  std::optional<PathLength> length_;
  StartAngle start_;
  std::string reason_;  ///< why the last row has empty cells
};

template <class Add>
void SmoothRows::add_if_defined(std::vector<double>& row, std::size_t count, Add add) {
  const std::size_t before = row.size();
  try {
    add();
  } catch (const DomainError& error) {
    if (!columns_.may_be_empty) throw;
    row.resize(before);
    row.resize(before + count, std::numeric_limits<double>::quiet_NaN());
    if (reason_.empty()) reason_ = error.what();
  }
}

Frame<Real> SmoothRows::frame(TabulatedFrame kind, const Place& at) const {
  if (kind == TabulatedFrame::rmf) return rotation_minimizing_frame(angle_, at, start_);
  if (kind == TabulatedFrame::exact_mtf) return minimal_twist_frame(*twist_, at);
  if (kind == TabulatedFrame::euler_rodrigues) return euler_rodrigues_frame(angle_.path(), at);
  if (kind == TabulatedFrame::frenet) return frenet_frame(angle_.path(), at);
  return up_frame(angle_.path(), angle_.up(), at);
}

Real SmoothRows::scalar(TabulatedScalar kind, const Place& at) {
  const Path& path = angle_.path();
  switch (kind) {
    case TabulatedScalar::arc_length:
      if (!length_) length_.emplace(path);
      return length_->value(at);
    case TabulatedScalar::curvature:
      return curvature(path, at);
    case TabulatedScalar::torsion:
      return torsion(path, at);
    case TabulatedScalar::frenet_rate:
      break;
  }
  return size_of(curvature(path, at), torsion(path, at));
}

std::vector<double> SmoothRows::at(const Place& at) {
  reason_.clear();
  const Rational before(static_cast<long>(at.segment));
  std::vector<double> row{round_to_double(at.t + before)};
  add_rounded(row, position(angle_.path(), at));
  add_rounded(row, up_frame(angle_.path(), angle_.up(), at).e1);
  for (const TabulatedFrame kind : columns_.frames)
    add_if_defined(row, orientations_.width(),
                   [&] { orientations_.add(row, kind, frame(kind, at)); });
  for (const TabulatedScalar kind : columns_.scalars)
    add_if_defined(row, 1, [&] { row.push_back(round_to_double(scalar(kind, at))); });
  return row;
}

}  // namespace

FrameTable frame_table(const PathAngle& angle, const TableColumns& columns,
                       const std::vector<Place>& at, const std::optional<SmoothTwist>& twist) {
  require_columns(columns, twist.has_value());
  SmoothRows rows(angle, columns, twist);
  FrameTable table{names_of(columns), {}};
  const bool has_rmf = has_frame(columns, TabulatedFrame::rmf);
  if (has_rmf) table.start = columns.start;
  if (has_frame(columns, TabulatedFrame::up) ||
      (has_rmf && std::holds_alternative<Angle>(columns.start)))
    table.up = angle.up();
  Stage stage("rows", at.size());
  for (const Place& point : at) {
    stage.advance();
    add_row(table, rows.at(point), [&] { return fmt::format("row {}", table.rows.size()); });
    if (rows.reason().empty()) continue;
    if (++table.incomplete_rows == 1) table.first_reason = rows.reason();
  }
  return table;
}

}  // namespace phrame
