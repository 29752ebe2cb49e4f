#pragma once
#include <map>

#include "phrame/answer/frame_table.hpp"
#include "phrame/answer/table_row.hpp"

namespace phrame::inline v0 {

/// Writes what a table has of one frame into its rows, one row after the other: two vectors, the
/// quaternion, the matrix.
class OrientationColumns {
 public:
  /// As they are asked for.
  explicit OrientationColumns(const TableColumns& columns)
      : have_quaternions_(columns.have_quaternions),
        have_matrices_(columns.have_matrices),
        camera_(columns.are_cameras ? std::optional(TangentAxis{2, true}) : std::nullopt),
        body_(columns.body) {}

  /// So many numbers.
  std::size_t width() const;
  /// Appends them to a row that begins with t, r, e₁.
  void add(TableRow& row, TabulatedFrame kind, const Frame<Real>& frame);
  /// The same of correctly rounded vectors. Precondition: there are no quaternions.
  void add(std::vector<double>& row, const Frame<double>& frame) const;

 private:
  void add_quaternion(TableRow& row, TabulatedFrame kind, const Frame<Real>& frame);

  bool have_quaternions_;
  bool have_matrices_;
  /// Which axis of the body is the tangent.
  TangentAxis axis_of(TabulatedFrame kind) const {
    const bool is_of_body = kind == TabulatedFrame::exact_mtf || kind == TabulatedFrame::mtf;
    return camera_.value_or(is_of_body ? body_ : TangentAxis());
  }

  std::optional<TangentAxis> camera_;  ///< x to the right, y up along f₂, and z to the back
  TangentAxis body_;
  std::map<TabulatedFrame, std::array<double, 4>> last_;  ///< the quaternions of the last row
};

/// Appends the names of such columns.
void add_names(std::vector<std::string>& names, TabulatedFrame kind, const TableColumns& columns);

}  // namespace phrame
