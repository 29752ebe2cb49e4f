#pragma once
#include "phrame/answer/frame_rows.hpp"
#include "phrame/io/write/row_format.hpp"

namespace phrame::inline v0::cli {

/// What write_rows() has written.
struct WrittenRows {
  std::size_t incomplete = 0;  ///< so many rows have empty cells
  std::string first_reason;    ///< why the first of these has
};

/// Writes all rows to an output, in blocks, on all cores. Nothing is written before it is seen that
/// all rows are there: for that they are computed twice, which costs less than to keep them, but
/// for those that doubles are not enough for, which are kept. Throws what FrameRows::exact()
/// throws, for the first row that is not there.
WrittenRows write_rows(const std::string& output, FrameRows& rows, const RowFormat& format);

}  // namespace phrame::cli
