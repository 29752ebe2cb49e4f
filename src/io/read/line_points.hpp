#pragma once
#include "phrame/io/read/number.hpp"
#include "phrame/io/read/number_table.hpp"

namespace phrame::inline v0 {

/// A point that stands in a line of a file.
struct LinePoint {
  Vector<Rational> point;
  long line;
};

/// Such points as rows.
class LinePoints : public NumberTable {
 public:
  explicit LinePoints(std::vector<LinePoint> points) : points_(std::move(points)) {
    names_ = {"x", "y", "z"};
  }

  std::string header_place() const override { return place(0); }
  std::size_t rows() const override { return points_.size(); }
  std::size_t columns() const override { return 3; }
  std::string place(std::size_t row) const override { return line_place(points_[row].line); }
  using NumberTable::number;
  Rational number(std::size_t row, std::size_t column) const override {
    return points_[row].point[column];
  }
  bool is_missing(std::size_t, std::size_t) const override { return false; }

 private:
  std::vector<LinePoint> points_;
};

}  // namespace phrame
