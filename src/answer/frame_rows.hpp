#pragma once
#include <memory>
#include <span>

#include "phrame/answer/frame_table.hpp"
#include "phrame/answer/row_places.hpp"
#include "phrame/answer/table_row.hpp"

namespace phrame::inline v0 {

/// The rows of a frame_table(), one by one.
class FrameRows {
 public:
  /// The columns have to outlive it. Throws what frame_table() throws for them.
  FrameRows(const PathAngle& angle, const TableColumns& columns, RowPlaces places);
  FrameRows(const FrameRows&) = delete;
  FrameRows& operator=(const FrameRows&) = delete;
  ~FrameRows();

  /// So many.
  std::size_t size() const;
  /// The table without rows.
  const FrameTable& empty_table() const { return empty_; }
  /// Makes `rows` those from number `first` on, where doubles are enough for that: nearly always,
  /// in tables of many rows, which are the only ones of which it is tried. The numbers of those for
  /// which they are not, ascending; what is in them then is no matter. Any thread may ask.
  std::vector<std::size_t> near(std::size_t first, std::span<std::vector<double>> rows) const;
  /// So many at once cost a fifth of what they cost one by one.
  static constexpr std::size_t block = 1024;
  /// The same numbers, of so many rows, without these.
  std::vector<std::size_t> not_near(std::size_t first, std::size_t count) const;
  /// Row k. Throws what frame_table() throws for it.
  TableRow exact(std::size_t k);
  /// Why the last exact row has empty cells; nothing where it has none.
  const std::string& reason() const;

 private:
  struct Scalar;
  class State;
  std::unique_ptr<State> state_;
  FrameTable empty_;
};

}  // namespace phrame
