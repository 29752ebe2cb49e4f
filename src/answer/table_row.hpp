#pragma once
#include <functional>
#include <string>
#include <vector>

#include "phrame/answer/frame_table.hpp"

namespace phrame::inline v0 {

/// What its column is called.
const char* name_of(TabulatedScalar kind);
/// Is that one of its frames?
bool has_frame(const TableColumns& columns, TabulatedFrame frame);

/// One row while it grows.
struct TableRow {
  std::vector<double> values = {};  ///< rounded
  long digits = 0;                  ///< of the decimals; 0 for none
  std::vector<std::string> decimals = {};

  void add(const Real& x);  ///< appends it, correctly rounded
  void add(const Vector<Real>& v);
  void add_empty(std::size_t count);  ///< so many empty cells
  void resize(std::size_t count);     ///< leaves out what is behind
};

/// @{ Throws InputError where a number has been rounded to infinity, which is no answer; `place`
/// says of what the row is. The second adds it to the table.
void require_finite(const std::vector<std::string>& columns, const std::vector<double>& row,
                    const std::function<std::string()>& place);
void add_row(FrameTable& table, std::vector<double> row, const std::function<std::string()>& place);
/// @}

}  // namespace phrame
